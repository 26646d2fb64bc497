# SPDX-License-Identifier: LGPL-2.1-or-later
"""How good estimates of errors are, and what they cost: the largest estimated over the
largest true error of length, radius and pressure, of all segments and times, on meshes of
the closed segment and of the main job, against an independent program; and the part of a
run's time that one estimate takes; in which order of the size of cells estimates fall
where every cell is cut into eight.

  benchmarks/run.sh errors [TABLE ...]

with tables among segment, main_job, order and cost.
"""
import argparse
import math
import resource
import sys

from lumbricus_run import SOURCE, run_well

sys.path.insert(0, str(SOURCE / "tests" / "physics"))
from test_errors import (  # noqa: E402
    NAMES, PERISTALSIS, SEGMENT, effectivity, errors, independent)

N_RANKS = 2


def header(*columns):
    print("\n| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|")


def largest(found):
    """Errors of all segments and times, of the largest value."""
    values = ([max(abs(row[name][i]) for row in found.values()) for i in (0, 1)]
              for name in NAMES)
    return [error / value if value > 0 else math.nan for value, error in values]


def row(case, name, settings, true, words):
    result = run_well(case, name, ["Output/Every=0", *settings], N_RANKS,
                      timeout=7200)
    found = errors(result)
    worst = largest(found)
    print("| " + " | ".join([
        *words, str(result.costs()["unknowns"]),
        *(f"{100 * part:.2g} %, {effectivity(found, true, name):.2f}"
          for part, name in zip(worst, NAMES))]) + " |", flush=True)


def segment():
    header("along", "across", "unknowns", *NAMES)
    true = independent("closed_segment.csv")
    for along, across in ((1, 2), (2, 2), (2, 4), (3, 6), (4, 8)):
        row(SOURCE / "tests" / "physics" / "segment.prm",
            f"segment-{along}-{across}",
            [f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment={along}",
             f"{SEGMENT}Cells across the liquid={across}", "Time/First step=0.1",
             "Time/Largest step=0.1", "Output/Errors=2"],
            true, (str(along), str(across)))


def main_job():
    header("case", "along", "across", "unknowns", *NAMES)
    true = independent("axisymmetric.csv")
    for name, along, across in (("cavities", 2, 1), ("cavities", 2, 2),
                                ("cavities", 4, 4), ("cavities", 6, 6),
                                ("case", 2, 2), ("case", 4, 4)):
        row(PERISTALSIS / f"{name}.prm", f"{name}-{along}-{across}",
            [f"{SEGMENT}Cells along a segment={along}",
             f"{SEGMENT}Cells across the liquid={across}", "Output/Errors=5"],
            true, (name, str(along), str(across)))


def order():
    header("case", "unknowns", *NAMES)
    gallery, tests = SOURCE / "parameters", SOURCE / "tests" / "physics"
    coarse = [f"{SEGMENT}Cells along a segment=2",
              f"{SEGMENT}Cells across the liquid=2"]
    for words, case, settings in (
            ("closed segment", tests / "segment.prm", [
                f"{SEGMENT}Liquid=cavity", *coarse, "Time/First step=0.1",
                "Time/Largest step=0.1", "Output/Errors=2"]),
            ("thick sphere", tests / "sphere.prm", [
                "Geometry/hollow sphere/Cells around a quarter=2",
                "Geometry/hollow sphere/Cells through the wall=2",
                "Cavities/Content=volume", "Output/Errors=4",
                "Cavities/volume/Relative volume=1 + 0.5*t",
                "Time/First step=0.25", "Time/Largest step=0.25"]),
            ("viscous_segment", gallery / "viscous_segment" / "case.prm",
             ["Time/End=1", "Output/Errors=10"]),
            ("crossed_fibres", gallery / "crossed_fibres" / "case.prm",
             ["Output/Errors=3"]),
            ("helical_twist", gallery / "helical_twist" / "case.prm",
             ["Time/End=0.3", "Output/Errors=3"]),
            ("main job, 3 segments", PERISTALSIS / "cavities.prm", [
                f"{SEGMENT}Number of segments=3", *coarse, "Time/End=0.4",
                "Output/Errors=4"])):
        results = [run_well(case, f"order-{words}-{n}", [
            "Output/Every=0", f"Mesh/Global refinements={n}", *settings], N_RANKS,
            timeout=7200) for n in (0, 1)]
        coarser, finer = (largest(errors(result)) for result in results)
        print("| " + " | ".join([words, ", ".join(
            str(result.costs()["unknowns"]) for result in results), *(
                f"{100 * a:.2g}, {100 * b:.2g} %: {math.log2(a / b):.1f}"
                # Round-off is that of a pressure which is given.
                if a > 1e-10 else "" for a, b in zip(coarser, finer))]) + " |",
            flush=True)


def cost():
    """Processor seconds of a run on one rank, with estimates and without."""
    header("case", "run without (s)", "an estimate (s)", "of the run")
    every, n_steps = 5, 25
    for name in ("cavities", "case"):
        def seconds(errors):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            run_well(PERISTALSIS / f"{name}.prm", f"cost-{name}-{errors}",
                     ["Output/Every=0", f"Output/Errors={errors}"], 1, timeout=7200)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return sum(getattr(after, time) - getattr(before, time)
                       for time in ("ru_utime", "ru_stime"))
        without = seconds(0)
        one = (seconds(every) - without) / (n_steps // every)
        print(f"| {name} | {without:.1f} | {one:.2f} | {100 * one / without:.0f} % |",
              flush=True)


TABLES = {table.__name__: table for table in (segment, main_job, order, cost)}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", metavar="TABLE",
                        help=", ".join(TABLES))
    for name in parser.parse_args().tables or TABLES:
        TABLES[name]()


if __name__ == "__main__":
    main()
