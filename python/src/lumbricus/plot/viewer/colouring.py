# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the skin of a body can be coloured by, and with which colours."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.colors import Colormap

from ..arrays import Array
from ..scene import LIQUID_COLOURS, MUSCLE_COLOURS
from ..surface import Faces, contraction

N_COLOURS = 256


@dataclass
class Scale:
    """Colours and the values at their ends, over all times; a bar in the scene."""
    label: str
    colours: Colormap
    low: float = 0.0
    high: float = 0.0

    def take_in(self, values: Array) -> None:
        if len(values):
            self.low = min(self.low, float(values.min()))
            self.high = max(self.high, float(values.max()))

    def as_bytes(self, values: Array) -> Array:
        """The numbers of the colours."""
        size = self.high - self.low or 1.0
        return np.clip((values - self.low) / size * (N_COLOURS - 1) + 0.5, 0,
                       N_COLOURS - 1).astype(np.uint8)

    def describe(self) -> dict[str, Any]:
        rgb = self.colours(np.linspace(0, 1, N_COLOURS))[:, :3]
        return {"label": self.label, "low": self.low, "high": self.high,
                "colours": "".join(f"{c:02x}" for c in
                                   np.round(255 * rgb).astype(int).ravel())}


@dataclass
class Colouring:
    """A choice in the menu: the values at the nodes of faces, and a scale, or one for
    the wall and one for liquid."""
    name: str
    values: Callable[[Faces, Array], Array]
    scales: list[Scale]

    def scale_of(self, liquid: Array) -> list[tuple[Scale, Array]]:
        """Each scale with the vertices that it is for."""
        if len(self.scales) == 1:
            return [(self.scales[0], np.ones(len(liquid), dtype=bool))]
        return [(self.scales[0], ~liquid), (self.scales[1], liquid)]


def as_in_pictures() -> Colouring:
    def values(faces: Faces, liquid: Array) -> Array:
        return np.where(liquid, np.maximum(faces.fields["pressure"], 0),
                        contraction(faces.fields))

    return Colouring("contraction and pressure", values, [
        Scale("active contraction of the muscles [%]", MUSCLE_COLOURS),
        Scale("pressure of the liquid [N/mm²]", LIQUID_COLOURS)])


def of_a_field(name: str, label: str) -> Colouring:
    """Of a number, or of the length of a vector."""
    def values(faces: Faces, _: Array) -> Array:
        field = np.asarray(faces.fields[name])
        return field if field.ndim == 1 else np.linalg.norm(field, axis=1)

    return Colouring(label, values, [Scale(label, colormaps["viridis"])])


# What else a file may have, with words for the menu.
FIELDS = {"displacement": "displacement [mm]",
          "pressure": "pressure [N/mm²]",
          "contact_pressure": "contact pressure [N/mm²]",
          "slip": "slip on obstacles [mm]"}


def colourings_of(faces: Faces) -> list[Colouring]:
    """All there are of the fields of a run."""
    return [as_in_pictures(), *(of_a_field(name, label) for name, label
                                in FIELDS.items() if name in faces.fields)]
