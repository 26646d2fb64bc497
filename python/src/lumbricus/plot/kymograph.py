# SPDX-License-Identifier: LGPL-2.1-or-later
"""Segments (downwards) against time: length, pressure and activation."""

import pathlib
from collections.abc import Mapping
from typing import Any, TypeAlias

import matplotlib.pyplot as plt
import numpy as np
import pyvista
from matplotlib.colors import FuncNorm, Normalize

from .activation import activation_of
from .arrays import Array, Columns
from .captions import no_formula
from .fields import MEAN_WEIGHTS, MIDDLE, nodes_of_cells
from .figures import INCHES, cell_borders, choose_times, goes_back, save
from .run_folder import RunFolder
from .scene import MUSCLE_COLOURS
from .summary import extreme

# Title, unit, times, values, colour map, norm.
Panel: TypeAlias = tuple[str, str, Array, Array, Any, Any]
MOST_TIMES = 200  # at which fields are read


def mean_activations(grid: pyvista.UnstructuredGrid, segments: Array) -> Columns:
    """For the activation of every muscle, by the name of its field, the mean in
    every segment over the volume at rest of the cells that have its fibres; nan
    where none has."""
    nodes = nodes_of_cells(grid)
    middle = nodes[:, MIDDLE]
    volumes = grid.compute_cell_sizes(length=False, area=False)["Volume"]
    in_segment = (np.round(grid["segment"][middle])
                  == np.reshape(segments, (-1, 1)))
    means = {}
    for name in grid.point_data:
        muscle = activation_of(name)
        if not muscle:
            continue
        fibre = grid["fibre_" + muscle[0]][middle]
        weights = in_segment * volumes * (np.linalg.norm(fibre, axis=1) > 0)
        total = weights.sum(axis=1)
        sums = weights @ (grid[name][nodes] @ MEAN_WEIGHTS)
        means[name] = np.divide(sums, total, where=total > 0,
                                out=np.full(len(total), np.nan))
    return means


def activation(run: RunFolder) -> tuple[Array, Columns]:
    """Times, and by field the mean activation [time, segment]."""
    shown = choose_times(run.series, [], MOST_TIMES) if run.series else []
    rows = [mean_activations(run.grid(name), run.segment_numbers)
            for _, name in shown]
    times = np.array([time for time, _ in shown])
    fields = rows[0].keys() if rows else []
    return times, {f: np.array([row[f] for row in rows]) for f in fields}


def borders(times: Array) -> Array:
    """Where the colour changes; a single time is given some width."""
    if len(times) == 1:
        return np.array([times[0] - 0.5, times[0] + 0.5])
    return cell_borders(times)


def ratio_norm(ratio: Array) -> FuncNorm:
    """Twice as long is as far from 1 as half as long."""
    logarithms = np.abs(np.log(ratio[np.isfinite(ratio)]))
    most = max([1e-3, *logarithms])
    return FuncNorm((lambda x: np.log(np.maximum(x, 1e-9)), np.exp),
                    np.exp(-most), np.exp(most))


def activation_panels(times: Array, of_muscles: Mapping[str, Array],
                      what: str, rest: float, colours: Any) -> list[Panel]:
    """Panels of one kind of activation, with one scale, which has that at rest."""
    known = [values for values in of_muscles.values() if np.isfinite(values).any()]
    if not known:
        return []
    low = min(rest, min(np.nanmin(values) for values in known))
    high = max(rest, max(np.nanmax(values) for values in known))
    norm = Normalize(min(low, high - 1e-6), high)
    prefix = "activation" if rest == 0 else f"activation: {what}"
    return [(f"{prefix} of muscle “{no_formula(muscle.replace('_', ' '))}”", "-",
             times, values, colours, norm) for muscle, values in of_muscles.items()]


def panels(run: RunFolder) -> list[Panel]:
    """(title, unit, times, values, colour map, norm) from the top down."""
    ratio = run.field("length") / run.field("length")[0]
    found = [("length relative to rest", "-", run.times, ratio, "RdBu",
              ratio_norm(ratio))]
    if run.has_liquid:
        pressure = run.field("fluid_pressure")
        found.append(("pressure of the liquid", "N/mm$^2$", run.times,
                      pressure, "YlGnBu",
                      Normalize(min(0, extreme(np.min, pressure)),
                                max(extreme(np.max, pressure), 1e-12))))
    times, activations = activation(run)
    for what, rest, colours in (
            ("active stretch", 1, MUSCLE_COLOURS.reversed()),
            ("activation", 0, MUSCLE_COLOURS)):
        of_kind = {muscle[0]: values for field, values in activations.items()
                   if (muscle := activation_of(field))
                   and field.startswith(what.replace(" ", "_") + "_")}
        found += activation_panels(times, of_kind, what, rest, colours)
    return found


def draw_kymograph(run: RunFolder, file_name: pathlib.Path) -> bool:
    """Write the picture; whether it shows any activation."""
    shown = panels(run)
    n_muscles = len(shown) - (2 if run.has_liquid else 1)
    heights = [1.5] * (len(shown) - n_muscles) + [1.1] * n_muscles
    figure, grid = plt.subplots(
        len(shown), 1, figsize=(INCHES, sum(heights) + 0.8), sharex=True,
        squeeze=False, layout="constrained",
        gridspec_kw={"height_ratios": heights})
    grid = grid[:, 0]
    numbers = run.segment_numbers
    over_steps = goes_back(run.times)

    def places(times: Array) -> Array:
        """Over the steps where the time goes back."""
        return np.array([np.argmin(np.abs(run.times - t)) for t in times]) \
            if over_steps else times

    rows = np.arange(len(numbers) + 1) - 0.5
    for axes, (title, unit, times, values, colours, norm) in zip(grid, shown):
        # Where a segment has no such muscle.
        axes.set_facecolor("#d9d9d9")
        mesh = axes.pcolormesh(borders(places(times)), rows,
                               np.ma.masked_invalid(values.T), cmap=colours,
                               norm=norm, rasterized=True)
        every = max(1, -(-len(numbers) // 8))
        axes.set_yticks(np.arange(0, len(numbers), every), numbers[::every])
        axes.set_ylim(rows[-1], rows[0])
        axes.set_ylabel("segment", fontsize=8)
        axes.set_title(title, fontsize=9, loc="left")
        axes.tick_params(labelsize=7)
        bar = figure.colorbar(mesh, ax=axes, pad=0.015, fraction=0.05,
                              aspect=14)
        bar.set_label(f"[{unit}]", fontsize=7)
        bar.formatter.set_powerlimits((-3, 4))
        bar.formatter.set_useOffset(False)
        bar.ax.tick_params(labelsize=7)
        bar.ax.yaxis.get_offset_text().set_fontsize(7)
    grid[-1].set_xlabel("step" if over_steps else "time", fontsize=8)
    grid[-1].set_xlim(*places(run.times)[[0, -1]])
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
    return n_muscles > 0
