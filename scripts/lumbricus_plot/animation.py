# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deforming body, cut open: all frames with the same view and colours."""

import shutil
import subprocess

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from PIL import Image

from picture import (VIEW, Drawing, Scales, add_colour_bars, choose_times,
                     interpolate, interpolation, paint, planes_of_cut,
                     rendered, select)

from .run_folder import PlotError

INCHES = 7.5             # width of a frame
DOTS_PER_INCH = 120
SECONDS_A_FRAME = 0.15   # on average: each is shown as long as its time lasts
LAST_SECONDS = 1.0
FIBRE_COLOUR = "#0f9a8e"
ACROSS = 0.25            # fibres with less than this in the cut are dots
NO_DITHER = 0


class DrawingWithFibres(Drawing):
    """Also the fibres on the cut."""

    def lines_on_cut(self, faces, body, with_mesh):
        self.lines, self.dots = fibres_on_cut(faces, body)
        return Drawing.lines_on_cut(faces, body, with_mesh)


def fibres_on_cut(faces, body):
    """Lines [n, 2, 2] along the fibres, and points [n, 2] where they cross the
    cut: one of every muscle in the middle of every face of the cut."""
    names = [name for name in faces if name.startswith("fibre_")]
    lines, dots = [np.zeros((0, 2, 2))], [np.zeros((0, 2))]
    middle = interpolation(3)[1:2]
    # Derivatives of the quadratic functions in the middle.
    slope = np.array([[-1.0, 0.0, 1.0]])
    for on_plane in planes_of_cut(faces, body):
        cut = select(faces, on_plane)
        if not on_plane.any():
            continue
        x = cut["points"] + cut["displacement"]
        place = interpolate(x, middle)[:, 0, 0]
        along = [np.einsum("ai,bj,fij...->f...", a, b, x)
                 for a, b in ((slope, middle), (middle, slope))]
        normal = np.cross(*along)
        area = np.linalg.norm(normal, axis=1)
        normal /= area[:, None] + 1e-300
        visible = normal @ VIEW.normal > 0
        for name in names:
            f = interpolate(cut[name], middle)[:, 0, 0]
            size = np.linalg.norm(f, axis=1)
            f = f / np.where(size > 0, size, 1)[:, None]
            f -= np.sum(f * normal, axis=1)[:, None] * normal
            there = visible & (size > 0)
            flat = there & (np.linalg.norm(f, axis=1) > ACROSS)
            half = 0.3 * np.sqrt(area)[:, None] * f
            lines.append(VIEW.project(np.stack(
                [place - half, place + half], axis=1)[flat]))
            dots.append(VIEW.project(place[there & ~flat]))
    return np.concatenate(lines), np.concatenate(dots)


def draw_frame(drawing, time, scales, title):
    """An image of one time."""
    low, high = scales.low, scales.high.copy()
    # Room for the time above the body.
    high[1] += 0.12 * (high - low)[0] / INCHES
    width, height = high - low
    body_inches = min(max(INCHES * height / width, 0.8), 5)
    bars = 0.75 if scales.has_contraction or scales.has_liquid else 0.1
    title_inches = 0.4
    total = body_inches + bars + title_inches
    figure = plt.figure(figsize=(INCHES, total))
    axes = figure.add_axes([0, bars / total, 1, body_inches / total])
    paint(axes, drawing, scales, low, high, time)
    if isinstance(drawing, DrawingWithFibres):
        axes.add_collection(LineCollection(
            drawing.lines, colors=FIBRE_COLOUR, linewidths=0.9, zorder=3))
        axes.scatter(*drawing.dots.T, s=3, color=FIBRE_COLOUR, linewidths=0,
                     zorder=3)
    figure.suptitle(title, fontsize=11, y=1 - 0.13 / total, va="top")
    add_colour_bars(figure, scales)
    return rendered(figure, DOTS_PER_INCH)


def seconds_of_frames(times):
    """How long to show each, in proportion to the time until the next."""
    if len(times) == 1:
        return [LAST_SECONDS]
    steps = np.diff(times)
    seconds = SECONDS_A_FRAME * len(steps) * steps / steps.sum()
    return [*np.clip(seconds, 0.04, 1).round(2), LAST_SECONDS]


def common_palette(images):
    """256 colours for all frames, so that none flickers. A colour counts by the
    root of how often it occurs, so that large areas leave some to the others;
    white paper stays white."""
    some = images[::max(1, len(images) // 8)]
    # As one number each, which is faster to sort.
    numbers, counts = np.unique(
        np.concatenate([np.asarray(image).reshape(-1, 3) @ [1, 256, 65536]
                        for image in some]), return_counts=True)
    colours = np.stack([numbers & 255, numbers >> 8 & 255, numbers >> 16],
                       axis=1).astype(np.uint8)
    chosen = (counts >= 6) & (colours.min(axis=1) < 244)
    weighted = np.repeat(colours[chosen],
                         np.sqrt(counts[chosen]).astype(int), axis=0)
    values = [255, 255, 255, 0, 0, 0]
    if len(weighted):
        reduced = Image.fromarray(weighted[None]).quantize(254, kmeans=3)
        values += reduced.getpalette()[:3 * 254]
    palette = Image.new("P", (1, 1))
    palette.putpalette(values)
    return palette


def write_gif(images, seconds, file_name):
    palette = common_palette(images)
    frames = [image.quantize(palette=palette, dither=NO_DITHER)
              for image in images]
    frames[0].save(file_name, save_all=True, append_images=frames[1:],
                   duration=[int(1000 * s) for s in seconds], loop=0)


def find_ffmpeg():
    ffmpeg = shutil.which("ffmpeg")
    if ffmpeg is None:
        raise PlotError("The program 'ffmpeg', which makes animation.mp4, is "
                        "not there; install it, or leave out --mp4 for a GIF.")
    return ffmpeg


def write_mp4(images, seconds, file_name, ffmpeg):
    rate = 25
    # The format wants even sizes.
    width, height = (size // 2 * 2 for size in images[0].size)
    command = [ffmpeg, "-y", "-loglevel", "error", "-f", "rawvideo",
               "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", str(rate),
               "-i", "-", "-an", "-c:v", "libx264", "-pix_fmt", "yuv420p",
               "-movflags", "+faststart", str(file_name)]
    data = b"".join(image.crop((0, 0, width, height)).tobytes()
                    * max(1, round(rate * s))
                    for image, s in zip(images, seconds))
    done = subprocess.run(command, input=data, capture_output=True,
                          check=False)
    if done.returncode != 0:
        reason = done.stderr.decode(errors="replace").strip().splitlines()
        raise PlotError(f"'{file_name}' was not made, as ffmpeg failed "
                        f"({reason[-1] if reason else 'it does not say why'})"
                        "; leave out --mp4 for a GIF.")


def animate(run, n_frames, with_fibres, file_name, ffmpeg=None):
    """Write the animation, with ffmpeg where it is given; the times shown."""
    body = run.body()
    shown = choose_times(run.series, [], n_frames)
    kind = DrawingWithFibres if with_fibres else Drawing
    drawings = [run.reading(name, kind, name, body, False)
                for _, name in shown]
    scales = Scales(drawings)
    times = [time for time, _ in shown]
    images = [draw_frame(drawing, time, scales, run.figure_title())
              for drawing, time in zip(drawings, times)]
    seconds = seconds_of_frames(times)
    if ffmpeg is None:
        write_gif(images, seconds, file_name)
    else:
        write_mp4(images, seconds, file_name, ffmpeg)
    return times
