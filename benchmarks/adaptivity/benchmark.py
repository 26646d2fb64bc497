# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy per unknown: uniform meshes against adapted ones, both estimators, on
parameters/adaptive_septum. The pressure of the liquid, and the largest von Mises stress
of the wall on a line along the muscle bundle, 0.06 mm and more off the septum: in the
corner itself the stress has no bound. Against a mesh adapted until it has 470,000
unknowns. Draws the picture adaptivity.png."""
import math
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from lumbricus_run import SOURCE, run_well

CASE = SOURCE / "parameters" / "adaptive_septum" / "case.prm"
RULE = "Adaptivity/fraction of error/Refine"
ESTIMATORS = ("stress jump", "displacement jump")


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


def main():
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


if __name__ == "__main__":
    main()
