# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies at several times in one figure, with title and colour bars."""

import argparse
import pathlib
from collections.abc import Sequence
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from PIL import Image

from .arrays import Array, Series
from .figures import DOTS_PER_INCH, INCHES, choose_times, save
from .run_folder import RunFolder
from .scene import LIQUID_COLOURS, MUSCLE_COLOURS, Scales, Scene
from .surface import Drawing

TITLE_INCHES = 0.45
TIME_INCHES = 0.12          # for the time above a body
MOST_ROW_INCHES = 3.5
THUMBNAIL = np.array([240, 150])


class Panels:
    """Columns of bodies, all in the same window and with the same colours."""

    def __init__(self, drawings: Sequence[Drawing], columns: int, title: str,
                 dots_per_inch: int) -> None:
        self.scales = Scales(drawings)
        self.title = title
        self.dots_per_inch = dots_per_inch
        width, height = self.scales.high - self.scales.low
        if columns == 0:
            columns = 1 if width > 3 * height else min(3, len(drawings))
        self.columns = columns
        self.body_inches = np.array([1, height / width]) * min(
            INCHES / columns, (MOST_ROW_INCHES - TIME_INCHES) * width / height)
        self.row_inches = self.body_inches[1] + TIME_INCHES
        self.bar_inches = 0.75 if (self.scales.has_contraction
                                   or self.scales.has_liquid) else 0.1
        self.scene = Scene(self.scales, self.scales.low, self.scales.high,
                           round(self.body_inches[0] * dots_per_inch))

    def figure(self, drawings: Sequence[Drawing],
               times: Sequence[float] | Array) -> Figure:
        n_rows = -(-len(drawings) // self.columns)
        total = n_rows * self.row_inches + self.bar_inches + TITLE_INCHES
        figure = plt.figure(figsize=(INCHES, total), dpi=self.dots_per_inch)
        for number, (drawing, time) in enumerate(zip(drawings, times)):
            row, column = divmod(number, self.columns)
            left = column * INCHES / self.columns
            top = total - TITLE_INCHES - row * self.row_inches
            # In the middle of its column, dot by dot.
            figure.figimage(
                np.asarray(self.scene.image(drawing)),
                *(round(self.dots_per_inch * inches) for inches in (
                    left + 0.5 * (INCHES / self.columns - self.body_inches[0]),
                    top - self.row_inches)))
            figure.text((left + 0.02 * INCHES / self.columns) / INCHES,
                        top / total, f"$t$ = {time:g}", fontsize=9, va="top")
        figure.suptitle(self.title, fontsize=11, y=1 - 0.13 / total, va="top")
        add_colour_bars(figure, self.scales)
        return figure

    def image(self, drawing: Drawing, time: Any) -> Image.Image:
        """A figure of one time as an image."""
        figure = self.figure([drawing], [time])
        figure.canvas.draw()
        image = Image.fromarray(np.asarray(figure.canvas.buffer_rgba()))
        plt.close(figure)
        return image.convert("RGB")


def add_colour_bars(figure: Figure, scales: Scales) -> None:
    """At the bottom of the figure, 0.75 inches high."""
    total = figure.get_figheight()
    maps = []
    if scales.has_contraction:
        maps.append((scales.contraction, MUSCLE_COLOURS,
                     "active contraction of the muscles [%]"))
    if scales.has_liquid:
        maps.append((scales.pressure, LIQUID_COLOURS,
                     "pressure of the liquid [N/mm$^2$]"))
    places = [0.08, 0.55] if len(maps) == 2 else [0.315]
    for place, (norm, colours, label) in zip(places, maps):
        axes = figure.add_axes([place, 0.47 / total, 0.37, 0.1 / total])
        colour_bar = figure.colorbar(
            plt.cm.ScalarMappable(norm=norm, cmap=colours), cax=axes,
            orientation="horizontal",
            ticks=MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        colour_bar.set_label(label, fontsize=8, labelpad=2)
        colour_bar.ax.tick_params(labelsize=7, length=2, pad=2)
        colour_bar.outline.set_linewidth(0.5)


def read_drawings(run: RunFolder, shown: Series, with_mesh: bool,
                  with_fibres: bool) -> list[Drawing]:
    return [run.reading(name, Drawing, name, run.body, with_mesh, with_fibres,
                        run.obstacles.get(time))
            for time, name in shown]


def draw_picture(run: RunFolder, options: argparse.Namespace,
                 file_name: pathlib.Path) -> list[float]:
    """Write the bodies at the times wanted; these times."""
    shown = choose_times(run.series, options.times, options.count)
    times = [time for time, _ in shown]
    drawings = read_drawings(run, shown, options.mesh, options.fibres)
    panels = Panels(drawings, options.columns, run.figure_title(),
                    DOTS_PER_INCH)
    save(panels.figure(drawings, times), file_name)
    panels.scene.close()
    return times


def draw_thumbnail(run: RunFolder, options: argparse.Namespace,
                   file_name: pathlib.Path) -> None:
    """Write the body at one time, without words; it fills the image."""
    shown = choose_times(run.series, [options.thumbnail], 1)
    drawing, = read_drawings(run, shown, options.mesh, options.fibres)
    scales = Scales([drawing])
    # The window gets the shape of the image.
    size = scales.high - scales.low
    grown = THUMBNAIL * (size / THUMBNAIL).max()
    middle = 0.5 * (scales.low + scales.high)
    scene = Scene(scales, middle - 0.5 * grown, middle + 0.5 * grown,
                  THUMBNAIL[0])
    scene.image(drawing).save(file_name, optimize=True)
    scene.close()
