#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write an eighth of a spherical shell as a mesh file of Gmsh:

    shell.py FILE.msh RADIUS THICKNESS N

Three patches of N by N cells, as of a cube that was blown up, one cell through
the thickness; the surface inside is called 'inside'."""
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


def make_shell(radius, thickness, n):
    """The nodes, and the elements by the name of what they are."""
    nodes = Nodes()
    groups = {"wall": [], "inside": [], "symmetry x": [], "symmetry y": [],
              "symmetry z": []}
    for axis in range(3):
        for i, j in itertools.product(range(n), repeat=2):
            corners = []
            for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)):
                direction = [0.] * 3
                direction[axis] = 1.
                direction[(axis + 1) % 3] = (i + k) / n
                direction[(axis + 2) % 3] = (j + m) / n
                corners.append(direction)
            inner = [nodes.number(c, radius) for c in corners]
            outer = [nodes.number(c, radius + thickness) for c in corners]
            groups["wall"].append(inner + outer)
            groups["inside"].append(inner)
            for a, b in ((0, 1), (1, 2), (2, 3), (3, 0)):
                for plane in range(3):
                    if corners[a][plane] == corners[b][plane] == 0.:
                        groups["symmetry " + "xyz"[plane]].append(
                            [inner[a], inner[b], outer[b], outer[a]])
    return nodes.numbers, groups


def write_msh(file_name, nodes, groups):
    """In the format 2.2, as text."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
             str(len(groups))]
    lines += [f'{3 if len(elements[0]) == 8 else 2} {tag} "{name}"'
              for tag, (name, elements) in enumerate(groups.items(), 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{number} {x} {y} {z}" for (x, y, z), number in nodes.items()]
    elements = [(5 if len(element) == 8 else 3, tag, element)
                for tag, of_group in enumerate(groups.values(), 1)
                for element in of_group]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number} {kind} 2 {tag} {tag} " + " ".join(map(str, element))
              for number, (kind, tag, element) in enumerate(elements, 1)]
    lines += ["$EndElements", ""]
    pathlib.Path(file_name).write_text("\n".join(lines))


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    write_msh(sys.argv[1], *make_shell(float(sys.argv[2]), float(sys.argv[3]),
                                       int(sys.argv[4])))
