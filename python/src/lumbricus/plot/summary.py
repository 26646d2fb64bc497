# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of a report, from the tables of a run."""

from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array
from .run_folder import RunFolder


def largest_change(volumes: Array) -> Array:
    """Of every segment the largest relative change of a volume [time, segment]
    since the beginning; nan where there is no such volume."""
    first = np.where(volumes[0] > 0, volumes[0], np.nan)
    return np.asarray(np.abs(volumes / first - 1).max(axis=0))


def extreme(function: Callable[..., Any], values: Array) -> float:
    """The least or largest value that is a number, nan where there is none."""
    values = np.asarray(values)[np.isfinite(values)]
    return function(values) if values.size else np.nan


class Summary:
    """Numbers of all segments, as arrays, and of the whole run."""

    def __init__(self, run: RunFolder) -> None:
        length = run.field("length")
        self.liquid_volume = run.field("fluid_volume")[0]
        self.liquid_change = largest_change(run.field("fluid_volume"))
        self.wall_volume = run.field("wall_volume")[0]
        self.wall_change = largest_change(run.field("wall_volume"))
        self.eta = run.field("eta").max(axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            self.length_ratio = length.max(axis=0) / length.min(axis=0)
        self.liquid_quality = run.field("fluid_mesh_quality").min(axis=0)
        self.wall_quality = run.field("wall_mesh_quality").min(axis=0)
        self.pressure = run.field("fluid_pressure").max(axis=0)

        self.n_steps = len(run.times) - 1
        self.time = run.times[-1]
        self.n_newton = int(run.steps["newton_iterations"].sum())
        self.n_cuts = int(run.steps["cuts"].sum())
        elapsed = run.steps["elapsed_seconds"]
        self.seconds = elapsed[-1] if len(elapsed) else 0.0

    def worst(self) -> list[tuple[str, float]]:
        """(what, value, how to write it) over all segments."""
        return [
            ("largest relative change of a liquid's volume",
             extreme(np.max, self.liquid_change)),
            ("largest relative change of a wall's volume",
             extreme(np.max, self.wall_change)),
            ("largest divergence η at the end of a step",
             extreme(np.max, self.eta)),
            ("largest ratio of longest to shortest length of a segment",
             extreme(np.max, self.length_ratio)),
            ("least quality of the liquid's mesh",
             extreme(np.min, self.liquid_quality)),
            ("least quality of the wall's mesh",
             extreme(np.min, self.wall_quality))]


def adaptations(run: RunFolder) -> list[dict[str, Any]]:
    """The rows of mesh.csv without that of the first mesh, as dictionaries."""
    n = len(run.mesh["step"])
    return [{name: values[i] for name, values in run.mesh.items()}
            for i in range(1, n)]
