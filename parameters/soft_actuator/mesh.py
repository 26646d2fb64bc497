#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Write body.msh, the half y >= 0 of the finger, beside this file; and cavity.msh, the
same with all of the inside in one physical surface, 'cavity 1'. That one is not round as
a whole, but the sections of the wall are, and they have all edges of the round part.
"""
import pathlib
from math import cos, pi, sin

A, B, C = 2.0, 3.0, 3.25  # radii: chamber, soft wall, rings [mm]
CAP = 1.0                 # thickness of the caps
PITCH, WIDTH = 1.0, 0.25  # from ring to ring, and of a ring
N_RINGS = 16
N_ANGLE = 4               # cells around the half; the lowest carries the strip

# Stations along the axis, and whether there is a ring between one and the next.
stations, kinds = [0.0, CAP], ["cap"]
for ring in range(N_RINGS):
    middle = CAP + PITCH * (ring + 0.5)
    stations += [middle - WIDTH / 2, middle + WIDTH / 2]
    kinds += ["gap", "ring"]
stations += [CAP + PITCH * N_RINGS, 2 * CAP + PITCH * N_RINGS]
kinds += ["gap", "cap"]

# The section: a point on the axis, then rows of points from the top (z > 0) to the
# bottom, around the core of the caps and on the three circles.
points = [(0.0, 0.0)]


def row(radius, square=False):
    first = len(points)
    for k in range(N_ANGLE + 1):
        angle = pi * k / N_ANGLE
        r = radius * (1.13 if square and k % 2 else 1)
        y = 0.0 if k in (0, N_ANGLE) else r * sin(angle)
        points.append((y, r * cos(angle)))
    return list(range(first, first + N_ANGLE + 1))


rows = [row(0.5 * A, True), row(A), row(B), row(C)]


def between(inner, outer, k):
    return [rows[inner][k + 1], rows[inner][k], rows[outer][k],
            rows[outer][k + 1]]


core = [[0, rows[0][k + 2], rows[0][k + 1], rows[0][k]]
        for k in range(0, N_ANGLE, 2)]

nodes, cells, surfaces = {}, {}, {}


def node(station, point):
    return nodes.setdefault((station, point), len(nodes) + 1)


def add_cell(tissue, s, quad):
    cells.setdefault(tissue, []).append(
        [node(s, p) for p in quad] + [node(s + 1, p) for p in quad])


def add_side(name, s, p, q):
    surfaces.setdefault(name, []).append(
        [node(s, p), node(s, q), node(s + 1, q), node(s + 1, p)])


def add_end(name, s, quad):
    surfaces.setdefault(name, []).append([node(s, p) for p in quad])


last = len(kinds) - 1
for s, kind in enumerate(kinds):
    quads = [(0, 1, k) for k in range(N_ANGLE)] if kind == "cap" else []
    quads += [(1, 2, k) for k in range(N_ANGLE)]
    if kind == "cap":
        for quad in core:
            add_cell("cap", s, quad)
        add_side("symmetry y", s, 0, rows[0][0])
        add_side("symmetry y", s, 0, rows[0][-1])
    if kind == "ring":
        quads += [(2, 3, k) for k in range(N_ANGLE)]
    elif kind == "gap":
        quads += [(2, 3, N_ANGLE - 1)]
    if kind != "cap":
        for k in range(N_ANGLE):
            add_end("sections", s, between(1, 2, k))
            if s == last - 1:
                add_end("sections", last, between(1, 2, k))
    for inner, outer, k in quads:
        tissue = ("cap" if kind == "cap" else "wall" if inner == 1 else
                  "ring" if kind == "ring" else "strip")
        add_cell(tissue, s, between(inner, outer, k))
        if k == 0:
            add_side("symmetry y", s, rows[inner][0], rows[outer][0])
        if k == N_ANGLE - 1:
            add_side("symmetry y", s, rows[inner][-1], rows[outer][-1])
        if inner == 1 and kind != "cap":
            add_side("chamber", s, rows[1][k], rows[1][k + 1])
        if inner == 1:
            add_side("surface", s, rows[2][k], rows[2][k + 1])
        if inner == 2:
            add_side("rim", s, rows[3][k], rows[3][k + 1])
    if kind == "cap":
        section = core + [between(0, 1, k) for k in range(N_ANGLE)]
        for quad in section:
            add_end("ends of the chamber", 1 if s == 0 else last, quad)
        for quad in section + [between(1, 2, k) for k in range(N_ANGLE)]:
            add_end("base" if s == 0 else "tip", 0 if s == 0 else last + 1, quad)

INSIDE = ("chamber", "ends of the chamber")


def write(file, surfaces):
    groups = ([(2, name, surfaces[name]) for name in surfaces] +
              [(3, name, cells[name]) for name in ("wall", "ring", "strip", "cap")])
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
             str(len(groups))]
    lines += [f'{d} {i} "{name}"' for i, (d, name, _) in enumerate(groups, 1)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{n} {stations[s]:.12g} {points[p][0]:.12g} {points[p][1]:.12g}"
              for (s, p), n in nodes.items()]
    lines += ["$EndNodes", "$Elements", str(sum(len(g[2]) for g in groups))]
    number = 0
    for i, (d, _, elements) in enumerate(groups, 1):
        for element in elements:
            number += 1
            lines.append(f"{number} {3 if d == 2 else 5} 2 {i} {i} " +
                         " ".join(map(str, element)))
    lines += ["$EndElements", ""]
    pathlib.Path(__file__).with_name(file).write_text("\n".join(lines))


sections = surfaces.pop("sections")
write("body.msh", surfaces)
inside = sum((surfaces.pop(name) for name in INSIDE), [])
write("cavity.msh", {**surfaces, "cavity 1": inside, "sections": sections})
