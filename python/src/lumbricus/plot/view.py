# SPDX-License-Identifier: LGPL-2.1-or-later
"""From where bodies are seen: a parallel projection."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from .arrays import Array


def unit(v: Any) -> Array:
    return np.asarray(np.asarray(v) / np.linalg.norm(v))


class View:
    """The axis of the body runs to the right."""

    def __init__(self, towards_viewer: Sequence[float]) -> None:
        self.normal = unit(towards_viewer)
        self.right = unit([1, 0, 0] - self.normal[0] * self.normal)
        self.up = np.cross(self.normal, self.right)

    def project(self, x: Array) -> Array:
        return np.stack([x @ self.right, x @ self.up], axis=-1)

    def window(self, bodies: Sequence[Array]) -> tuple[Array, Array]:
        """The corners of the window that holds all these points."""
        places = np.concatenate([self.project(x) for x in bodies])
        low, high = places.min(axis=0), places.max(axis=0)
        margin = 0.03 * (high - low).max()
        return low - margin, high + margin


# A little from above and from the tail. Of a round body, the quarter y < 0,
# z > 0 faces the viewer and is left out.
VIEW = View([0.28, -0.82, 0.5])
LIGHT = unit([-0.1, -0.6, 0.8])
