#!/usr/bin/env bash
# Install what scripts/lumbricus-plot needs, for a program that was built without
# main_job.sh or test.sh.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

install_missing "${python_packages[@]}"
set_up_python
