# SPDX-License-Identifier: LGPL-2.1-or-later
"""scene.html: a page that needs no other file, and no network."""

import argparse
import base64
import html
import importlib.resources
import json
import pathlib
import zlib

from ..animation import seconds_of_frames
from ..figures import choose_times
from ..run_folder import RunFolder
from .frames import Recording

PAGE = """<!DOCTYPE html>
<html lang="en-GB">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<canvas id="scene" tabindex="0" aria-label="The body; drag to turn it"></canvas>
<div id="bars"></div>
<div id="controls">
<button id="play" type="button" aria-label="play">▶</button>
<input id="slider" type="range" min="0" max="{last}" value="0" aria-label="time">
<output id="time"></output>
<select id="colouring" aria-label="coloured by"></select>
<button id="home" type="button" title="as at the beginning">⌂</button>
</div>
<p id="message" hidden></p>
<script type="application/json" id="words">{words}</script>
<script type="text/plain" id="numbers">{numbers}</script>
<script>{script}</script>
</body>
</html>
"""


def part(name: str) -> str:
    return (importlib.resources.files(__package__) / name).read_text(encoding="utf-8")


def script() -> str:
    return "\n".join(part(name) for name in ("algebra.js", "drawing.js", "scene.js"))


def caption(recording: Recording) -> str:
    times = [frame.time for frame in recording.frames]
    text = (f"The body at {len(times)} times from t = {times[0]:g} to t = "
            f"{times[-1]:g}, cut open as above. Drag to turn it, with the shift key "
            "to move it, roll to come nearer; space plays.")
    if recording.left_out:
        text += (f" Left out for the size of the file: {recording.left_out} times.")
    return text


def write_scene(run: RunFolder, options: argparse.Namespace,
                file_name: pathlib.Path) -> str:
    """Write the scene of a run; what it shows."""
    shown = choose_times(run.series, [], options.frames)
    recording = run.reading(shown[0][1], Recording, run.body, shown, run.obstacles)
    words, numbers = recording.describe()
    words["seconds"] = [float(s) for s in seconds_of_frames(
        [frame["time"] for frame in words["frames"]])]
    file_name.write_text(PAGE.format(
        title=html.escape(run.title), style=part("scene.css"), script=script(),
        last=len(words["frames"]) - 1,
        words=json.dumps(words, ensure_ascii=False).replace("<", "\\u003c"),
        numbers=base64.b64encode(zlib.compress(numbers, 9)).decode("ascii")),
        encoding="utf-8")
    return caption(recording)
