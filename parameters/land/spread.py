#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draw the deformed lines of the three problems, and beside them where the point that all
compare is, in the runs and as published: FOLDER/spread.png, from the runs in beam,
inflation and contraction of that folder. Needs NumPy and Matplotlib, no display.
"""

import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot import figures  # noqa: E402
from lumbricus.plot.tables import read_table  # noqa: E402

plt = figures.plt
RUN, OTHER, RANGE = "#c0392b", "#2471a3", "#aab7b8"
# The abstract of the paper: differences of finer solutions are typically 0.5 %.
TYPICAL = 0.005


class Problem:
    """A run, the line in it that is drawn, and what is compared.

    line, across: numbers of the points in Output/Points, in order along the line, and
        the coordinate that is drawn over x.
    point, axis: the number of the point that is compared, and its coordinate.
    independent: what was computed independently of this program, see README.md.
    published: the smallest and the largest number of a group; None: not known.
    others: other programs with a number of their own.
    """

    def __init__(self, folder, title, line, across, point, axis, independent,
                 published=None, others=None):
        self.folder, self.title, self.line, self.across = folder, title, line, across
        self.point, self.axis, self.independent = point, axis, independent
        self.published, self.others = published, others or {}


PROBLEMS = [
    Problem("beam", "1: axis of the beam", range(2, 13), "z", 1, "z", 4.1665,
            (4.14, 4.20)),
    Problem("inflation", "2: middle of the wall", [2, *range(4, 14)], "r", 2, "x",
            -27.3012, None, {"solids4foam": -27.32}),
    Problem("contraction", "3: middle of the wall", [2, *range(4, 14)], "r", 2, "x",
            -14.2221)]


def positions(table, points, t):
    """Places at rest and deformed of numbered points, as columns by axis; r is the
    distance from the x axis."""
    rows = [int(np.flatnonzero((table["point"] == point) & (table["t"] == t))[0])
            for point in points]
    rest = {axis: table[axis][rows] for axis in "xyz"}
    deformed = {axis: rest[axis] + table["u" + axis][rows] for axis in "xyz"}
    for place in (rest, deformed):
        place["r"] = np.hypot(place["y"], place["z"])
    return rest, deformed


def draw_lines(axes, problem, rest, deformed):
    for line, colour, label in ((rest, RANGE, "at rest"), (deformed, RUN, "run")):
        axes.plot(line["x"], line[problem.across], ".-", color=colour, label=label,
                  linewidth=1.4, markersize=5)
        if problem.across == "r":  # the other half of the section
            axes.plot(line["x"], -line["r"], "-", color=colour, linewidth=1.4)
    axes.set_aspect("equal")
    axes.set_title(f"Problem {problem.title}", fontsize=9, loc="left")
    axes.set_xlabel("x [mm]", fontsize=8)
    axes.set_ylabel(f"{problem.across} [mm]", fontsize=8)
    axes.legend(fontsize=7, frameon=False)


def draw_numbers(axes, problem, found):
    """One line of numbers: what was published, and points on it."""
    low, high = problem.published or sorted(
        problem.independent * (1 + sign * TYPICAL) for sign in (-1, 1))
    axes.axvspan(low, high, color=RANGE, alpha=0.5, linewidth=0,
                 label="range of the groups" if problem.published else
                 "0.5 %, as finer solutions differ")
    axes.plot([problem.independent], [0.35], "D", color=OTHER, markersize=5,
              label="independent")
    for name, value in problem.others.items():
        axes.plot([value], [0.65], "^", color="black", markersize=5, label=name)
    axes.plot([found], [0], "o", color=RUN, markersize=6, label="run")
    middle = (low + high) / 2
    axes.set(ylim=(-0.6, 2.2), yticks=[],
             xlim=(middle - (high - low), middle + (high - low)))
    axes.set_xlabel(f"{problem.axis} of the point [mm]", fontsize=8)
    axes.legend(fontsize=6, frameon=False, loc="upper center", ncol=2)


def draw(folder):
    """Returns what was found for each problem."""
    figure, grid = plt.subplots(
        2, 3, figsize=(figures.INCHES * 1.4, 5), layout="constrained",
        gridspec_kw={"height_ratios": [2.2, 1]})
    found = {}
    for problem, (lines, numbers) in zip(PROBLEMS, grid.T):
        table = read_table(folder / problem.folder / "points.csv")
        end = table["t"].max()
        draw_lines(lines, problem, *positions(table, problem.line, end))
        _, deformed = positions(table, [problem.point], end)
        found[problem.folder] = deformed[problem.axis][0]
        draw_numbers(numbers, problem, found[problem.folder])
    for axes in grid.flat:
        axes.tick_params(labelsize=7)
        axes.grid(linewidth=0.3)
    figures.save(figure, folder / "spread.png")
    return found


def main(arguments=None):
    parser = argparse.ArgumentParser(
        description="Draw the three problems of Land et al. 2015: spread.png in the "
        "folder of their runs.")
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path,
                        help="the folder with the runs beam, inflation, contraction")
    folder = parser.parse_args(arguments).folder
    missing = [problem.folder for problem in PROBLEMS
               if not (folder / problem.folder / "points.csv").exists()]
    if missing:
        print(f"spread.py: no run in '{folder / missing[0]}'. Run the three problems "
              "first: see README.md.", file=sys.stderr)
        return 1
    for name, value in draw(folder).items():
        print(f"{name}: {value:.4f} mm")
    print(f"Wrote spread.png to {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
