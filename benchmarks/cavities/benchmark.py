# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chambers without cells against the rubber fluid on the same wall, which is the same
discrete problem once the fluid is hydrostatic: do they agree, and what does each cost?

  benchmarks/run.sh cavities [--tolerance EPS ...] [CASE ...]

with cases among peristalsis, antagonism, quarter_length and lumbricus_terrestris of
parameters/. Each runs with one pressure per chamber, with the rubber fluid as the case
has it, and with the rubber fluid reset after solves and Reset/Tolerance=EPS, 1e-6 unless
told otherwise.
Differences are the largest over all segments and times, relative to the largest value
of all.

Cases end early, after about a minute of rubber fluid each: see ENDS.
"""
import argparse

from lumbricus_run import SOURCE, run_well

CHAIN = "Geometry/segment chain/"
# The main job and the worm to a time after their ramps at which pressures are
# highest; the others to the height of the second muscle's contraction.
ENDS = {"peristalsis": 0.55, "antagonism": 1.5, "quarter_length": 1.5,
        "lumbricus_terrestris": 2.5}
VALUES = ("length", "mid_radius", "fluid_pressure", "fluid_volume")
N_RANKS = 2
RESETS = 400
TIMEOUT = 7200


def compute(case, end, name, settings):
    return run_well(SOURCE / "parameters" / case / "case.prm",
                    f"{case}-{name}",
                    [f"Time/End={end}", "Output/Every=0", *settings], N_RANKS,
                    timeout=TIMEOUT)


def differences(run, reference):
    """At times that both have: steps may be cut in one of them."""
    rows = {(round(row["t"], 9), row["segment"]): row
            for row in reference.segments()}
    pairs = [(row, rows[place]) for row in run.segments()
             if (place := (round(row["t"], 9), row["segment"])) in rows]
    assert pairs
    return [max(abs(row[name] - other[name]) for row, other in pairs) /
            max(abs(other[name]) for _, other in pairs) for name in VALUES]


def header(*columns):
    print("\n| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|",
          flush=True)


def show(*cells):
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tolerance", type=float, nargs="+", default=[1e-6],
                        metavar="EPS")
    parser.add_argument("--set", action="append", default=[],
                        metavar="Name=value")
    parser.add_argument("cases", nargs="*", metavar="CASE",
                        help=", ".join(ENDS))
    options = parser.parse_args()
    liquids = {"rubber": [],
               **{f"rubber, {eps:g}": ["Reset/Every=solve",
                                       f"Reset/Tolerance={eps}",
                                       f"Reset/Limit={RESETS}"]
                  for eps in options.tolerance}}
    costs = []
    header("case", "until", "liquid", "length", "radius", "pressure", "volume")
    for case in options.cases or ENDS:
        end = ENDS[case]
        cavities = compute(case, end, "cavity",
                           [f"{CHAIN}Liquid=cavity", *options.set])
        own = cavities.costs()
        costs.append([case, "cavity", *own.values(), ""])
        for liquid, settings in liquids.items():
            run = compute(case, end, liquid.replace(", ", "-"),
                          [*settings, *options.set])
            show(case, end, liquid, *(f"{value:.1e}" for value in
                                      differences(run, cavities)))
            found = run.costs()
            costs.append([case, liquid, *found.values(),
                          f"{found['seconds'] / own['seconds']:.1f}"])
    header("case", "liquid", *(name.replace("_", " ") for name in own),
           "seconds / those of the cavity")
    for row in costs:
        show(*(f"{cell:.1f}" if isinstance(cell, float) else cell
               for cell in row))


if __name__ == "__main__":
    main()
