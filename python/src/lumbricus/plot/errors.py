# SPDX-License-Identifier: LGPL-2.1-or-later
"""By how much lengths, radii, pressures and places of the segments are off since cells
are as large, steps in time as long and resets as few as they are, as errors.csv
estimates it."""

import pathlib

import matplotlib.pyplot as plt
import numpy as np

from .arrays import Array
from .figures import INCHES, save
from .run_folder import ESTIMATED, SOURCES, RunFolder

COLOURS = {"": "#5b8db8", "_of_steps": "#d98c3f", "_of_resets": "#6aa56a"}


def in_per_cent(run: RunFolder, name: str, source: str = "") -> Array:
    """Estimated errors [time, segment] at the times that have them, of the largest
    value of all; those of places of the largest length."""
    assert run.errors is not None
    shape = (-1, run.n_segments)
    values = run.errors["length" if name == "middle_x" else name]
    errors = run.errors[f"{name}_error{source}"].reshape(shape)
    largest = np.nanmax(np.abs(values))
    errors = errors[np.isfinite(errors).any(axis=1)]
    return 100 * errors / largest if largest > 0 else np.zeros_like(errors)


def draw_errors(run: RunFolder, file_name: pathlib.Path) -> None:
    """Bars at the last time that has an estimate, dots at those before, each source
    apart."""
    assert run.errors is not None
    figure, grid = plt.subplots(1, 4, figsize=(INCHES, 2.6), sharex=True,
                                layout="constrained")
    numbers = run.segment_numbers
    sources = [source for source in SOURCES if f"length_error{source}" in run.errors]
    width = 0.8 / len(sources)
    for axes, (name, title) in zip(grid, ESTIMATED.items()):
        for k, source in enumerate(sources):
            errors = in_per_cent(run, name, source)
            at = numbers + (k - 0.5 * (len(sources) - 1)) * width
            for earlier in errors[:-1]:
                axes.plot(at, earlier, ".", color="0.6", markersize=3)
            last = errors[-1] if len(errors) else np.full(len(at), np.nan)
            axes.bar(at, last, width=0.9 * width, color=COLOURS[source],
                     label=f"{SOURCES[source]} would add")
        largest = [np.abs(errors).max() for source in sources
                   if len(errors := in_per_cent(run, name, source))
                   and np.isfinite(errors).all()]
        axes.axhline(0, color="black", linewidth=0.6)
        axes.set_title(f"{title}: " + (f"at most {max(largest):.2g} %" if largest
                                       else "no estimate"), fontsize=8)
        axes.set_xlabel("segment", fontsize=8)
        axes.set_xticks(numbers[::max(1, len(numbers) // 10)])
        axes.tick_params(labelsize=7)
        axes.grid(linewidth=0.3, axis="y")
    if len(sources) > 1:
        grid[0].legend(fontsize=6)
    grid[0].set_ylabel("error [%]" if len(sources) > 1 else
                       f"{SOURCES[sources[0]]} would add [%]", fontsize=8)
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
