#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Stroke and loss of a segment with a viscous wall beside those of a standard linear
solid, and a picture of both.

    standard_solid.py RUN...

RUN are folders of runs of case.prm with other relaxation times, see README.md; curve.png
goes into the first one. In small strains, where all tissues have a branch that is r
times as stiff as their law, a muscle that would move the body by u without it moves it
by u / (1 + r i w tau/(1 + i w tau)), and what is lost in a period has the shape
w tau/(1 + ((1 + r) w tau)^2).
"""
import csv
import math
import pathlib
import sys

PERIOD, STIFFER = 1., 1.  # s; r
W = 2 * math.pi / PERIOD


def stroke(tau):
    """How far it moves over how far without a branch."""
    branch = STIFFER * 1j * W * tau / (1 + 1j * W * tau)
    return 1 / abs(1 + branch)


def loss(tau):
    """What a period costs over what it costs at most."""
    x = (1 + STIFFER) * W * tau
    return 2 * x / (1 + x * x)


def table(folder, name):
    with open(pathlib.Path(folder) / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def measured(folder):
    """In the last period: the stroke in length [mm], and what is dissipated and what
    the muscle does [N mm] in the quarter that is computed."""
    lengths = [(float(row["t"]), float(row["length"]))
               for row in table(folder, "segments.csv")]
    since = lengths[-1][0] - PERIOD + 1e-9
    last = [length for t, length in lengths if t > since]
    works = {"viscosity": 0., "muscle": 0.}
    for row in table(folder, "energy.csv"):
        if float(row["t"]) > since and row["kind"] in works:
            works[row["kind"]] += float(row["work"])
    return max(last) - min(last), works["viscosity"], works["muscle"]


def relaxation_time(folder):
    """As parameters.prm of the run has it, that of the wall."""
    with open(pathlib.Path(folder) / "parameters.prm", encoding="utf-8") as file:
        return next(float(line.split("=")[1]) for line in file
                    if "Relaxation time" in line)


def draw(times, strokes, losses, file_name):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                           / "python" / "src"))
    from lumbricus.plot import figures
    fine = [10**(-3 + 0.02 * k) for k in range(201)]
    figure, axes = figures.plt.subplots(figsize=(6, 3.4), layout="constrained")
    for name, curve, points, colour in (("stroke", stroke, strokes, "#2471a3"),
                                        ("loss", loss, losses, "#c0392b")):
        axes.semilogx(fine, [curve(tau) for tau in fine], color=colour, linewidth=1,
                      label=f"{name}, standard linear solid")
        axes.semilogx(times, points, "o", color=colour, markersize=4,
                      label=f"{name}, runs")
    axes.set_xlabel("relaxation time over period")
    axes.set_ylabel("over the largest one")
    axes.legend(frameon=False, fontsize=8)
    figure.savefig(file_name, dpi=150)


def main(folders):
    times = [relaxation_time(folder) for folder in folders]
    found = [measured(folder) for folder in folders]
    # Of the theory's largest values, from where the branch counts least and most.
    slowest = min(range(len(times)), key=times.__getitem__)
    dearest = max(range(len(times)), key=lambda i: found[i][1])
    still = found[slowest][0] / stroke(times[slowest])
    most = found[dearest][1] / loss(times[dearest])
    print("  tau/T  stroke [mm]  of all  theory  loss [N mm]  muscle  of most  theory")
    for tau, (moved, lost, done) in zip(times, found):
        print(f"{tau / PERIOD:7.3f}  {moved:11.4f}  {moved / still:6.3f}  "
              f"{stroke(tau):6.3f}  {lost:11.4e}  {done:10.4e}  {lost / most:7.3f}  "
              f"{loss(tau):6.3f}")
    draw(times, [moved / still for moved, *_ in found],
         [lost / most for _, lost, _ in found], pathlib.Path(folders[0]) / "curve.png")


if __name__ == "__main__":
    main(sys.argv[1:])
