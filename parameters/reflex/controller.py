#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reflex as a controller of the longitudinal muscle: controller.py ADDRESS [GAIN]

A segment whose length l is more than its length at rest, l_0, contracts,

    lambda = 1 - G max(0, l/l_0 - 1),  but not to less than 0.7.

What it feels is how long it was before the load step: a reflex is late."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))
from lumbricus.controller import Controller  # noqa: E402


class Reflex(Controller):
    """Each segment for itself."""

    def __init__(self, rest, gain=0.6):
        self.rest = rest
        self.gain = gain

    def step(self, t, dt, segments):
        stretches = [segment["length"] / self.rest for segment in segments]
        return {"longitudinal": [max(0.7, 1 - self.gain * max(0.0, stretch - 1))
                                 for stretch in stretches]}


if __name__ == "__main__":
    Reflex(2.1, *map(float, sys.argv[2:3])).serve(sys.argv[1])
