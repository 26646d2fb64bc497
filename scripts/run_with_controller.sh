#!/usr/bin/env bash
# Install and build what is needed, start the controller of a case, let the case run
# beside it on two ranks, and write tables and plots to results/CASE:
#
#   scripts/run_with_controller.sh CASE [ARGUMENTS]
#
# with a folder of parameters/ that has a controller.py and a case.prm whose muscles
# have the address CASE.sock. With arguments, as --set NAME=VALUE, the run has these.
source "$(dirname "${BASH_SOURCE[0]}")/environment.sh"

name=${1:?"usage: scripts/run_with_controller.sh CASE [ARGUMENTS]"}
install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python >&2
build Release >&2
results="$repository/results/$name"
address="$name.sock"
# Where the run looks for the address that the case names.
cd "$repository"
# Left by a controller that was killed, it would look as if there were one.
rm -f "$address"
"$python" "parameters/$name/controller.py" "$address" &
controller=$!
# A run that does not begin never asks, and the controller would wait for ever.
trap 'kill "$controller" 2>/dev/null || true; rm -f "$address"' EXIT
while [[ ! -S $address ]]; do
  kill -0 "$controller"
  sleep 0.1
done
mpirun -np 2 build-Release/lumbricus "parameters/$name/case.prm" \
  --output "$results" "${@:2}"
wait "$controller"
scripts/lumbricus-plot "$results"
