# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time that parameters/block_compression takes, here and with other programs, on
two cores: ten load steps from making the mesh on, one program after the other, each
with its direct solver. All have to find the same displacements. The others run where
they are installed:

    apt-get install python3-dolfinx
    python3 -m venv results/reese/ngsolve
    results/reese/ngsolve/bin/pip install ngsolve mkl

--cells 16 takes minutes; --set goes to Lumbricus, to try solvers."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

from lumbricus_run import SOURCE, run_well

HERE = pathlib.Path(__file__).resolve().parent
CASE = SOURCE / "parameters" / "block_compression" / "case.prm"
N_RANKS = 2
# Relative to the largest displacement.
TOLERANCE = 1e-6


def lumbricus(n, settings):
    result = run_well(CASE, f"lumbricus-{n}",
                      [f"Geometry/block/Cells={n}, {n}, {n}",
                       "Newton/Volume tolerance=1e-9",
                       "Newton/Predictor order=2",
                       "Output/Every=0"] + settings, ranks=N_RANKS)
    steps = result.steps()
    points = [row["uz"] for row in result.table("points.csv") if row["t"] > 0]
    n_points = len(points) // len(steps)
    return {"seconds": steps[-1]["elapsed_seconds"],
            "unknowns": int(re.search(r"(\d+) unknowns", result.log).group(1)),
            "newton_iterations": int(sum(row["newton_iterations"]
                                         for row in steps)),
            "displacements": [points[i:i + n_points] for i in
                              range(0, len(points), n_points)]}


def other(command):
    """The report of a script beside this one."""
    process = subprocess.run(
        command, capture_output=True, text=True,
        env={**os.environ, "MKL_NUM_THREADS": str(N_RANKS)})
    if process.returncode != 0:
        raise SystemExit(process.stdout + process.stderr)
    return json.loads(process.stdout.splitlines()[-1])


def dolfinx(n, _):
    return other([os.environ["MPIRUN"], "-np", str(N_RANKS), "/usr/bin/python3",
                  str(HERE / "dolfinx_block.py"), str(n)])


def ngsolve(n, _):
    return other(["ngsolve/bin/python", str(HERE / "ngsolve_block.py"), str(n)])


def can_import(python, module):
    return pathlib.Path(python).exists() and subprocess.run(
        [python, "-c", f"import {module}"], capture_output=True).returncode == 0


def programs():
    """The programs that are installed; this one first."""
    found = {"Lumbricus": lumbricus}
    for name, solve, python, module in (
            ("dolfinx", dolfinx, "/usr/bin/python3", "dolfinx"),
            ("NGSolve", ngsolve, "ngsolve/bin/python", "ngsolve")):
        if can_import(python, module):
            found[name] = solve
        else:
            print(f"{name} is not installed", file=sys.stderr)
    return found


def difference(result, reference):
    """The largest of all points and steps, relative to the largest displacement."""
    pairs = [pair for rows in zip(result["displacements"],
                                  reference["displacements"])
             for pair in zip(*rows)]
    return max(abs(a - b) for a, b in pairs) / max(abs(b) for _, b in pairs)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--cells", type=int, nargs="+", default=[4, 8],
                        help="along an edge of the block")
    parser.add_argument("--repeats", type=int, default=1,
                        help="the fastest run counts")
    parser.add_argument("--set", action="append", default=[],
                        metavar="SECTION/NAME=VALUE")
    parser.add_argument("--only", action="store_true",
                        help="without the other programs")
    options = parser.parse_args()
    solvers = {"Lumbricus": lumbricus} if options.only else programs()

    print("| cells | unknowns | program | Newton iterations | time (s) | "
          "relative to Lumbricus | uz at the middle of the top (mm) | "
          "difference |\n" + "|---" * 8 + "|")
    for n in options.cells:
        ours = None
        for name, solve in solvers.items():
            result = min((solve(n, options.set)
                          for _ in range(options.repeats)),
                         key=lambda result: result["seconds"])
            ours = ours or result
            apart = difference(result, ours)
            print(f"| {n}³ | {result['unknowns']} | {name} | "
                  f"{result['newton_iterations']} | {result['seconds']:.2f} | "
                  f"{result['seconds'] / ours['seconds']:.2f} | "
                  f"{result['displacements'][-1][0]:.6f} | {apart:.1e} |",
                  flush=True)
            if apart > TOLERANCE:
                sys.exit(f"{name} and Lumbricus do not agree.")


if __name__ == "__main__":
    main()
