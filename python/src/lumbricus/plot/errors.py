# SPDX-License-Identifier: LGPL-2.1-or-later
"""By how much lengths, radii and pressures of the segments are off since cells are as
large as they are, as errors.csv estimates it."""

import pathlib

import matplotlib.pyplot as plt
import numpy as np

from .arrays import Array
from .figures import INCHES, save
from .run_folder import ESTIMATED, RunFolder


def in_per_cent(run: RunFolder, name: str) -> Array:
    """Estimated errors [time, segment], of the largest value of all."""
    assert run.errors is not None
    shape = (-1, run.n_segments)
    values = run.errors[name].reshape(shape)
    errors = run.errors[f"{name}_error"].reshape(shape)
    largest = np.nanmax(np.abs(values))
    return 100 * errors / largest if largest > 0 else np.zeros_like(errors)


def draw_errors(run: RunFolder, file_name: pathlib.Path) -> None:
    """Bars at the last time that has an estimate, dots at those before."""
    figure, grid = plt.subplots(1, 3, figsize=(INCHES, 2.6), sharex=True,
                                layout="constrained")
    numbers = run.segment_numbers
    for axes, (name, title) in zip(grid, ESTIMATED.items()):
        errors = in_per_cent(run, name)
        for earlier in errors[:-1]:
            axes.plot(numbers, earlier, ".", color="0.6", markersize=3)
        axes.bar(numbers, errors[-1], width=0.6, color="#5b8db8")
        axes.axhline(0, color="black", linewidth=0.6)
        largest = np.nanmax(np.abs(errors)) if np.isfinite(errors).any() else np.nan
        axes.set_title(f"{title}: at most {largest:.2g} %", fontsize=9)
        axes.set_xlabel("segment", fontsize=8)
        axes.set_xticks(numbers[::max(1, len(numbers) // 10)])
        axes.tick_params(labelsize=7)
        axes.grid(linewidth=0.3, axis="y")
    grid[0].set_ylabel("smaller cells would add [%]", fontsize=8)
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
