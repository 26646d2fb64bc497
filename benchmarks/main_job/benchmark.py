# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs cost now and at an earlier commit, on the same machine in turn, and how far
the results of both are from the hydrostatic state.

  benchmarks/run.sh main_job --before COMMIT [--times N] [--ranks N ...] [CASE ...]

with the CASES below, the main job unless told otherwise. The program of COMMIT is built
in a folder of its own; --program PATH takes one that is there. Seconds are the
processor's, of all ranks, without the system's: the least of N runs. Differences are the
largest over all times and segments, relative to the largest value, from the earlier
program with Reset/Tolerance=1e-6.
"""
import argparse
import os
import pathlib
import resource
import subprocess

from lumbricus_run import SOURCE, Run

# As long as takes about a minute; adaptive_septum in its first two adaptations.
CASES = {"peristalsis": [], "antagonism": ["Time/End=1.5"],
         "quarter_length": ["Time/End=1.5"],
         "lumbricus_terrestris": ["Time/End=2.5"],
         "adaptive_septum": ["Time/End=0.2"]}
VALUES = ("length", "mid_radius", "fluid_pressure")
COUNTS = ("solves", "newton_iterations", "linear_iterations",
          "factorisations")


def built(commit):
    """The program of a commit, in a work tree in this folder."""
    tree = pathlib.Path(f"before-{commit}").resolve()
    if not tree.exists():
        subprocess.run(["git", "-C", SOURCE, "worktree", "add", "--detach",
                        tree, commit], check=True)
    subprocess.run(["cmake", "-S", tree, "-B", tree / "build", "-G", "Ninja",
                    "-DCMAKE_BUILD_TYPE=Release",
                    "-DLUMBRICUS_DEBUG_INFO=OFF"],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", tree / "build", "--target",
                    "lumbricus"], check=True, stdout=subprocess.DEVNULL)
    return tree / "build" / "lumbricus"


def compute(program, case, folder, ranks, settings=()):
    """A run, and the seconds that its processes took."""
    mpirun = [os.environ["MPIRUN"], "-np", str(ranks)] if ranks > 1 else []
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    process = subprocess.run(
        [*mpirun, program, SOURCE / "parameters" / case / "case.prm",
         "--output", folder, "--quiet", "--set", "Output/Every=0",
         *(part for setting in [*CASES[case], *settings]
           for part in ("--set", setting))],
        capture_output=True, text=True, check=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return Run(process, pathlib.Path(folder)), seconds


def differences(run, exact):
    """At times that both have: steps may be cut in one of them."""
    rows = {(round(row["t"], 9), row["segment"]): row
            for row in exact.segments()}
    pairs = [(row, rows[place]) for row in run.segments()
             if (place := (round(row["t"], 9), row["segment"])) in rows]
    return [max(abs(row[name] - other[name]) for row, other in pairs) /
            max(abs(other[name]) for _, other in pairs) for name in VALUES]


def show(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def compare(case, ranks, programs, n_times):
    exact, _ = compute(programs["before"], case, f"{case}-exact", ranks,
                       ["Reset/Tolerance=1e-6", "Reset/Limit=400"])
    least = {}
    for _ in range(n_times):
        for name, program in programs.items():
            runs, seconds = compute(program, case, f"{case}-{name}-{ranks}",
                                    ranks)
            least[name] = (runs, min(seconds, least.get(name, (0, seconds))[1]))
    for name, (run, seconds) in least.items():
        show(case, ranks, name,
             *(f"{sum(row[count] for row in run.steps()):.0f}"
               for count in COUNTS),
             f"{seconds:.1f}", f"{seconds / least['before'][1]:.2f}",
             *(f"{value:.1e}" for value in differences(run, exact)))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--before", metavar="COMMIT")
    parser.add_argument("--program", metavar="PATH")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("cases", nargs="*", metavar="CASE")
    arguments = parser.parse_args()
    if (arguments.before is None) == (arguments.program is None):
        parser.error("give either --before or --program")
    programs = {"before": arguments.program or built(arguments.before),
                "now": os.environ["LUMBRICUS"]}
    show("case", "ranks", "program", *(c.replace("_", " ") for c in COUNTS),
         "seconds", "ratio", *VALUES)
    print("|---" * (6 + len(COUNTS) + len(VALUES) - 1) + "|")
    for case in arguments.cases or ["peristalsis"]:
        for ranks in arguments.ranks:
            compare(case, ranks, programs, arguments.times)


if __name__ == "__main__":
    main()
