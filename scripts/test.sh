#!/usr/bin/env bash
# Build Debug and Release and run all tests, on one and more ranks.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
# The Python that the packages above are for.
options=(-DLUMBRICUS_WERROR=ON -DPython3_EXECUTABLE=/usr/bin/python3)
build Release "${options[@]}"
build Debug "${options[@]}"
export CTEST_OUTPUT_ON_FAILURE=1
# Where this is set the program does not start itself anew to set it; the tests
# are many short runs.
export OPENBLAS_CORETYPE=
(cd "$repository/build-Debug" && ctest -L debug -j "$cores")
(cd "$repository/build-Release" && ctest -j "$cores")
