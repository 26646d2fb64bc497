#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write an eighth of a spherical shell as a mesh file of Gmsh:

    shell.py FILE.msh RADIUS THICKNESS N [NODES]

Three patches of N by N cells, as of a cube that was blown up, one cell through
the thickness; the surface inside is called 'inside'. NODES is 8 for flat faces,
20 or 27 for curved ones."""
import itertools
import math
import pathlib
import sys


class Nodes:
    """Numbers points, each place once."""

    def __init__(self):
        self.numbers = {}

    def number(self, direction, radius):
        """Of the point at a radius, in the direction of a point of the cube."""
        angles = [math.tan(math.pi / 4 * c) for c in direction]
        size = math.sqrt(sum(a * a for a in angles))
        x = tuple(round(radius * a / size, 12) for a in angles)
        return self.numbers.setdefault(x, len(self.numbers) + 1)


# Twice the place of each of Gmsh's nodes of a hexahedron of 27: the eight corners
# first, then edges, faces and the middle. A hexahedron of 20 has no more than edges.
HEXAHEDRON = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2),
              (2, 2, 2), (0, 2, 2), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 1, 0),
              (2, 0, 1), (1, 2, 0), (2, 2, 1), (0, 2, 1), (1, 0, 2), (0, 1, 2),
              (2, 1, 2), (1, 2, 2), (1, 1, 0), (1, 0, 1), (0, 1, 1), (2, 1, 1),
              (1, 2, 1), (1, 1, 2), (1, 1, 1)]
# By the nodes of a hexahedron, those of its faces, and what Gmsh calls both.
FACES = {8: 4, 20: 8, 27: 9}
KINDS = {8: (5, 3), 20: (17, 16), 27: (12, 10)}


def face_of(element, place):
    """The nodes of the face on which all that are there have that place, in the
    order of Gmsh: corners, edges between them, the middle."""
    at = {HEXAHEDRON[i]: node for i, node in enumerate(element)}
    axis, value = place
    others = [d for d in range(3) if d != axis]

    def node(a, b):
        x = [value] * 3
        x[others[0]], x[others[1]] = a, b
        return at[tuple(x)]
    corners = [(0, 0), (2, 0), (2, 2), (0, 2)]
    edges = [(1, 0), (2, 1), (1, 2), (0, 1)]
    return [node(*x) for x in (corners + edges + [(1, 1)])[:FACES[len(element)]]]


def make_shell(radius, thickness, n, n_nodes=8, through=1):
    """The nodes, and the elements by the name of what they are."""
    nodes = Nodes()
    groups = {"wall": [], "inside": [], "symmetry x": [], "symmetry y": [],
              "symmetry z": []}
    for axis, i, j, k in itertools.product(range(3), range(n), range(n),
                                           range(through)):
        element = []
        for a, b, c in HEXAHEDRON[:n_nodes]:
            direction = [0.] * 3
            direction[axis] = 1.
            direction[(axis + 1) % 3] = (i + a / 2) / n
            direction[(axis + 2) % 3] = (j + b / 2) / n
            element.append(nodes.number(
                direction, radius + thickness * (k + c / 2) / through))
        groups["wall"].append(element)
        if k == 0:
            groups["inside"].append(face_of(element, (2, 0)))
        for side, at in ((0, i), (1, j)):
            if at == 0:
                plane = "symmetry " + "xyz"[(axis + 1 + side) % 3]
                groups[plane].append(face_of(element, (side, 0)))
    return nodes.numbers, groups


def write_msh(file_name, nodes, groups):
    """In the format 2.2, as text."""
    n_nodes = max(len(elements[0]) for elements in groups.values())

    def is_face(name):
        return len(groups[name][0]) < n_nodes
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
             str(len(groups))]
    lines += [f'{2 if is_face(name) else 3} {tag} "{name}"'
              for tag, (name, elements) in enumerate(groups.items(), 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{number} {x} {y} {z}" for (x, y, z), number in nodes.items()]
    elements = [(KINDS[n_nodes][is_face(name)], tag, element)
                for tag, (name, of_group) in enumerate(groups.items(), 1)
                for element in of_group]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number} {kind} 2 {tag} {tag} " + " ".join(map(str, element))
              for number, (kind, tag, element) in enumerate(elements, 1)]
    lines += ["$EndElements", ""]
    pathlib.Path(file_name).write_text("\n".join(lines))


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6):
        sys.exit(__doc__)
    write_msh(sys.argv[1], *make_shell(float(sys.argv[2]), float(sys.argv[3]),
                                       *map(int, sys.argv[4:])))
