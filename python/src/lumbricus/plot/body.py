# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole body from the part of it that was computed, and what of it is shown
when it is cut open."""

import numpy as np
import pyvista

from .arrays import Array, Columns, Json
from .fields import MIDDLE, MIRRORED, grid_of, nodes_of_cells
from .view import VIEW

AXES = "xyz"
ON_PLANE = 1e-6  # how near, in sizes of the body


class Body:
    """What a run says of its body: the planes of symmetry in which it is
    mirrored, its axis, and which tissues are liquid. A plane is (d, position):
    x_d = position."""

    def __init__(self, description: Json) -> None:
        self.mirrors = [(AXES.index(plane["normal"]), plane["position"])
                        for plane in description["symmetry_planes"]]
        self.axis = AXES.index(description["axis"])
        self.liquid_tissues = [i for i, tissue
                               in enumerate(description["tissues"])
                               if tissue["liquid"]]

    def whole(self, grid: pyvista.UnstructuredGrid) -> tuple[Array, Array, Columns]:
        """The points, nodes [cell, node] and fields of the whole body."""
        points, nodes = grid.points, nodes_of_cells(grid)
        # Tensors are not drawn.
        fields = {name: values for name, values in grid.point_data.items()
                  if values.ndim == 1 or is_vector(values)}
        for d, position in self.mirrors:
            nodes = np.concatenate([nodes, nodes[:, MIRRORED] + len(points)])
            points = with_image(points, d, position)
            fields = {name: with_image(values, d if is_vector(values) else None)
                      for name, values in fields.items()}
        return points, nodes, fields

    def cut(self, points: Array) -> list[tuple[int, float]]:
        """The two planes along which a body with these points is cut open: of
        symmetry or through the axis, first those that have the axis in them,
        and with a part of the body on both sides. None where there are no
        two."""
        symmetric = dict(self.mirrors)
        along = [(d, symmetric.get(d, 0.0)) for d in range(3) if d != self.axis]
        across = [plane for plane in self.mirrors if plane[0] == self.axis]
        size = ON_PLANE * np.ptp(points)
        found = [(d, position) for d, position in along + across
                 if points[:, d].min() < position - size
                 and points[:, d].max() > position + size]
        return sorted(found[:2]) if len(found) >= 2 else []

    def opened(self,
               grid: pyvista.UnstructuredGrid
              ) -> tuple[pyvista.UnstructuredGrid, list[tuple[int, float]]]:
        """The body without the part between both planes of the cut and the
        viewer, and these planes. Where there are faces of cells on them, none
        is cut, which keeps all faces curved."""
        points, nodes, fields = self.whole(grid)
        planes = self.cut(points)
        if planes:
            middle = points[nodes[:, MIDDLE]]
            behind = np.any([(middle[:, d] - position) * VIEW.normal[d] < 0
                             for d, position in planes], axis=0)
            # One that is all before the planes stays whole.
            if not behind.any():
                return grid_of(points, nodes, fields), []
            nodes = nodes[behind]
        return grid_of(points, nodes, fields), planes


def is_vector(values: Array) -> bool:
    return values.shape[1:] == (3,)


def with_image(values: Array, d: int | None, position: float = 0.0) -> Array:
    """Values at the points and at their images in the plane x_d = position;
    vectors have none of their own."""
    image = values.copy()
    if d is not None:
        image[:, d] = 2 * position - image[:, d]
    return np.concatenate([values, image])
