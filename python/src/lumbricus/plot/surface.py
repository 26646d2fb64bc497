# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is seen of a body that is cut open: its deformed surface with colours,
the lines on the cut, and its fibres."""

import pathlib
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pyvista

from .activation import activation_of
from .arrays import Array
from .body import ON_PLANE, Body
from .fields import (
    EDGES_OF_FACE,
    FACES,
    MIDDLE,
    grid_of,
    have_no_partner,
    nodes_of_cells,
    place_keys,
    read_grid,
    read_obstacles,
)

# A curved face is drawn as 2^n x 2^n pairs of triangles, fewer of many faces.
SUBDIVISIONS, SUBDIVISIONS_OF_MANY, MANY = 3, 2, 1500
SHARP = 35           # degrees between faces that meet in an edge
ALONG_EDGE = 9       # points of a curved line
LONGEST = 0.6        # of a drawn fibre, in lengths of a face
ACROSS = 0.25        # fibres with less than this in a face are dots


def on_edge(s: Any) -> Array:
    """The quadratic functions of begin, middle and end of an edge at s."""
    return np.stack([(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)],
                    axis=-1)


CURVE = on_edge(np.linspace(0, 1, ALONG_EDGE))
HALVES = on_edge(np.array([0.25, 0.75]))
# The shape functions of a face's nine nodes in the middles of its quarters;
# the nine nodes lie in three rows of three.
ROWS = np.array([[0, 4, 1], [7, 8, 5], [3, 6, 2]])
QUARTERS = np.zeros((4, 9))
QUARTERS[:, ROWS.ravel()] = np.einsum(
    "ai,bj->abij", HALVES, HALVES).reshape(4, 9)


def contraction(fields: Mapping[str, Array]) -> Array:
    """How much shorter [%] than at rest the most active fibres want to be, or which
    part [%] of its tension a muscle has that pulls."""
    active = [found[1](values) for name, values in fields.items()
              if (found := activation_of(name))]
    if not active:
        return np.zeros(len(fields["tissue"]))
    return np.asarray(100 * np.max(active, axis=0))


def materials(fields: Mapping[str, Array], middles: Array) -> Array:
    """Of every cell a number for its tissue, segment and muscles: where it
    differs, colours do not pass into each other."""
    columns = [np.round(fields["tissue"]), np.round(fields["segment"])]
    columns += [np.linalg.norm(values, axis=1) > 0
                for name, values in fields.items() if name.startswith("fibre_")]
    return np.unique(np.stack([c[middles] for c in columns], axis=1), axis=0,
                     return_inverse=True)[1].ravel()


class Faces:
    """The faces that belong to one cell only."""

    def __init__(self, grid: pyvista.UnstructuredGrid,
                 planes: Sequence[tuple[int, float]]) -> None:
        """Of a body that is cut open along these planes, see Body.cut()."""
        self.rest = grid.points
        self.fields = grid.point_data
        self.moved = self.rest + self.fields["displacement"]
        cells = nodes_of_cells(grid)
        self.material = np.empty(len(self.rest), dtype=int)
        self.material[cells] = materials(self.fields,
                                         cells[:, MIDDLE])[:, None]
        nodes = cells[:, FACES].reshape(-1, 9)
        self.size = np.ptp(self.rest)
        outer = have_no_partner(
            place_keys(self.rest[nodes[:, 8]], self.size),
            place_keys(np.einsum("pi,fic->fpc", QUARTERS, self.rest[nodes]),
                         self.size))
        self.nodes = nodes[outer]
        # Number of the plane of the cut, from 1, in which a face lies.
        self.plane = np.zeros(len(self.nodes), dtype=int)
        for number, (d, position) in enumerate(planes, 1):
            distance = np.abs(self.rest[self.nodes][..., d] - position)
            self.plane[distance.max(axis=1) < ON_PLANE * self.size] = number

    def surface(self, chosen: Array) -> pyvista.PolyData:
        """The chosen ones as smooth triangles with fields."""
        fields = {name: self.fields[name]
                  for name in ("displacement", "pressure", "tissue")}
        fields["contraction"] = contraction(self.fields)
        fields["material"] = self.material
        faces = grid_of(self.rest, self.nodes[chosen], fields)
        faces = faces.clean(tolerance=1e-5, merging_array_name="material")
        surface = faces.extract_surface(
            nonlinear_subdivision=(SUBDIVISIONS if faces.n_cells < MANY
                                   else SUBDIVISIONS_OF_MANY),
            algorithm="dataset_surface", pass_pointid=False,
            pass_cellid=False)
        surface.points += surface["displacement"]
        return surface.compute_normals(
            cell_normals=False, feature_angle=SHARP, split_vertices=True,
            consistent_normals=False)

    def lines(self, with_mesh: bool) -> pyvista.PolyData:
        """Lines on the cut, around all cells or around the tissues: edges that
        only one cell of a tissue has in that plane."""
        found = [np.zeros((0, 3), dtype=int)]
        for number in (1, 2):
            nodes = self.nodes[self.plane == number]
            edges = nodes[:, EDGES_OF_FACE].reshape(-1, 3)
            if not with_mesh and len(edges):
                x = self.rest[edges]
                halves = np.einsum("ai,eic->eac", HALVES, x)
                tissue = np.round(self.fields["tissue"][edges[:, 1]])
                keys = place_keys(np.concatenate([x[:, 1:2], halves], axis=1),
                                  self.size) * 64 + tissue.astype(int)[:, None]
                edges = edges[have_no_partner(keys[:, 0], keys[:, 1:])]
            found.append(edges)
        x = np.einsum("ai,eic->eac", CURVE,
                      self.moved[np.concatenate(found)])
        return polylines(x)

    def fibres(self) -> tuple[pyvista.PolyData, pyvista.PolyData]:
        """A short line along the fibre of every muscle in the middle of every
        face, and a point where it crosses the face."""
        x = self.moved[self.nodes]
        place = x[:, 8]
        normal = np.cross(x[:, 5] - x[:, 7], x[:, 6] - x[:, 4])
        area = np.linalg.norm(normal, axis=1)
        normal /= area[:, None] + 1e-300
        lines, dots = [np.zeros((0, 2, 3))], [np.zeros((0, 3))]
        for name in self.fields:
            if not name.startswith("fibre_"):
                continue
            f = self.fields[name][self.nodes[:, 8]]
            there = np.linalg.norm(f, axis=1) > 0
            f = f / np.where(there, np.linalg.norm(f, axis=1), 1)[:, None]
            f -= np.sum(f * normal, axis=1)[:, None] * normal
            flat = there & (np.linalg.norm(f, axis=1) > ACROSS)
            half = 0.5 * LONGEST * np.sqrt(area)[:, None] * f
            lines.append(np.stack([place - half, place + half], axis=1)[flat])
            dots.append(place[there & ~flat])
        points = np.concatenate(dots)
        return (polylines(np.concatenate(lines)),
                pyvista.PolyData(points) if len(points) else pyvista.PolyData())


def polylines(points: Array) -> pyvista.PolyData:
    """Lines through points [line, point, 3]."""
    n_lines, n = points.shape[:2]
    numbers = np.arange(n_lines * n).reshape(n_lines, n)
    return pyvista.PolyData(
        points.reshape(-1, 3),
        lines=np.insert(numbers, 0, n, axis=1).ravel() if n_lines else None)


class Drawing:
    """All that is drawn of one time."""

    def __init__(self, pvtu_file: pathlib.Path, body: Body, with_mesh: bool,
                 with_fibres: bool, obstacles_file: pathlib.Path | None = None) -> None:
        faces = Faces(*body.opened(read_grid(pvtu_file)))
        # What is cut is drawn flat, so that its colour can be read.
        self.outside = faces.surface(faces.plane == 0)
        self.cuts = [faces.surface(faces.plane == number) for number in (1, 2)
                     if (faces.plane == number).any()]
        self.lines = faces.lines(with_mesh)
        self.fibres = faces.fibres() if with_fibres else None
        self.obstacles = (None if obstacles_file is None
                          else read_obstacles(obstacles_file))
        for surface in (self.outside, *self.cuts):
            surface["liquid"] = np.isin(np.round(surface["tissue"]),
                                        body.liquid_tissues)

    @property
    def surfaces(self) -> list[pyvista.PolyData]:
        return [self.outside, *self.cuts]
