# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of cubes as a file of Gmsh, for tests that read one."""

import itertools
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent /
                       "parameters" / "balloon"))
import shell  # noqa: E402

HEXAHEDRON, QUADRILATERAL, TETRAHEDRON, HEXAHEDRON_20 = 5, 3, 4, 17
HEXAHEDRON_27, QUADRILATERAL_9, TETRAHEDRON_10 = 12, 10, 11
# Corners of a cell in the order of a hexahedron of Gmsh, and of its faces.
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
FACES = [[(1, 2, 6, 5), (0, 3, 7, 4)], [(3, 2, 6, 7), (0, 1, 5, 4)],
         [(4, 5, 6, 7), (0, 1, 2, 3)]]


class Mesh:
    """Cubes of unit edge in a row along x, as a file of Gmsh. Tests put the
    mistakes in."""

    def __init__(self, volumes=("wall", "wall")):
        self.version = "2.2 0 8"
        self.names = []  # (dimension, name); the tag is the place, from 1
        self.nodes = [[float(x), float(y), float(z)]
                      for x in range(len(volumes) + 1)
                      for y, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
        self.elements = []  # (type, tag, nodes from 1)
        for i, name in enumerate(volumes):
            self.add(HEXAHEDRON, name, range(4 * i + 1, 4 * i + 9))
        self.end = "$EndElements\n"

    def tag(self, dimension, name):
        if (dimension, name) not in self.names:
            self.names.append((dimension, name))
        return self.names.index((dimension, name)) + 1

    def add(self, kind, name, nodes):
        dimension = 2 if kind in (QUADRILATERAL, QUADRILATERAL_9) else 3
        tag = self.tag(dimension, name) if name else 0
        self.elements.append((kind, tag, list(nodes)))
        return self

    def surface(self, name, *nodes):
        return self.add(QUADRILATERAL, name, nodes)

    def move(self, node, *x):
        self.nodes[node - 1] = list(x)
        return self

    def __str__(self):
        lines = ["$MeshFormat", self.version, "$EndMeshFormat"]
        if self.names:
            lines += ["$PhysicalNames", len(self.names)]
            lines += [f'{dimension} {i + 1} "{name}"'
                      for i, (dimension, name) in enumerate(self.names)]
            lines += ["$EndPhysicalNames"]
        lines += ["$Nodes", len(self.nodes)]
        lines += [" ".join(map(str, [i + 1, *x]))
                  for i, x in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", len(self.elements)]
        lines += [" ".join(map(str, [i + 1, kind, 2, tag, 1, *nodes]))
                  for i, (kind, tag, nodes) in enumerate(self.elements)]
        return "\n".join(map(str, lines)) + "\n" + self.end


def second_order(*n_nodes):
    """Cubes of unit edge in a row along x, each with so many nodes; all of one place
    are one. The faces at x = 0 are the surface 'begin'."""
    mesh = Mesh(())
    mesh.nodes = []
    places = {}
    for i, n in enumerate(n_nodes):
        nodes = [places.setdefault((i + a / 2, b / 2, c / 2), len(places) + 1)
                 for a, b, c in shell.HEXAHEDRON[:n]]
        mesh.add(shell.KINDS[n][0], "wall", nodes)
        if i == 0 and n == 27:
            mesh.add(QUADRILATERAL_9, "begin", shell.face_of(nodes, (0, 0)))
    mesh.nodes = [list(place) for place in places]
    return mesh


def boxes(*cavities, left_out=(), symmetric=False, wall=None):
    """Boxes of 3 x 3 x 3 cells side by side along x, without the cell in the
    middle of each but where the cavity is called 'liquid'; box s is of segment s.
    The cavities have these names, and some directions of their faces are left out.
    Where it is symmetric, there is half of the only box, cut in its middle. A wall
    is a function that gives another name to a cell, by its place from zero."""
    mesh = Mesh(())
    mesh.nodes = []
    n = 3 * len(cavities)
    nodes = {}

    def number(x):
        if x not in nodes:
            nodes[x] = len(nodes) + 1
            mesh.nodes.append([float(c) for c in x])
        return nodes[x]

    def corner(cell, v):
        x = [c + d for c, d in zip(cell, CORNERS[v], strict=True)]
        if symmetric:
            x[2] = max(x[2], 1.5)
        return number(tuple(x))

    for cell in itertools.product(range(n), range(3), range(3)):
        if symmetric and cell[2] == 0:
            continue
        s = cell[0] // 3
        if (cell[0] % 3, *cell[1:]) == (1, 1, 1):
            if cavities[s] != "liquid":
                continue
            name = f"liquid {s + 1}"
        else:
            name = wall(cell) if wall else f"wall {s + 1}"
        corners = [corner(cell, v) for v in range(8)]
        mesh.add(HEXAHEDRON, name, corners)
        if symmetric and cell[2] == 1:
            mesh.surface("symmetry z", *corners[:4])
    for s, name in enumerate(cavities):
        for d, side in itertools.product(range(3), range(2)):
            # Faces of the cells beside the one that is left out.
            if name in (None, "liquid") or (d, side) in left_out or (
                    symmetric and (d, side) == (2, 0)):
                continue
            mesh.surface(name, *[corner((3 * s + 1, 1, 1), v)
                                 for v in FACES[d][1 - side]])
    return mesh
