#!/usr/bin/env bash
# Build Release and run a benchmark, a folder beside this script:
#
#   benchmarks/run.sh NAME [ARGUMENTS]
#
# It prints its table as Markdown; the runs themselves go to results/NAME.
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/environment.sh"

name=${1:?"usage: benchmarks/run.sh NAME, one of: $(cd "$repository/benchmarks" && echo */)"}
install_missing "${build_packages[@]}" "${python_packages[@]}"
set_up_python >&2
build Release >&2
export LUMBRICUS="$repository/build-Release/lumbricus" MPIRUN=mpirun
export PYTHONPATH="$repository/tests" PYTHONDONTWRITEBYTECODE=1
mkdir -p "$repository/results/$name"
cd "$repository/results/$name"
exec "$python" "$repository/benchmarks/$name/benchmark.py" "${@:2}"
