# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write images as a GIF or an MP4."""

import pathlib
from collections.abc import Sequence

import imageio_ffmpeg
import numpy as np
from PIL import Image

NO_DITHER = 0
FRAMES_PER_SECOND = 25  # of an MP4


def common_palette(images: list[Image.Image]) -> Image.Image:
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


def write_gif(images: list[Image.Image], seconds: Sequence[float],
              file_name: pathlib.Path) -> None:
    """Each image for so many seconds."""
    palette = common_palette(images)
    frames = [image.quantize(palette=palette, dither=NO_DITHER)
              for image in images]
    frames[0].save(file_name, save_all=True, append_images=frames[1:],
                   duration=[int(1000 * s) for s in seconds], loop=0)


def write_mp4(images: list[Image.Image], seconds: Sequence[float],
              file_name: pathlib.Path) -> None:
    # The format wants even sizes.
    width, height = (size // 2 * 2 for size in images[0].size)
    film = imageio_ffmpeg.write_frames(
        str(file_name), (width, height), fps=FRAMES_PER_SECOND,
        macro_block_size=2, ffmpeg_log_level="error",
        output_params=["-movflags", "+faststart"])
    film.send(None)
    for image, s in zip(images, seconds):
        data = image.crop((0, 0, width, height)).tobytes()
        for _ in range(max(1, round(FRAMES_PER_SECOND * s))):
            film.send(data)
    film.close()
