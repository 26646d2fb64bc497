#!/usr/bin/env bash
# Build Release and run the main job on all cores: ten segments through one
# peristaltic wave. Results and pictures go to results/peristalsis.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python
build Release
cd "$repository"
mpirun -np "$cores" build-Release/lumbricus parameters/peristalsis/case.prm \
  --output results/peristalsis
"$python" scripts/lumbricus-plot results/peristalsis
