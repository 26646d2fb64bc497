# SPDX-License-Identifier: LGPL-2.1-or-later
"""Length, radius, pressure and volume of the segments against time."""

import pathlib

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from .arrays import Array
from .figures import INCHES, cell_borders, save
from .run_folder import ESTIMATED, RunFolder

MOST_LINES = 2  # more segments are drawn as rows of colour


def panels(run: RunFolder) -> list[tuple[str, str, Array, str, bool]]:
    """(column, title, values [time, segment], colours, zero in the middle or not)"""
    volume = "fluid_volume" if run.has_liquid else "wall_volume"
    return [
        ("length", "length [mm]", run.field("length"), "viridis", False),
        ("mid_radius", "radius in the middle [mm]", run.field("mid_radius"),
         "viridis", False),
        ("fluid_pressure", "pressure of the liquid [N/mm$^2$]",
         run.field("fluid_pressure"), "YlGnBu", False),
        (volume, ("liquid" if run.has_liquid else "wall") + ": $V/V_0 - 1$",
         run.field(volume) / run.field(volume)[0] - 1, "RdBu_r", True)]


def largest(values: Array) -> float:
    """What is less than 1e-12 is round-off."""
    return max(float(np.abs(values).max()), 1e-12)


def bars(run: RunFolder, column: str) -> tuple[Array, Array, Array] | None:
    """Times, and values and the sizes of their estimated errors [time, segment]; None
    where there are no estimates of that column."""
    if run.errors is None or column not in ESTIMATED:
        return None
    shape = (-1, run.n_segments)
    return (run.errors["t"].reshape(shape)[:, 0], run.errors[column].reshape(shape),
            np.abs(run.errors[f"{column}_error"]).reshape(shape))


def draw_lines(axes: Axes, run: RunFolder, column: str, values: Array,
               symmetric: bool) -> None:
    estimated = bars(run, column)
    for k, (segment, curve) in enumerate(zip(run.segment_numbers, values.T)):
        line, = axes.plot(run.times, curve, ".-", linewidth=1, markersize=4,
                          label=f"segment {segment}")
        if estimated is not None:
            times, centres, sizes = estimated
            axes.errorbar(times, centres[:, k], yerr=sizes[:, k], fmt="none",
                          ecolor=line.get_color(), elinewidth=1, capsize=3)
    if symmetric:
        axes.set_ylim(-largest(values), largest(values))
    axes.ticklabel_format(axis="y", useOffset=False, scilimits=(-3, 4))
    axes.grid(linewidth=0.3)
    if run.n_segments > 1:
        axes.legend(fontsize=7)


def draw_rows(axes: Axes, run: RunFolder, values: Array, colours: str,
              symmetric: bool) -> None:
    numbers = run.segment_numbers
    limits = ({"vmin": -largest(values), "vmax": largest(values)}
              if symmetric else {})
    mesh = axes.pcolormesh(cell_borders(run.times),
                           np.arange(numbers[0], numbers[-1] + 2) - 0.5,
                           values.T, cmap=colours, **limits)
    axes.invert_yaxis()
    axes.set_ylabel("segment", fontsize=8)
    axes.set_yticks(numbers[::max(1, len(numbers) // 10)])
    bar = axes.figure.colorbar(mesh, ax=axes, pad=0.02)
    bar.formatter.set_powerlimits((-3, 4))
    bar.ax.tick_params(labelsize=7)
    bar.ax.yaxis.get_offset_text().set_fontsize(7)


def draw_segments(run: RunFolder, file_name: pathlib.Path) -> None:
    figure, grid = plt.subplots(2, 2, figsize=(INCHES, 4.6), sharex=True,
                                layout="constrained")
    for axes, (column, title, values, colours, symmetric) in zip(grid.flat,
                                                                 panels(run)):
        if run.n_segments > MOST_LINES:
            draw_rows(axes, run, values, colours, symmetric)
        else:
            draw_lines(axes, run, column, values, symmetric)
        axes.set_title(title, fontsize=9)
        axes.tick_params(labelsize=7)
        axes.yaxis.get_offset_text().set_fontsize(7)
    for axes in grid[1]:
        axes.set_xlabel("time", fontsize=8)
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
