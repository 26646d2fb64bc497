# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read what a run leaves in its folder: needs NumPy only."""

import base64
import pathlib
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

# Place in the lattice (i, j, k) of the 27 points of a quadratic VTK hexahedron:
# corners, edges, faces, middle.
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0),
           (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
EDGES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0),
         (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]
FACES = [(0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1), (1, 1, 0), (1, 1, 2)]
LATTICE = CORNERS + EDGES + FACES + [(1, 1, 1)]


def read_parameters(folder):
    """The values of parameters.prm by "Section/Subsection/Name"."""
    values, path = {}, []
    text = (pathlib.Path(folder) / "parameters.prm").read_text()
    # A backslash at the end of a line joins the next to it.
    for line in re.sub(r"\\\n\s*", "", text).splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            path.append(line[len("subsection "):].strip())
        elif line == "end":
            path.pop()
        elif line.startswith("set "):
            name, _, value = line[len("set "):].partition("=")
            values["/".join(path + [name.strip()])] = value.strip()
    return values


def read_physical_names(mesh_file):
    """The names of the volumes and of the surfaces in a mesh of Gmsh, each in
    the order of their tags."""
    names = {2: {}, 3: {}}
    text = pathlib.Path(mesh_file).read_text()
    text = text[:text.index("$EndPhysicalNames")]
    for dimension, tag, name in re.findall(r'^(\d) (\d+) "(.*)"', text, re.M):
        names.setdefault(int(dimension), {})[int(tag)] = name.strip()
    return tuple([name for _, name in sorted(names[d].items())]
                 for d in (3, 2))


def read_table(file_name):
    """The columns of a CSV table by name."""
    table = np.genfromtxt(file_name, delimiter=",", names=True, ndmin=1)
    return {name: table[name] for name in table.dtype.names}


def read_series(folder):
    """(time, PVTU file) of all times in solution.pvd."""
    folder = pathlib.Path(folder)
    root = ElementTree.parse(folder / "solution.pvd").getroot()
    return [(float(data_set.get("timestep")), folder / data_set.get("file"))
            for data_set in root.iter("DataSet")]


def read_array(element, compressed):
    kinds = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4",
             "Int64": "<i8", "UInt8": "u1"}
    kind = kinds[element.get("type")]
    text = "".join(element.text.split())
    if element.get("format") == "ascii":
        values = np.array(element.text.split(), dtype=kind)
    elif not compressed:
        values = np.frombuffer(base64.b64decode(text)[4:], dtype=kind)
    else:
        # Number of blocks, their size, that of the last, and the compressed
        # sizes of all; then the blocks.
        n_blocks = int(np.frombuffer(base64.b64decode(text[:8])[:4], "<u4")[0])
        n_letters = 4 * ((4 * (3 + n_blocks) + 2) // 3)
        sizes = np.frombuffer(base64.b64decode(text[:n_letters]),
                              "<u4")[3:3 + n_blocks]
        data, begin, blocks = base64.b64decode(text[n_letters:]), 0, []
        for size in sizes:
            blocks.append(zlib.decompress(data[begin:begin + size]))
            begin += size
        values = np.frombuffer(b"".join(blocks), dtype=kind)
    n_components = int(element.get("NumberOfComponents", 1))
    return values.reshape(-1, n_components) if n_components > 1 else values


def read_piece(file_name):
    root = ElementTree.parse(file_name).getroot()
    compressed = root.get("compressor") is not None
    arrays = {}
    for piece in root.iter("Piece"):
        if int(piece.get("NumberOfCells")) == 0:
            return None
        arrays["points"] = read_array(piece.find("Points/DataArray"),
                                      compressed)
        for place in ("Cells", "PointData"):
            for element in piece.findall(place + "/DataArray"):
                arrays[element.get("Name")] = read_array(element, compressed)
    return arrays


def on_lattice(arrays):
    """All point fields as [cell, i, j, k, ...]: 27 points a cell."""
    connectivity = arrays.pop("connectivity").reshape(-1, 27)
    arrays.pop("offsets")
    arrays.pop("types")

    # Files of VTK before version 9 have two of the edges the other way round.
    order = list(LATTICE)
    X = arrays["points"][connectivity]

    def misfit(edge, a, b):
        return np.abs(X[:, edge] - 0.5 * (X[:, a] + X[:, b])).sum()

    if misfit(18, 3, 7) + misfit(19, 2, 6) < misfit(18, 2, 6) + misfit(19, 3, 7):
        order[18], order[19] = order[19], order[18]

    place = np.empty((3, 3, 3), dtype=int)
    for number, (i, j, k) in enumerate(order):
        place[i, j, k] = number
    return {name: values[connectivity][:, place]
            for name, values in arrays.items()}


def read_solution(pvtu_file):
    """
    All fields of a time, joined over the ranks: each an array
    [cell, i, j, k, ...] on the 3 x 3 x 3 points of its quadratic hexahedra.
    "points" are the reference positions.
    """
    pvtu_file = pathlib.Path(pvtu_file)
    root = ElementTree.parse(pvtu_file).getroot()
    pieces = [read_piece(pvtu_file.parent / piece.get("Source"))
              for piece in root.iter("Piece")]
    pieces = [on_lattice(piece) for piece in pieces if piece is not None]
    return {name: np.concatenate([piece[name] for piece in pieces])
            for name in pieces[0]}
