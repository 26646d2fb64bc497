# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all figures of Matplotlib have in common. No display is needed."""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

INCHES = 7.5  # width of all figures
DOTS_PER_INCH = 150


def save(figure, file_name):
    figure.savefig(file_name, dpi=DOTS_PER_INCH)
    plt.close(figure)


def choose_times(series, wanted, n):
    """The entries nearest to the times wanted, or n evenly spaced ones."""
    times = np.array([t for t, _ in series])
    if not wanted:
        wanted = np.linspace(times[0], times[-1], min(n, len(times)))
    return [series[i] for i in
            sorted({int(np.argmin(np.abs(times - t))) for t in wanted})]


def cell_borders(t):
    """Borders between the times, for cells of constant colour."""
    middle = 0.5 * (t[1:] + t[:-1])
    return np.concatenate([t[:1], middle, t[-1:]])
