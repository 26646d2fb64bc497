#!/usr/bin/env bash
# Install and build what is needed, start the controller, let the case run beside it
# on two ranks, and write tables and plots to results/oscillators. With arguments, as
# --set NAME=VALUE, the run has these.
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/environment.sh"

install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python >&2
build Release >&2
results="$repository/results/oscillators"
address="oscillators.sock"
# Where the run looks for the address that the case names.
cd "$repository"
"$python" "parameters/oscillators/controller.py" "$address" &
while [[ ! -S $address ]]; do
  kill -0 $!
  sleep 0.1
done
mpirun -np 2 build-Release/lumbricus parameters/oscillators/case.prm \
  --output "$results" "$@"
wait
scripts/lumbricus-plot "$results"
