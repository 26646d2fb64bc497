# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the run converged: resets, divergence after each, Newton's residuals."""

import pathlib

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from .arrays import Array
from .figures import INCHES, save
from .run_folder import RunFolder

NOTHING = "nothing yet"
STEP_COLOURS = plt.get_cmap("viridis")
NEWTON_PANELS = [
    ("force_residual", "force residual", "Newton/Force tolerance"),
    ("volume_residual", "volume residual", "Newton/Volume tolerance"),
    ("increment", "increment", "Newton/Increment tolerance")]


def groups(*columns: Array) -> list[slice]:
    """Slices of the rows in which none of the columns changes."""
    n = len(columns[0])
    changes = np.zeros(max(n - 1, 0), dtype=bool)
    for column in columns:
        changes |= column[1:] != column[:-1]
    ends = [*(np.flatnonzero(changes) + 1), n] if n else []
    return [slice(a, b) for a, b in zip([0, *ends], ends)]


def solves(run: RunFolder) -> Array:
    """For every solve, in order: time, cycle, number of resets before it and
    largest divergence of all segments."""
    table = run.resets
    found = [(table["t"][rows][0], table["cycle"][rows][0],
              table["reset"][rows][0], np.max(table["eta"][rows]))
             for rows in groups(table["t"], table["cycle"], table["reset"])]
    return np.array(found).reshape(-1, 4).T


def resets_of_steps(run: RunFolder) -> tuple[Array, Array]:
    """Times, and resets of each step with the adaptations that follow it."""
    t, cycle, reset, _ = solves(run)
    steps = groups(t)
    counts = [sum(reset[rows][part].max() for part in groups(cycle[rows]))
              for rows in steps]
    return np.array([t[rows][0] for rows in steps]), np.array(counts)


def positive(values: Array) -> Array:
    """With gaps where a logarithmic axis has no place."""
    return np.where(values > 0, values, np.nan)


def draw_tolerance(axes: Axes, value: float | None, label: str) -> None:
    if value is not None and value > 0:
        axes.axhline(value, color="#b03020", linewidth=0.9, linestyle="--",
                     label=label, zorder=1)


def say(axes: Axes, text: str) -> None:
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center",
              va="center", fontsize=8, color="#777777")


def draw_resets(axes: Axes, run: RunFolder) -> None:
    times, counts = resets_of_steps(run)
    if not len(times):
        say(axes, NOTHING)
    # Thin where there are many.
    axes.vlines(times, 0, counts, color="#30688e",
                linewidth=min(1, 200 / max(1, len(times))))
    axes.plot(times, counts, ".", color="#30688e", markersize=4,
              label="resets of the step")
    cuts = run.steps["cuts"]
    if (cuts > 0).any():
        axes.plot(run.steps["t"][cuts > 0], cuts[cuts > 0], "x",
                  color="#b03020", markersize=4, label="cuts of the step")
        axes.legend(fontsize=7, frameon=False, ncol=2, loc="lower right",
                    bbox_to_anchor=(1, 0.98), borderaxespad=0)
    axes.set_ylim(0, max(1, *counts, *cuts) * 1.1 if len(times) else 1)
    axes.yaxis.get_major_locator().set_params(integer=True)
    axes.set_title("resets (of any segment) in each load step", fontsize=9,
                   loc="left")


def draw_divergence(axes: Axes, run: RunFolder) -> None:
    t, _, reset, eta = solves(run)
    axes.set_title(r"largest divergence $\eta$ [-] of all segments, "
                   "after every solve", fontsize=9, loc="left")
    if not (eta > 0).any():
        say(axes, "zero everywhere" if len(t) else NOTHING)
        return
    eta = positive(eta)
    last = np.append(t[1:] != t[:-1], True)
    axes.set_yscale("log")
    axes.add_collection(LineCollection(
        [np.stack([t[rows], eta[rows]], axis=1) for rows in groups(t)],
        colors="#bbbbbb", linewidths=min(0.6, 100 / len(t)), zorder=1))
    for chosen, marker, colour, label in (
            (reset == 0, "o", "#e08030", "before a reset"),
            ((reset > 0) & ~last, ".", "#888888", "after a reset"),
            (last, ".", "#30688e", "at the end of the step")):
        if chosen.any():
            hollow = {"markerfacecolor": "none"} if marker == "o" else {}
            axes.plot(t[chosen], eta[chosen], marker, color=colour,
                      markersize=5, markeredgewidth=0.8, label=label,
                      **hollow)
    draw_tolerance(axes, run.number("Reset/Tolerance"), "Reset/Tolerance")
    axes.legend(fontsize=7, ncol=4, loc="upper center",
                bbox_to_anchor=(0.5, -0.2), frameon=False)


def newton_lines(run: RunFolder, name: str) -> tuple[list[Array], Array]:
    """Points (iteration, value) of every solve, and the step it belongs to."""
    table = run.newton
    iteration, step = table["iteration"], table["step"]
    values = positive(table[name])
    # A solve begins where the iterations are counted anew.
    begin = np.cumsum(np.append(0, np.diff(iteration) <= 0))[:len(iteration)]
    rows_of_solves = groups(step, begin) if len(step) else []
    return ([np.stack([iteration[rows], values[rows]], axis=1)
             for rows in rows_of_solves],
            np.array([step[rows][0] for rows in rows_of_solves]))


def draw_newton(axes: Axes, run: RunFolder, name: str, title: str,
                tolerance: str) -> ScalarMappable | None:
    lines, steps = newton_lines(run, name)
    if not lines:
        say(axes, NOTHING)
        return None
    norm = Normalize(1, max(2, steps.max()))
    axes.set_yscale("log")
    axes.add_collection(LineCollection(
        lines, colors=STEP_COLOURS(norm(steps)), linewidths=0.6, alpha=0.6))
    points = np.concatenate(lines)
    axes.scatter(*points.T, s=3, linewidths=0, zorder=2,
                 c=STEP_COLOURS(norm(np.repeat(steps, [len(line) for line
                                                       in lines]))))
    draw_tolerance(axes, run.number(tolerance), tolerance)
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.set_xlabel("iteration of the solve", fontsize=8)
    axes.set_title(title + " [-]", fontsize=9, loc="left")
    return plt.cm.ScalarMappable(norm=norm, cmap=STEP_COLOURS)


def draw_convergence(run: RunFolder, file_name: pathlib.Path) -> None:
    figure = plt.figure(figsize=(INCHES, 7), layout="constrained")
    grid = figure.subplot_mosaic(
        [["resets"] * 3, ["eta"] * 3, [name for name, *_ in NEWTON_PANELS]],
        gridspec_kw={"height_ratios": [1, 1.5, 1.6]})
    grid["resets"].sharex(grid["eta"])
    draw_resets(grid["resets"], run)
    draw_divergence(grid["eta"], run)
    grid["eta"].set_xlim(run.times[0], run.times[-1] + 0.02 * np.ptp(run.times))
    grid["eta"].set_xlabel("time", fontsize=8)
    colours = None
    for name, title, tolerance in NEWTON_PANELS:
        colours = draw_newton(grid[name], run, name, title, tolerance)
    if colours is not None:
        bar = figure.colorbar(colours, ax=grid["increment"], pad=0.02)
        bar.set_label("load step", fontsize=8)
        bar.locator = MaxNLocator(integer=True)
        bar.ax.tick_params(labelsize=7)
    for axes in grid.values():
        axes.grid(linewidth=0.3)
        axes.tick_params(labelsize=7)
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
