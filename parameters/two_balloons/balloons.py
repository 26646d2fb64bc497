#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write a quarter of two spherical shells side by side as a mesh file of Gmsh:

    balloons.py FILE.msh [N THROUGH]

of the radii 1 and 2 mm, on the x axis, which a bar between them holds together. An
eighth of a shell has three patches of N by N cells, as of a cube that was blown up, and
THROUGH cells through the wall, of 27 nodes. The bar is one cell."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "balloon"))

from shell import HEXAHEDRON, face_of, make_shell, write_msh  # noqa: E402

APART = 4.1  # mm, of their middles
N_CELLS, THROUGH = 2, 2


def make_balloons(n=N_CELLS, through=THROUGH):
    """The nodes, and the elements by the name of what they are."""
    eighth, of_eighth = make_shell(1.0, 1.0, n, 27, through)
    place = {number: x for x, number in eighth.items()}
    # A cell that is mirrored is right-handed again with two axes exchanged.
    exchanged = [HEXAHEDRON.index((b, a, c)) for a, b, c in HEXAHEDRON]
    nodes = {}

    def put(element, side, middle, order=None):
        """The nodes of an element of the eighth that is on one side of a middle."""
        return [nodes.setdefault((round(middle + side * x, 12), y, z), len(nodes) + 1)
                for x, y, z in (place[element[i]] for i in
                                order or range(len(element)))]

    groups = {}
    for segment, middle in ((1, 0.0), (2, APART)):
        for name, elements in of_eighth.items():
            if name == "symmetry x":
                continue
            cells = name == "wall"
            name = {"wall": f"wall {segment}",
                    "inside": f"cavity {segment}"}.get(name, name)
            groups.setdefault(name, []).extend(
                put(element, side, middle,
                    exchanged if cells and side < 0 else None)
                for side in (1, -1) for element in elements)

    # From the pole of one to that of the other.
    pole = of_eighth["wall"][through - 1]
    outside = {(a, b): pole[i] for i, (a, b, c) in enumerate(HEXAHEDRON) if c == 2}
    bar = []
    for along, across, aside in HEXAHEDRON:
        x, y, z = place[outside[across, aside]]
        x += along / 2 * (APART - 2 * x)
        bar.append(nodes.setdefault((round(x, 12), y, z), len(nodes) + 1))
    groups["bar 1"] = [bar]
    groups["symmetry y"].append(face_of(bar, (1, 0)))
    groups["symmetry z"].append(face_of(bar, (2, 0)))
    return nodes, groups


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    write_msh(sys.argv[1], *make_balloons(*map(int, sys.argv[2:])))
