#!/usr/bin/env bash
# Install and build what is needed, let the whole worm crawl for the length of one
# wave on two ranks, and write tables, plots and the animation to
# results/whole_worm. With arguments, as --set NAME=VALUE, the run has these.
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/environment.sh"

install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python >&2
build Release >&2
results="$repository/results/whole_worm"
# The case names its table of measures from the top folder.
cd "$repository"
mpirun -np 2 build-Release/lumbricus parameters/whole_worm/case.prm \
  --output "$results" "$@"
"$python" parameters/whole_worm/measured.py "$results"
scripts/lumbricus-plot "$results" --frames 100
