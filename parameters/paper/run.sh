#!/usr/bin/env bash
# Install and build what is needed, run all the paper's experiments on two ranks,
# and write one table of paper, closed form and program, and all diagrams, to
# results/paper. About three minutes on two cores.
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/environment.sh"

install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python >&2
build Release >&2
export LUMBRICUS="$repository/build-Release/lumbricus"
exec "$python" "$repository/parameters/paper/report.py" \
  "$repository/results/paper"
