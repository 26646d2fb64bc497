#!/usr/bin/env bash
# Build Debug and Release and run all tests, on one and more ranks.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

install_missing "${build_packages[@]}" "${python_packages[@]}" \
  "${test_packages[@]}"
set_up_python
options=(-DLUMBRICUS_WERROR=ON -DPython3_EXECUTABLE="$python")
build Release all "${options[@]}"
build Debug debug_tests "${options[@]}"
export CTEST_OUTPUT_ON_FAILURE=1
# Where this is set the program does not start itself anew to set it; the tests
# are many short runs.
export OPENBLAS_CORETYPE=
# One more than there are cores: a test also waits, for processes that start and
# end and for the disk.
jobs=$((cores + 1))
(cd "$repository/build-Debug" && ctest -L debug -j "$jobs")
(cd "$repository/build-Release" && ctest -j "$jobs")
