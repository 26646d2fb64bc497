#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write fibres.csv: fibres in the wall of body.msh that run from one end of the
body to the other, straight along the tube and around its ends. A line for every
cell of the wall, with its centre and a unit vector."""
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
HEXAHEDRON = 5


def section(lines, name):
    """The lines between $name and $Endname, split into words."""
    begin = lines.index("$" + name)
    end = lines.index("$End" + name)
    return iter([line.split() for line in lines[begin + 1:end]])


def read(path, tissue):
    """The corners of every cell of a physical volume, from a file of Gmsh in
    its format 4.1."""
    lines = path.read_text().splitlines()

    tag = None
    for words in section(lines, "PhysicalNames"):
        if words[0] == "3" and " ".join(words[2:]).strip('"') == tissue:
            tag = words[1]

    entities = section(lines, "Entities")
    counts = [int(word) for word in next(entities)]
    volumes = set()
    for dimension, n in enumerate(counts):
        for _ in range(n):
            words = next(entities)
            if dimension == 3 and words[7] == "1" and words[8] == tag:
                volumes.add(words[0])

    position = {}
    nodes = section(lines, "Nodes")
    for _ in range(int(next(nodes)[0])):
        n = int(next(nodes)[3])
        names = [next(nodes)[0] for _ in range(n)]
        for name in names:
            position[name] = [float(word) for word in next(nodes)[:3]]

    cells = []
    elements = section(lines, "Elements")
    for _ in range(int(next(elements)[0])):
        dimension, entity, kind, n = next(elements)
        block = [next(elements)[1:] for _ in range(int(n))]
        if (dimension == "3" and entity in volumes
                and int(kind) == HEXAHEDRON):
            cells += [[position[node] for node in cell] for cell in block]
    return cells


def along_the_body(x, y, z, radius=2., length=10.):
    """The direction of a meridian: along x in the tube, a quarter of a circle
    about the centre of the ball at either end."""
    dx = min(x - radius, 0.) + max(x - (length - radius), 0.)
    r = math.hypot(y, z)
    size = math.hypot(r, dx)
    return r / size, -dx / size * y / r, -dx / size * z / r


with open(HERE / "fibres.csv", "w") as out:
    print("x, y, z, fx, fy, fz", file=out)
    for cell in read(HERE / "body.msh", "wall"):
        X = [sum(corner[d] for corner in cell) / 8 for d in range(3)]
        print(", ".join(f"{value:.8g}" for value in (*X, *along_the_body(*X))),
              file=out)
