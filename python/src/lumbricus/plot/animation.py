# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deforming body, cut open: all frames with the same view and colours."""

import argparse
import pathlib
from collections.abc import Sequence

import numpy as np

from .arrays import Array
from .figures import choose_times, goes_back
from .film import write_gif, write_mp4
from .panels import Panels, read_drawings
from .run_folder import RunFolder

DOTS_PER_INCH = 120
SECONDS_A_FRAME = 0.15   # on average: each is shown as long as its time lasts
LAST_SECONDS = 1.0


def seconds_of_frames(times: Sequence[float] | Array) -> list[float]:
    """How long to show each, in proportion to the time until the next, or equally
    long where times go back."""
    if len(times) == 1:
        return [LAST_SECONDS]
    steps = np.ones(len(times) - 1) if goes_back(times) else np.diff(times)
    seconds = SECONDS_A_FRAME * len(steps) * steps / steps.sum()
    return [*np.clip(seconds, 0.04, 1).round(2), LAST_SECONDS]


def animate(run: RunFolder, options: argparse.Namespace,
            file_name: pathlib.Path) -> list[float]:
    """Write the animation, as a GIF or an MP4; the times shown."""
    shown = choose_times(run.series, [], options.frames)
    times = [time for time, _ in shown]
    drawings = read_drawings(run, shown, options.mesh, options.fibres)
    panels = Panels(drawings, 1, run.figure_title(), DOTS_PER_INCH)
    images = [panels.image(drawing, time)
              for drawing, time in zip(drawings, times)]
    panels.scene.close()
    write = write_mp4 if file_name.suffix == ".mp4" else write_gif
    write(images, seconds_of_frames(times), file_name)
    return times
