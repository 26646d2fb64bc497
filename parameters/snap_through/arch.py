#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write half of a shallow arch as a mesh file of Gmsh: arch.py FILE.msh [CELLS]

An arc of a circle in the plane of x and y, from its crown, x = 0, to its foot, with one
cell of 27 nodes through the thickness and across."""
import pathlib
import sys
from math import cos, sin

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "balloon"))

from shell import HEXAHEDRON, face_of, write_msh  # noqa: E402

RADIUS, ANGLE, THICKNESS, WIDTH = 100.0, 0.1, 0.2, 0.2  # mm, and to one side
N_CELLS = 20


def make_arch(n=N_CELLS):
    """The nodes, and the elements by the name of what they are."""
    numbers = {}

    def node(along, across, through):
        angle = ANGLE * along / n
        r = RADIUS + THICKNESS * (through - 0.5)
        x = (round(r * sin(angle), 12), round(r * cos(angle) - RADIUS, 12),
             round(WIDTH * (across - 0.5), 12))
        return numbers.setdefault(x, len(numbers) + 1)

    groups = {"wall": [], "above": [], "foot": [], "symmetry x": []}
    for i in range(n):
        # Outwards, along, across: a right-handed frame would be (-y, x).
        element = [node(i + a / 2, 1 - b / 2, c / 2) for a, b, c in HEXAHEDRON]
        groups["wall"].append(element)
        groups["above"].append(face_of(element, (2, 2)))
        if i == 0:
            groups["symmetry x"].append(face_of(element, (0, 0)))
        if i == n - 1:
            groups["foot"].append(face_of(element, (0, 2)))
    return numbers, groups


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    write_msh(sys.argv[1], *make_arch(*map(int, sys.argv[2:])))
