# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all figures of Matplotlib have in common. No display is needed."""

import pathlib
from collections.abc import Sequence

import matplotlib
from matplotlib.figure import Figure

from .arrays import Array, Series

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

INCHES = 7.5  # width of all figures
DOTS_PER_INCH = 150


def save(figure: Figure, file_name: pathlib.Path) -> None:
    figure.savefig(file_name, dpi=DOTS_PER_INCH)
    plt.close(figure)


def goes_back(times: Sequence[float] | Array) -> bool:
    """Whether a run went along a path on which the load parameter turned."""
    return bool(np.any(np.diff(times) < 0))


def choose_times(series: Series, wanted: Sequence[float], n: int) -> Series:
    """The entries nearest to the times wanted, or n evenly spaced ones: over the
    time, or over the path where the time goes back."""
    times = np.array([t for t, _ in series])
    if not wanted and goes_back(times):
        return [series[i] for i in np.unique(
            np.linspace(0, len(times) - 1, min(n, len(times))).round().astype(int))]
    if not wanted:
        wanted = np.linspace(times[0], times[-1], min(n, len(times))).tolist()
    return [series[i] for i in
            sorted({int(np.argmin(np.abs(times - t))) for t in wanted})]


def cell_borders(t: Array) -> Array:
    """Borders between the times, for cells of constant colour."""
    middle = 0.5 * (t[1:] + t[:-1])
    return np.concatenate([t[:1], middle, t[-1:]])
