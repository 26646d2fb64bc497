# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of a body as triangles that stay the same while it moves."""

import numpy as np
import pyvista

from ..arrays import Array
from ..fields import place_keys
from ..surface import ROWS, SHARP, Faces, on_edge

# In how many parts an edge of a face is divided, from fine to coarse; with 2 the
# points are the nodes of the face.
DIVISIONS = (4, 2, 1)


def shape_functions(n: int) -> Array:
    """Those of a face's nine nodes at its (n + 1)^2 points [point, node]."""
    along = on_edge(np.linspace(0, 1, n + 1))
    values = np.zeros(((n + 1) ** 2, 9))
    values[:, ROWS.ravel()] = np.einsum("ai,bj->abij", along, along).reshape(-1, 9)
    return values


def triangles_of_a_face(n: int) -> Array:
    """Numbers of its points [triangle, corner], seen counterclockwise."""
    i, j = np.divmod(np.arange(n * n), n)
    a = i * (n + 1) + j
    b, c, d = a + 1, a + n + 2, a + n + 1
    return np.stack([[a, b, c], [a, c, d]]).transpose(0, 2, 1).reshape(-1, 3)


class Skin:
    """Triangles of faces whose edges are cut into n parts. A vertex is there once
    for all triangles that go on smoothly into each other, with one material."""

    def __init__(self, faces: Faces, n: int) -> None:
        self.weights = shape_functions(n)
        self.rest, self.nodes = faces.rest, faces.nodes
        self.material, self.plane = faces.material, faces.plane
        x = self.at_points(self.rest)
        n_points = len(self.weights)
        keys = np.stack([place_keys(x, faces.size),
                         np.repeat(self.material[self.nodes[:, 8]], n_points),
                         np.repeat(self.plane, n_points)], axis=1)
        _, first, number = np.unique(keys, axis=0, return_index=True,
                                     return_inverse=True)
        local = triangles_of_a_face(n)
        corners = number.ravel()[(np.arange(len(self.nodes))[:, None, None] * n_points
                                  + local)].reshape(-1, 3)
        # Where a face is collapsed some have no area.
        corners = corners[(corners[:, 0] != corners[:, 1])
                          & (corners[:, 1] != corners[:, 2])
                          & (corners[:, 2] != corners[:, 0])]
        surface = pyvista.PolyData(
            x[first], np.insert(corners, 0, 3, axis=1).ravel())
        surface.point_data["first"] = first
        surface = surface.compute_normals(
            cell_normals=False, feature_angle=SHARP, split_vertices=True,
            consistent_normals=False)
        self.first = np.asarray(surface.point_data["first"])
        self.triangles = surface.faces.reshape(-1, 4)[:, 1:]

    def at_points(self, values: Array) -> Array:
        """A field at all points of all faces."""
        found = np.einsum("pi,fi...->fp...", self.weights, values[self.nodes])
        return np.asarray(found.reshape(-1, *found.shape[2:]))

    def at_vertices(self, values: Array) -> Array:
        return np.asarray(self.at_points(values)[self.first])

    def fits(self, faces: Faces) -> bool:
        """Whether these are the same faces of the same mesh at rest."""
        return all(np.array_equal(mine, other) for mine, other in (
            (self.nodes, faces.nodes), (self.rest, faces.rest),
            (self.plane, faces.plane), (self.material, faces.material)))


def moved(skin: Skin, faces: Faces) -> Array:
    """Where its vertices are, which are linear in the nodes."""
    return skin.at_vertices(faces.moved)
