#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write a quarter of a thin septum in a ring as a mesh file of Gmsh:

    septum.py FILE.msh [N]

A disc across the x axis, the septum out to RADIUS and the ring beyond it, in one layer
of cells of 27 nodes: N by N in the middle, N by N in each of two patches around it, and 2
across the ring."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "balloon"))

from shell import HEXAHEDRON, face_of, write_msh  # noqa: E402

RADIUS, OUTSIDE, THICKNESS = 2.0, 2.6, 0.1  # mm
CORE, N_RING, N_CELLS = 0.5, 2, 3


def place(patch, s, q):
    """Where a patch is at the part s of its arc and q of the way from the core (0) over
    the edge of the septum (1) to the outside (2); patch 0 is the core."""
    c = CORE * RADIUS
    if patch == 0:
        # A square with edges that bulge a little.
        return (c * s * (1 - 0.15 * q * q), c * q * (1 - 0.15 * s * s))
    angle = math.pi / 4 * s
    arc = (math.cos(angle), math.sin(angle))
    edge = (c * (1 - 0.15 * s * s), c * s * 0.85)
    if q <= 1:
        y, z = ((1 - q) * e + q * RADIUS * a for e, a in zip(edge, arc))
    else:
        y, z = ((RADIUS + (q - 1) * (OUTSIDE - RADIUS)) * a for a in arc)
    return (y, z) if patch == 1 else (z, y)


def make_septum(n=N_CELLS):
    """The nodes, and the elements by the name of what they are."""
    nodes = {}
    groups = {"septum 1": [], "ring 1": [], "held": [], "symmetry y": [],
              "symmetry z": []}

    def put(patch, s, q, x):
        y, z = place(patch, s, q)
        key = (round(x, 12), round(y, 10) + 0.0, round(z, 10) + 0.0)
        return nodes.setdefault(key, len(nodes) + 1)

    for patch in range(3):
        radial = [i / n for i in range(n + 1)]
        if patch > 0:
            radial += [1 + (i + 1) / N_RING for i in range(N_RING)]
        for j, (q, q_next) in enumerate(zip(radial, radial[1:])):
            for i in range(n):
                # (s, q, x) is right-handed in the core and, mirrored, in patch 2.
                element = []
                for a, b, c in HEXAHEDRON:
                    if patch == 1:
                        a, b = b, a
                    element.append(put(patch, (i + a / 2) / n,
                                       q + b / 2 * (q_next - q),
                                       THICKNESS * (c / 2 - 0.5)))
                is_ring = patch > 0 and j >= n
                groups["ring 1" if is_ring else "septum 1"].append(element)
                along = 1 if patch == 1 else 0  # the place of s
                if is_ring:
                    groups["held"] += [face_of(element, (2, 0)),
                                       face_of(element, (2, 2))]
                if i == 0:
                    groups[("symmetry y", "symmetry z", "symmetry y")[patch]].append(
                        face_of(element, (along, 0)))
                if patch == 0 and j == 0:
                    groups["symmetry z"].append(face_of(element, (1, 0)))
    return nodes, groups


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    write_msh(sys.argv[1], *make_septum(*map(int, sys.argv[2:])))
