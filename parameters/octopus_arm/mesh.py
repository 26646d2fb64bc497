#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Write arm.msh beside this file: a cone of four tissues, one in the other, whose radii
are all in proportion. A section has a core of four cells and three rings of eight, so
that the planes y = 0 and z = 0 are between cells.
"""
import pathlib
from math import cos, pi, sin

# Outer radius of each tissue over that of the arm, from inside to outside.
TISSUES = {"nerve cord": 0.2, "transverse muscle": 0.6,
           "longitudinal muscle": 0.92, "oblique muscle": 1.0}
BASE, TIP, LENGTH = 6.0, 2.0, 80.0  # radii and length [mm]
N_ALONG, N_AROUND = 16, 8           # cells


def quads():
    """The cells of a section by tissue, as four points (ring, angle); ring 0 is the
    axis. And the faces between two angles on each ring."""
    core = [[(0, 0), (1, k), (1, k + 1), (1, k + 2)]
            for k in range(0, N_AROUND, 2)]
    cells = {"nerve cord": core}
    for ring, tissue in enumerate(list(TISSUES)[1:], 1):
        cells[tissue] = [[(ring, k), (ring + 1, k), (ring + 1, k + 1),
                          (ring, k + 1)] for k in range(N_AROUND)]
    sides = {ring: [((ring, k), (ring, k + 1)) for k in range(N_AROUND)]
             for ring in range(2, len(TISSUES) + 1)}
    return cells, sides


def write(path, base=BASE, tip=TIP, length=LENGTH, n_along=N_ALONG):
    """A mesh of Gmsh's format 2.2."""
    numbers, positions = {}, []

    def node(station, point):
        ring, k = point[0], point[1] % N_AROUND if point[0] else 0
        if (station, ring, k) not in numbers:
            part = station / n_along
            r = (base + (tip - base) * part) * ([0] + list(TISSUES.values()))[ring]
            angle = 2 * pi * k / N_AROUND
            positions.append((length * part, r * cos(angle), r * sin(angle)))
            numbers[station, ring, k] = len(positions)
        return numbers[station, ring, k]

    cells, sides = quads()
    every = [quad for group in cells.values() for quad in group]
    groups = [(2, "base", [[node(0, p) for p in quad] for quad in every]),
              (2, "tip", [[node(n_along, p) for p in quad] for quad in every])]
    names = ["around transverse", "around longitudinal", "skin"]
    groups += [(2, name, [[node(s, p), node(s, q), node(s + 1, q), node(s + 1, p)]
                          for s in range(n_along) for p, q in ring])
               for name, ring in zip(names, sides.values(), strict=True)]
    groups += [(3, tissue, [[node(s, p) for p in quad] +
                            [node(s + 1, p) for p in quad]
                            for s in range(n_along) for quad in group])
               for tissue, group in cells.items()]

    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
             str(len(groups))]
    lines += [f'{d} {i} "{name}"' for i, (d, name, _) in enumerate(groups, 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(positions))]
    lines += [f"{n} {x:.12g} {y:.12g} {z:.12g}"
              for n, (x, y, z) in enumerate(positions, 1)]
    lines += ["$EndNodes", "$Elements", str(sum(len(g[2]) for g in groups))]
    elements = ((i, d, element) for i, (d, _, group) in enumerate(groups, 1)
                for element in group)
    lines += [f"{n} {3 if d == 2 else 5} 2 {i} {i} " + " ".join(map(str, element))
              for n, (i, d, element) in enumerate(elements, 1)]
    pathlib.Path(path).write_text("\n".join([*lines, "$EndElements", ""]))


if __name__ == "__main__":
    write(pathlib.Path(__file__).with_name("arm.msh"))
