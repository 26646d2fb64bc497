# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which segments are anchored against time, and beside it how far the body has
come."""

import pathlib

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

from .arrays import Array, Columns
from .figures import INCHES, save
from .kymograph import borders
from .run_folder import RunFolder

FREE, SLIDES, ANCHORED = range(3)
COLOURS = ListedColormap(["#ffffff", "#e8d3b0", "#5a3d1e"])


def anchored(contact: Columns, segments: Array) -> tuple[Array, Array]:
    """Times, and of every segment [time, segment] whether it is free, slides or
    is anchored, by any obstacle."""
    times = np.unique(contact["t"])
    found = np.full((len(times), len(segments)), FREE)
    row = np.searchsorted(times, contact["t"])
    column = np.searchsorted(segments, contact["segment"].astype(int))
    touches = (contact["area"] > 0) | (contact["sliding"] > 0)
    state = np.where(contact["anchored"] > 0, ANCHORED,
                     np.where(touches, SLIDES, FREE))
    np.maximum.at(found, (row, column), state)
    return times, found


def draw_anchors(run: RunFolder, file_name: pathlib.Path) -> None:
    assert run.contact is not None
    contact, body = run.contact
    numbers = run.segment_numbers
    times, state = anchored(contact, numbers)
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(INCHES, 3.4), sharey=True, layout="constrained",
        gridspec_kw={"width_ratios": [2, 1]})
    left.pcolormesh(np.arange(len(numbers) + 1) - 0.5, borders(times), state,
                    cmap=COLOURS, vmin=FREE, vmax=ANCHORED, rasterized=True)
    every = max(1, -(-len(numbers) // 12))
    left.set_xticks(np.arange(0, len(numbers), every), numbers[::every])
    left.set_xlabel("segment", fontsize=8)
    left.set_ylabel("time", fontsize=8)
    left.set_title("anchored (dark), slides (light), free (white)", fontsize=9,
                   loc="left")
    right.plot(body["stride"], body["t"], color="#2f6f8f", linewidth=1.2)
    right.set_xlabel("centre of mass forward [mm]", fontsize=8)
    right.grid(linewidth=0.3)
    right.ticklabel_format(axis="x", scilimits=(-3, 4))
    # Time goes on downwards.
    left.set_ylim(times[-1], times[0])
    for axes in (left, right):
        axes.tick_params(labelsize=7)
        axes.xaxis.get_offset_text().set_fontsize(7)
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
