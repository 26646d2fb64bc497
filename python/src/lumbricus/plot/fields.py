# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a run: quadratic hexahedra with 27 nodes each, which no two
cells share. pyvista reads them; here is what their nodes are."""

import os
import pathlib
import warnings
from collections.abc import Mapping

import numpy as np
import pyvista

from .arrays import Array

N_NODES = 27
MIDDLE = 26  # the last node
# Simpson's rule: corners, edges, faces, middle.
MEAN_WEIGHTS = np.repeat([1, 4, 16, 64], [8, 12, 6, 1]) / 216

# Faces as VTK's biquadratic quadrilaterals with the normal outwards: corners,
# the edges between them, the middle.
FACES = np.array([[0, 4, 7, 3, 16, 15, 19, 11, 20],
                  [1, 2, 6, 5, 9, 18, 13, 17, 21],
                  [0, 1, 5, 4, 8, 17, 12, 16, 22],
                  [3, 7, 6, 2, 19, 14, 18, 10, 23],
                  [0, 3, 2, 1, 11, 10, 9, 8, 24],
                  [4, 5, 6, 7, 12, 13, 14, 15, 25]])
EDGES_OF_FACE = np.array([[0, 4, 1], [1, 5, 2], [2, 6, 3], [3, 7, 0]])

# A mirrored cell is right-handed when its nodes are counted in this order.
MIRRORED = np.array([1, 0, 3, 2, 5, 4, 7, 6, 8, 11, 10, 9, 12, 15, 14, 13,
                     17, 16, 19, 18, 21, 20, 22, 23, 24, 25, 26])


def read_series(folder: str | os.PathLike[str], name: str = "solution.pvd"
                ) -> list[tuple[float, pathlib.Path]]:
    """(time, file) of all times in a PVD file, in the order of the steps. Along a path
    times may go back: then the steps of the file are numbers, and its groups say the
    time, as 't=0.5'. Those of solution.pvd are PVTU files."""
    folder = pathlib.Path(folder)
    reader = pyvista.get_reader(str(folder / name))
    return [(float(data_set.group[2:]) if data_set.group.startswith("t=")
             else data_set.time, folder / data_set.path)
            for data_set in reader.datasets]


def read_grid(pvtu_file: str | os.PathLike[str]) -> pyvista.UnstructuredGrid:
    """All cells of all ranks at one time; the points are those at rest."""
    # A missing piece would only be a warning; here it is an error, said once.
    with (pyvista.VtkErrorCatcher(raise_errors=True, send_to_logging=False),
          warnings.catch_warnings()):
        warnings.simplefilter("ignore")
        grid = pyvista.read(pvtu_file)
    if grid.n_cells == 0 or grid.n_points != N_NODES * grid.n_cells:
        raise ValueError("it has no cells of 27 points")
    return grid


def read_obstacles(vtu_file: pathlib.Path) -> pyvista.PolyData:
    """The surfaces of all obstacles at one time, as quadrilaterals."""
    with pyvista.VtkErrorCatcher(raise_errors=True, send_to_logging=False):
        return pyvista.read(vtu_file).extract_surface(
            algorithm="dataset_surface", pass_pointid=False, pass_cellid=False)


def nodes_of_cells(grid: pyvista.UnstructuredGrid) -> Array:
    """Numbers of points [cell, node]."""
    return np.asarray(grid.cell_connectivity).reshape(-1, N_NODES)


def grid_of(points: Array, nodes: Array,
            fields: Mapping[str, Array]) -> pyvista.UnstructuredGrid:
    """A grid of cells with nodes [cell, node], of 27 nodes hexahedra, of 9
    quadrilaterals, with the points and fields of these cells only."""
    kind = {N_NODES: pyvista.CellType.LAGRANGE_HEXAHEDRON,
            9: pyvista.CellType.BIQUADRATIC_QUAD}[nodes.shape[1]]
    used = nodes.ravel()
    grid = pyvista.UnstructuredGrid(
        {kind: np.arange(len(used)).reshape(nodes.shape)}, points[used])
    for name, values in fields.items():
        grid.point_data[name] = values[used]
    return grid


def place_keys(points: Array, size: float) -> Array:
    """An integer for every place, the same for the same place in two cells of
    a body of that size."""
    lattice = np.floor(points / size * 1e4 + 0.4142).astype(np.int64)
    return np.asarray(lattice @ np.array([1 << 40, 1 << 20, 1]))


def have_no_partner(keys: Array, parts: Array) -> Array:
    """Whether a thing with its middle at keys[i], whose parts have theirs at
    parts[i], is nothing else's equal, part or whole. Where the mesh is refined,
    cells have parts of others as neighbours."""
    _, index, count = np.unique(keys, return_inverse=True, return_counts=True)
    return np.asarray((count[index] == 1) & ~np.isin(keys, parts)
                      & ~np.isin(parts, keys).any(axis=1))
