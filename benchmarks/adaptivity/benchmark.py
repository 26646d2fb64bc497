# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy per unknown: uniform meshes against adapted ones.

  benchmarks/run.sh adaptivity [TABLE ...]

septum: all estimators on parameters/adaptive_septum. The pressure of the liquid, and the
largest von Mises stress of the wall on a line along the muscle bundle, 0.06 mm and more
off the septum: in the corner itself the stress has no bound. Against a mesh adapted until
it has 470,000 unknowns. Draws the picture adaptivity.png.

main_job: the largest error of the pressures of all segments of parameters/peristalsis at
t = 0.55, against an independent program: meshes made by hand, one of them with all cells
cut, and the same adapted by goal.
"""
import argparse
import math
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from lumbricus_run import SOURCE, run_well

sys.path.insert(0, str(SOURCE / "tests" / "physics"))
from test_errors import PERISTALSIS, SEGMENT, independent  # noqa: E402

CASE = SOURCE / "parameters" / "adaptive_septum" / "case.prm"
RULE = "Adaptivity/fraction of error/Refine"
ESTIMATORS = ("stress jump", "displacement jump", "goal")


def mises(row):
    s = {key: row["s" + key] for key in ("xx", "yy", "zz", "xy", "yz", "xz")}
    return math.sqrt(0.5 * ((s["xx"] - s["yy"])**2 + (s["yy"] - s["zz"])**2 +
                            (s["zz"] - s["xx"])**2) +
                     3 * (s["xy"]**2 + s["yz"]**2 + s["xz"]**2))


def measure(name, settings):
    """(unknowns, pressure, largest stress) at the end of a run."""
    result = run_well(CASE, name, ["Output/Every=0"] + settings, ranks=2)
    points = result.table("points.csv")
    last = [row for row in points if row["t"] == points[-1]["t"]]
    found = (int(result.table("mesh.csv")[-1]["unknowns"]),
             result.last(1)["fluid_pressure"], max(map(mises, last)))
    print(name, *found, file=sys.stderr, flush=True)
    return found


def uniform(refinements):
    return measure(f"uniform-{refinements}",
                   ["Adaptivity/Every=0", "Mesh/Refine where=1",
                    f"Mesh/Local refinements={refinements}"])


def adapted(estimator, cycles, fraction=0.3):
    return measure(f"{estimator}-{cycles}-{fraction}".replace(" ", "-"),
                   [f"Adaptivity/Estimator={estimator}",
                    f"Adaptivity/Cycles={cycles}", f"{RULE}={fraction}"])


def draw(curves, reference):
    figure, axes = plt.subplots(1, 2, figsize=(9, 4), sharex=True)
    for axis, which, title in ((axes[0], 1, "pressure of the liquid"),
                               (axes[1], 2, "largest stress of the wall")):
        for name, curve in curves.items():
            axis.loglog([point[0] for point in curve],
                        [abs(point[which] / reference[which] - 1)
                         for point in curve],
                        "o-" if name == "uniform" else "s--", label=name)
        axis.set_xlabel("unknowns")
        axis.set_ylabel("relative error")
        axis.set_title(title)
        axis.grid(True, which="major", alpha=0.4)
    axes[0].legend()
    figure.tight_layout()
    figure.savefig("adaptivity.png", dpi=110)


def septum():
    curves = {"uniform": [uniform(n) for n in range(3)]}
    for estimator in ESTIMATORS:
        curves[estimator] = [adapted(estimator, n) for n in range(1, 9)]
    reference = adapted("stress jump", 7, 0.6)
    print("| mesh | unknowns | pressure (N/mm²) | error | "
          "largest stress (N/mm²) | error |\n|---|---|---|---|---|---|")
    for name, curve in list(curves.items()) + [("reference", [reference])]:
        for unknowns, pressure, stress in curve:
            print(f"| {name} | {unknowns} | {pressure:.6f} | "
                  f"{100 * (pressure / reference[1] - 1):.2f} % | "
                  f"{stress:.4f} | {100 * (stress / reference[2] - 1):.2f} % |")
    draw(curves, reference)


def main_job():
    true = {segment: row["fluid_pressure"] for (t, segment), row in
            independent("axisymmetric.csv").items() if t == 0.55}

    def run(name, along, across, settings):
        return run_well(PERISTALSIS / "case.prm", name, [
            "Output/Every=0", "Time/End=0.55", "Adaptivity/Every=11",
            f"{SEGMENT}Cells along a segment={along}",
            f"{SEGMENT}Cells across the liquid={across}", *settings], ranks=2,
            timeout=7200)

    def row(words, result, cycle):
        found = {int(row["segment"]): row["fluid_pressure"]
                 for row in result.table("resets.csv")
                 if row["t"] > 0.549 and row["cycle"] == cycle}
        mesh = next(row for row in result.table("mesh.csv") if row["cycle"] == cycle)
        error = max(abs(found[s] - true[s]) for s in true) / max(true.values())
        print(f"| {words} | {mesh['unknowns']:.0f} | {100 * error:.2f} % |", flush=True)

    print("\n| mesh | unknowns | largest error of a pressure |\n|---|---|---|")
    for n in (2, 4, 6):
        row(f"{n} cells along, {n} across",
            run(f"job-{n}", n, n, ["Adaptivity/Cycles=1", "Adaptivity/Finest level=0"]),
            0)
    row("2 along, 2 across, every cell cut into eight",
        run("job-cut", 2, 2, [
            "Adaptivity/Cycles=1", "Adaptivity/Marking=fraction of cells",
            "Adaptivity/fraction of cells/Refine=1"]), 1)
    goal = run("job-goal", 2, 2, ["Adaptivity/Cycles=5", "Adaptivity/Estimator=goal",
                                  f"{RULE}=0.6"])
    for cycle in range(1, 6):
        row(f"2 along, 2 across, adapted by goal {cycle} times", goal, cycle)


TABLES = {table.__name__: table for table in (septum, main_job)}


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
