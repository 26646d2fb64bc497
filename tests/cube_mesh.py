# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of cubes as a file of Gmsh, for tests that read one."""

HEXAHEDRON, QUADRILATERAL, TETRAHEDRON, HEXAHEDRON_20 = 5, 3, 4, 17


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
        dimension = 2 if kind == QUADRILATERAL else 3
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
