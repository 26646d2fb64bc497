#!/usr/bin/env bash
# Build Debug and Release and run all tests, on one and more ranks.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

install_missing "${build_packages[@]}" "${test_packages[@]}"
build Release -DLUMBRICUS_WERROR=ON
build Debug -DLUMBRICUS_WERROR=ON
export CTEST_OUTPUT_ON_FAILURE=1
(cd "$repository/build-Debug" && ctest -L debug)
(cd "$repository/build-Release" && ctest)
