# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the time grows with the problem and shrinks with the ranks.

Weak scaling: chains of 1, 2, 4, ..., 64 segments as in parameters/peristalsis, on two
ranks. A method whose costs are proportional to the length of the chain takes the same
time per segment and step for all of them. The wave is eight segments long, so that
from eight on every chain has segments in each of its phases.

Strong scaling: parameters/block_compression with 16 cells along an edge, the chain
of 64 segments, and a whole worm of 150 segments and chambers without cells, five waves
of thirty long, each on one rank and on two.

Messages: what a rank sends in a linear iteration of that worm and of the block, on 2, 4,
8 and 16 ranks, whatever the number of cores."""
import argparse
import os
import pathlib
import re
import subprocess
import sys

from lumbricus_run import SOURCE, run_well

BUILD = pathlib.Path(os.environ["LUMBRICUS"]).parent
CHAIN = SOURCE / "parameters" / "peristalsis" / "case.prm"
WORM = SOURCE / "parameters" / "peristalsis" / "cavities.prm"
BLOCK = SOURCE / "parameters" / "block_compression" / "case.prm"
CELLS = (("around a quarter", 4), ("along a segment", 2),
         ("across the liquid", 1))
WAVELENGTH = 8
REFERENCE = 8
SEGMENTS = (1, 2, 4, 8, 16, 32, 64)
TIMEOUT = 7200
PARTS = ("assembly", "residual", "factorisation", "iterations", "total")


def without_septa():
    """The case as a file for a single segment, which has no septum: a section that
    nothing uses is an error."""
    text = CHAIN.read_text()
    for section in ("septum", "septal"):
        text = re.sub(rf"^  subsection {section}\n.*?^  end\n", "", text,
                      flags=re.MULTILINE | re.DOTALL)
    path = pathlib.Path("single_segment.prm")
    path.write_text(text)
    return path


def chain(n_segments):
    """File and settings of a chain: some steps of fixed length."""
    muscles = ["circular", "longitudinal"] + ["septal"] * (n_segments > 1)
    return (CHAIN if n_segments > 1 else without_septa(),
            [f"Geometry/segment chain/Number of segments={n_segments}",
             *(f"Geometry/segment chain/Cells {what}={n}" for what, n in CELLS),
             *(f"Muscles/{muscle}/wave/Wavelength={WAVELENGTH}"
               for muscle in muscles),
             "Time/First step=0.05", "Time/Largest step=0.05", "Time/End=0.2"])


STRONG = {"block": (BLOCK, ["Geometry/block/Cells=16, 16, 16",
                            "Newton/Volume tolerance=1e-9"]),
          "chain": chain(64),
          "worm": (WORM, ["Geometry/segment chain/Number of segments=150",
                          *(f"Geometry/segment chain/Cells {what}=2" for what in
                            ("around a quarter", "along a segment",
                             "across the liquid")),
                          *(f"Muscles/{muscle}/wave/Wavelength=30" for muscle in
                            ("circular", "longitudinal", "septal")),
                          "Time/End=0.2"])}
RANKS = (2, 4, 8, 16)


def seconds(log, part):
    """Of the table at the end of the log; 0 if it has no such row."""
    row = re.search(rf"^ +{part} +([\d.]+) +\d+%", log, re.MULTILINE)
    return float(row.group(1)) if row else 0.


def measure(name, case, settings, ranks):
    result = run_well(case, f"{name}-on-{ranks}", ["Output/Every=0"] + settings,
                      ranks=ranks, timeout=TIMEOUT)
    found = {**result.costs(),
             **{part: seconds(result.log, part) for part in PARTS}}
    print(f"{name} on {ranks}: {found['total']:.1f} s", file=sys.stderr,
          flush=True)
    return found


def header(*names):
    print("\n| " + " | ".join(names) + " |\n" + "|---" * len(names) + "|")


def weak_scaling(segments):
    runs = {n: measure(f"chain-{n}", *chain(n), 2) for n in segments}
    costs = {n: run["total"] / n / run["steps"] for n, run in runs.items()}
    reference = REFERENCE if REFERENCE in runs else max(runs)
    header("segments", "unknowns", "time per segment and step (s)",
           f"relative to {reference} segments",
           "peak memory of the largest rank, per segment (MB)", "steps",
           "Newton iterations", "linear iterations", "factorisations",
           "time of factorisation (s)", "of iterations (s)", "in all (s)")
    for n, run in runs.items():
        print(f"| {n} | {run['unknowns']} | {costs[n]:.3f} | "
              f"{costs[n] / costs[reference]:.2f} | "
              f"{run['megabytes'] / n:.0f} | {run['steps']} | "
              f"{run['newton_iterations']} | {run['linear_iterations']} | "
              f"{run['factorisations']} | {run['factorisation']:.1f} | "
              f"{run['iterations']:.1f} | {run['total']:.1f} |")


def strong_scaling(names):
    tables = {name: [measure(name, *STRONG[name], ranks) for ranks in (1, 2)]
              for name in names}
    header("case", "unknowns", "part", "one rank (s)", "two ranks (s)",
           "speed-up")
    for name, (one, two) in tables.items():
        for part in PARTS:
            ratio = f"{one[part] / two[part]:.2f}" if two[part] > 0 else ""
            print(f"| {name} | {one['unknowns']} | {part} | {one[part]:.1f} | "
                  f"{two[part]:.1f} | {ratio} |")
    header("case", "ranks", "Newton iterations", "linear iterations",
           "factorisations", "peak memory of the largest rank (MB)")
    for name, runs in tables.items():
        for ranks, run in enumerate(runs, start=1):
            print(f"| {name} | {ranks} | {run['newton_iterations']} | "
                  f"{run['linear_iterations']} | {run['factorisations']} | "
                  f"{run['megabytes']} |")


def count_messages(name, ranks):
    """What benchmark_messages prints: lists of numbers by name."""
    case, settings = STRONG[name]
    lines = subprocess.run(
        [os.environ["MPIRUN"], "-np", str(ranks),
         str(BUILD / "benchmarks" / "scaling" / "benchmark_messages"), str(case),
         *settings], check=True, capture_output=True, text=True,
        timeout=TIMEOUT).stdout.splitlines()
    return {line.split()[0]: [float(number) for number in line.split()[1:]]
            for line in lines if line}


def messages(names):
    subprocess.run(["cmake", "--build", str(BUILD), "--target",
                    "benchmark_messages"], check=True, stdout=subprocess.DEVNULL)
    header("case", "ranks", "messages of a rank, of the one with most",
           "bytes in them", "calls of ranks that share a front",
           "bytes in them", "collective calls", "bytes in them",
           "linear iterations")
    for name in names:
        for ranks in RANKS:
            found = count_messages(name, ranks)

            def both(what, digits):
                return ", ".join(f"{n:.{digits}f}" for n in found[what])
            print(f"| {name} | {ranks} | {both('messages', 1)} | "
                  f"{both('bytes', 0)} | {both('shared', 1)} | "
                  f"{both('shared_bytes', 0)} | {found['collectives'][0]:.1f} | "
                  f"{found['collective_bytes'][0]:.0f} | "
                  f"{found['iterations'][1]:.0f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--segments", type=int, nargs="+",
                        help="weak scaling over these chains")
    parser.add_argument("--strong", nargs="*", choices=tuple(STRONG),
                        help="strong scaling of these cases, or all of them")
    parser.add_argument("--messages", nargs="*", choices=tuple(STRONG),
                        help="messages in these cases, or the block and the worm\n"
                        "(without any option: weak and strong scaling)")
    options = parser.parse_args()
    everything = all(option is None for option in (
        options.segments, options.strong, options.messages))
    if everything or options.segments:
        weak_scaling(options.segments or SEGMENTS)
    if everything or options.strong is not None:
        strong_scaling(options.strong or STRONG)
    if options.messages is not None:
        messages(options.messages or ("block", "worm"))


if __name__ == "__main__":
    main()
