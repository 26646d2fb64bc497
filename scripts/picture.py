#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draw a run: RUN_DIR/picture.png shows the deformed body at several times, cut
open, and RUN_DIR/segments.png the table of the segments over time. Needs NumPy
and Matplotlib (with Pillow), no display.
"""

import argparse
import io
import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, Normalize
from PIL import Image

from run_output import (read_parameters, read_physical_names, read_series,
                        read_solution, read_table)

N_SUBDIVISIONS = 4  # quadrilaterals along an edge of a drawn face
LIQUID_COLOURS = plt.get_cmap("YlGnBu")
MUSCLE_COLOURS = LinearSegmentedColormap.from_list(
    "muscle", ["#f3e0d5", "#e39a83", "#c0392b", "#6d1010"])


def unit(v):
    return np.asarray(v) / np.linalg.norm(v)


class View:
    """A parallel projection; the axis of the body runs to the right."""

    def __init__(self, towards_viewer):
        self.normal = unit(towards_viewer)
        self.right = unit([1, 0, 0] - self.normal[0] * self.normal)
        self.up = np.cross(self.normal, self.right)

    def project(self, x):
        return np.stack([x @ self.right, x @ self.up], axis=-1)


# A little from above and from the tail. Of a round body, the quarter y < 0, z > 0
# faces the viewer and is left out.
VIEW = View([0.28, -0.82, 0.5])
LIGHT = unit([-0.1, -0.6, 0.8])


class Body:
    """What the parameters say of the mesh: symmetry and liquid."""

    def __init__(self, parameters):
        shape = parameters["Geometry/Shape"]

        def get(name, default=""):
            return parameters.get(f"Geometry/{shape}/{name}", default)

        part = get("Cross-section", "full")
        self.mirrors = {"full": [], "half": [1], "quarter": [1, 2]}[part]
        if shape == "block":
            axes = [s.strip() for s in get("Symmetry").split(",")]
            self.mirrors = [d for d, a in enumerate("xyz") if a in axes]
        # The planes through the axis, or of symmetry, along which it is cut open.
        self.cut = [1, 2] if shape != "block" else self.mirrors[:2]
        if shape == "mesh file":
            volumes, surfaces = read_physical_names(get("File"))
            self.mirrors = [d for d, a in enumerate("xyz")
                            if "symmetry " + a in surfaces]
            liquids = [s.strip() for s in get("Liquid tissues").split(",")]
            tissues = list(dict.fromkeys(re.sub(r"\s+\d+$", "", name)
                                         for name in volumes))
            self.liquid_tissues = [i for i, name in enumerate(tissues)
                                   if name in liquids]
            return
        has_liquid = {"segment chain": "true",
                      "open cylinder": get("Filled"),
                      "block": get("Liquid")}[shape] == "true"
        self.liquid_tissues = [0] if has_liquid else []


def mirrored(fields, d):
    """The fields with their image in the plane x_d = 0."""
    image = {}
    for name, values in fields.items():
        # Turning one lattice direction keeps the cells right-handed.
        flipped = values[:, ::-1].copy()
        if name in ("points", "displacement"):
            flipped[..., d] *= -1
        image[name] = np.concatenate([values, flipped])
    return image


def select(fields, cells):
    return {name: values[cells] for name, values in fields.items()}


def opened_body(pvtu_file, body):
    """The whole body without the part before both planes of the cut."""
    fields = read_solution(pvtu_file)
    for d in body.mirrors:
        fields = mirrored(fields, d)
    if len(body.cut) < 2:
        return fields
    middle = fields["points"][:, 1, 1, 1]
    behind = middle[:, body.cut] * VIEW.normal[body.cut] < 0
    return select(fields, behind.any(axis=1))


# The points of the six faces of a cell, [3, 3] each, with outward normals for a
# right-handed cell.
FACE_SLICES = [
    lambda a: np.swapaxes(a[:, 0], 1, 2), lambda a: a[:, 2],
    lambda a: a[:, :, 0], lambda a: np.swapaxes(a[:, :, 2], 1, 2),
    lambda a: np.swapaxes(a[:, :, :, 0], 1, 2), lambda a: a[:, :, :, 2]]


def all_faces(fields):
    """All faces of all cells: [face, 3, 3, ...]."""
    return {name: np.concatenate([face(values) for face in FACE_SLICES])
            for name, values in fields.items()}


def surface_faces(fields):
    """The faces that belong to one cell only, also where a cell has four
    smaller neighbours."""
    faces = all_faces(fields)
    points = faces["points"]
    size = np.ptp(points)
    parts = interpolate(points, interpolation(5)[1::2]).reshape(-1, 4, 3)
    return select(faces, have_no_partner(
        integer_keys(points[:, 1, 1], size), integer_keys(parts, size)))


def integer_keys(points, size):
    """Positions as integers, the same for the same place in two cells."""
    return np.floor(points / size * 1e4 + 0.4142).astype(np.int64)


def have_no_partner(keys, parts):
    """Whether a thing with its middle at keys[i], whose parts have theirs at
    parts[i], is nothing else's equal, part or whole."""
    n, n_parts = parts.shape[:2]
    _, index, count = np.unique(keys, axis=0, return_inverse=True,
                                return_counts=True)
    alone = count[index.ravel()] == 1
    _, index = np.unique(np.concatenate([keys, parts.reshape(n * n_parts, -1)]),
                         axis=0, return_inverse=True)
    index = index.ravel()
    wholes, pieces = index[:n], index[n:].reshape(n, n_parts)
    return (alone & ~np.isin(wholes, pieces)
            & ~np.isin(pieces, wholes).any(axis=1))


def planes_of_cut(faces, body):
    """Which faces lie in the first and which in the second plane of the cut."""
    if len(body.cut) < 2:
        return [np.full(len(faces["points"]), False)] * 2
    tolerance = 1e-6 * np.abs(faces["points"]).max()
    return [np.abs(faces["points"][..., d]).max(axis=(1, 2)) < tolerance
            for d in body.cut]


def interpolation(n):
    """Values of the quadratic functions at n points of [0, 1]: [n, 3]."""
    s = np.linspace(0, 1, n)
    return np.stack([(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)],
                    axis=-1)


def interpolate(values, N):
    return np.einsum("ai,bj,fij...->fab...", N, N, values)


def contraction(fields):
    """How much shorter than at rest the most active fibres want to be."""
    stretches = [values for name, values in fields.items()
                 if name.startswith("active_stretch_")]
    if not stretches:
        return np.zeros(fields["tissue"].shape)
    return 1 - np.min(stretches, axis=0)


class Drawing:
    """The visible surface at one time as quadrilaterals, back to front."""

    def __init__(self, pvtu_file, body, with_mesh):
        faces = surface_faces(opened_body(pvtu_file, body))
        x = faces["points"] + faces["displacement"]
        corners = interpolate(x, interpolation(N_SUBDIVISIONS + 1))
        at_centres = interpolation(2 * N_SUBDIVISIONS + 1)[1::2]

        def centre(values):
            value = interpolate(values, at_centres)
            return value.reshape(-1, *value.shape[3:])

        quads = np.stack([corners[:, :-1, :-1], corners[:, 1:, :-1],
                          corners[:, 1:, 1:], corners[:, :-1, 1:]],
                         axis=3).reshape(-1, 4, 3)
        normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
        normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-300
        visible = np.flatnonzero(normals @ VIEW.normal > 0)
        depth = quads.mean(axis=1) @ VIEW.normal
        order = visible[np.argsort(depth[visible])]

        per_face = N_SUBDIVISIONS**2
        wall, floor = (np.repeat(plane, per_face)[order]
                       for plane in planes_of_cut(faces, body))
        self.on_cut, self.on_floor = wall | floor, floor
        self.liquid = np.repeat(
            np.isin(np.round(faces["tissue"][:, 1, 1]), body.liquid_tissues),
            per_face)[order]
        self.polygons = VIEW.project(quads[order])
        self.normals = normals[order]
        self.pressure = centre(faces["pressure"])[order]
        self.contraction = centre(contraction(faces))[order]
        self.edges = self.lines_on_cut(faces, body, with_mesh)

    @staticmethod
    def lines_on_cut(faces, body, with_mesh):
        """Lines on the cut: around all cells, or around the tissues, which are
        the edges that only one cell of a tissue has there."""
        lines = []
        N = interpolation(N_SUBDIVISIONS + 1)
        halves = interpolation(5)[1::2]
        size = np.ptp(faces["points"])
        for on_plane in planes_of_cut(faces, body):
            if not on_plane.any():
                continue
            cut = select(faces, on_plane)
            tissue = np.tile(np.round(cut["tissue"][:, 1, 1]), 4)

            def edges(x):
                return np.concatenate([x[:, 0], x[:, 2], x[:, :, 0], x[:, :, 2]])

            def keys(x):
                """With the tissue: [edge, part, 4]."""
                return np.concatenate([
                    integer_keys(x, size),
                    np.broadcast_to(tissue.astype(np.int64)[:, None, None],
                                    (*x.shape[:2], 1))], axis=2)

            rest = edges(cut["points"])
            shown = np.full(len(rest), True) if with_mesh else have_no_partner(
                keys(rest[:, 1:2])[:, 0],
                keys(np.einsum("ai,eij->eaj", halves, rest)))
            moved = edges(cut["points"] + cut["displacement"])
            lines.extend(VIEW.project(N @ line) for line in moved[shown])
        return lines

    def colours(self, pressure_norm, contraction_norm):
        rgb = MUSCLE_COLOURS(contraction_norm(self.contraction))[:, :3]
        liquid = LIQUID_COLOURS(pressure_norm(self.pressure))[:, :3]
        rgb[self.liquid] = liquid[self.liquid]
        # What is cut is drawn flat, so that its colour can be read.
        half = unit(LIGHT + VIEW.normal)
        light = 0.5 + 0.5 * self.normals @ LIGHT
        flat = np.where(self.on_floor, 0.94, 1.0)
        shade = np.where(self.on_cut, flat, 0.6 + 0.4 * light)
        gloss = np.where(self.on_cut, 0.0,
                         0.2 * np.clip(self.normals @ half, 0, 1)**30)
        return np.clip(rgb * shade[:, None] + gloss[:, None], 0, 1)


def choose_times(series, wanted, n):
    """The entries nearest to the times wanted, or n evenly spaced ones."""
    times = np.array([t for t, _ in series])
    if not wanted:
        wanted = np.linspace(times[0], times[-1], min(n, len(times)))
    return [series[i] for i in
            sorted({int(np.argmin(np.abs(times - t))) for t in wanted})]


def rendered(figure, dots_per_inch=150):
    """An image of the figure, each dot the mean of 3 x 3: polygons that are
    smoothed one by one would show seams."""
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=3 * dots_per_inch,
                   pil_kwargs={"compress_level": 0})
    plt.close(figure)
    return Image.open(buffer).convert("RGB").reduce(3)


def save(figure, file_name):
    rendered(figure).save(file_name, optimize=True)


class Scales:
    """What several drawings have in common: colours and limits."""

    def __init__(self, drawings):
        self.has_liquid = any(d.liquid.any() for d in drawings)
        top = max((d.pressure[d.liquid].max() for d in drawings
                   if d.liquid.any()), default=0.0)
        self.pressure = Normalize(0, top if top > 0 else 1)
        most = max(d.contraction.max() for d in drawings)
        self.has_contraction = most > 0
        self.contraction = Normalize(0, 100 * most if most > 0 else 1)

        points = np.concatenate([d.polygons.reshape(-1, 2) for d in drawings])
        low, high = points.min(axis=0), points.max(axis=0)
        margin = 0.03 * (high - low).max()
        self.low, self.high = low - margin, high + margin

    def colours(self, drawing):
        return drawing.colours(self.pressure,
                               lambda c: self.contraction(100 * c))


def paint(axes, drawing, scales, low, high, time):
    """One body with its time above it, in the window from low to high."""
    colours = scales.colours(drawing)
    axes.add_collection(PolyCollection(
        drawing.polygons, facecolors=colours, edgecolors=colours,
        linewidths=0.2, antialiaseds=False))
    for line in drawing.edges:
        axes.plot(*line.T, color="#402020", linewidth=0.3,
                  solid_capstyle="round")
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.set_aspect("equal")
    axes.axis("off")
    axes.text(0.02, 1.0, f"$t$ = {time:g}", transform=axes.transAxes,
              fontsize=9, va="top")


def add_colour_bars(figure, scales):
    """At the bottom of the figure, 0.75 inches high."""
    total = figure.get_figheight()
    maps = []
    if scales.has_contraction:
        maps.append((scales.contraction, MUSCLE_COLOURS,
                     "active contraction of the muscles [%]"))
    if scales.has_liquid:
        maps.append((scales.pressure, LIQUID_COLOURS,
                     "pressure of the liquid [N/mm$^2$]"))
    places = [0.08, 0.55] if len(maps) == 2 else [0.315]
    for place, (norm, colours, label) in zip(places, maps):
        axes = figure.add_axes([place, 0.47 / total, 0.37, 0.1 / total])
        colour_bar = figure.colorbar(
            plt.cm.ScalarMappable(norm=norm, cmap=colours), cax=axes,
            orientation="horizontal")
        colour_bar.set_label(label, fontsize=8, labelpad=2)
        colour_bar.ax.tick_params(labelsize=7, length=2, pad=2)
        colour_bar.outline.set_linewidth(0.5)


def draw_body(folder, parameters, wanted_times, n_times, columns, with_mesh):
    body = Body(parameters)
    shown = choose_times(read_series(folder), wanted_times, n_times)
    drawings = [Drawing(name, body, with_mesh) for _, name in shown]

    scales = Scales(drawings)
    low, high = scales.low, scales.high.copy()
    inches = 7.5
    if columns == 0:
        width, height = high - low
        columns = 1 if width > 3 * height else min(3, len(drawings))
    n_rows = -(-len(drawings) // columns)
    # Room for the time above the body.
    high[1] += 0.12 * (high - low)[0] * columns / inches
    width, height = high - low
    row_inches = min(inches / columns * height / width, 3.5)
    bars = 0.75 if scales.has_contraction or scales.has_liquid else 0.1
    title = 0.45
    total = n_rows * row_inches + bars + title
    figure = plt.figure(figsize=(inches, total))
    for number, (drawing, (time, _)) in enumerate(zip(drawings, shown)):
        row, column = divmod(number, columns)
        axes = figure.add_axes([
            column / columns, 1 - (title + (row + 1) * row_inches) / total,
            1 / columns, row_inches / total])
        paint(axes, drawing, scales, low, high, time)
    figure.suptitle(parameters.get("Title", ""), fontsize=11,
                    y=1 - 0.13 / total, va="top")
    add_colour_bars(figure, scales)
    save(figure, pathlib.Path(folder) / "picture.png")


def cell_borders(t):
    """Borders between the times, for cells of constant colour."""
    middle = 0.5 * (t[1:] + t[:-1])
    return np.concatenate([t[:1], middle, t[-1:]])


def draw_table(table, parameters, file_name):
    """The table of the segments, with a row for every segment at all times."""
    times = np.unique(table["t"])
    segments = np.unique(table["segment"]).astype(int)

    def field(name):
        return table[name].reshape(len(times), len(segments))

    has_liquid = field("fluid_volume").min() > 0
    volume = field("fluid_volume" if has_liquid else "wall_volume")
    panels = [
        ("length [mm]", field("length"), "viridis", False),
        ("radius in the middle [mm]", field("mid_radius"), "viridis", False),
        ("pressure of the liquid [N/mm$^2$]", field("fluid_pressure"),
         "YlGnBu", False),
        (("liquid" if has_liquid else "wall") + ": $V/V_0 - 1$",
         volume / volume[0] - 1, "RdBu_r", True)]

    lines = len(segments) < 3
    figure, grid = plt.subplots(2, 2, figsize=(7.5, 4.6), sharex=True,
                                layout="constrained")
    for axes, (label, values, colours, symmetric) in zip(grid.flat, panels):
        # What is less than 1e-12 is round-off.
        limit = max(np.abs(values).max(), 1e-12)
        if lines:
            for number, segment in enumerate(segments):
                axes.plot(times, values[:, number], ".-", linewidth=1,
                          markersize=4, label=f"segment {segment}")
            if symmetric:
                axes.set_ylim(-limit, limit)
            axes.set_title(label, fontsize=9)
            axes.ticklabel_format(axis="y", useOffset=False,
                                  scilimits=(-3, 4))
            axes.grid(linewidth=0.3)
            if len(segments) > 1:
                axes.legend(fontsize=7)
        else:
            borders = np.arange(segments[0], segments[-1] + 2) - 0.5
            limits = ({"vmin": -limit, "vmax": limit} if symmetric else {})
            mesh = axes.pcolormesh(cell_borders(times), borders, values.T,
                                   cmap=colours, **limits)
            axes.invert_yaxis()
            axes.set_ylabel("segment", fontsize=8)
            axes.set_yticks(segments[::max(1, len(segments) // 10)])
            bar = figure.colorbar(mesh, ax=axes, pad=0.02)
            bar.formatter.set_powerlimits((-3, 4))
            bar.ax.tick_params(labelsize=7)
            bar.ax.yaxis.get_offset_text().set_fontsize(7)
            axes.set_title(label, fontsize=9)
        axes.tick_params(labelsize=7)
        axes.yaxis.get_offset_text().set_fontsize(7)
    for axes in grid[1]:
        axes.set_xlabel("time", fontsize=8)
    figure.suptitle(parameters.get("Title", ""), fontsize=11)
    save(figure, file_name)


def main():
    parser = argparse.ArgumentParser(
        description="Draw a run: picture.png and segments.png in its folder.")
    parser.add_argument("folder", metavar="RUN_DIR",
                        help="the output folder of a run")
    parser.add_argument("--times", type=float, nargs="+", default=[],
                        help="times to show (default: evenly spaced ones)")
    parser.add_argument("--count", type=int, default=6,
                        help="how many evenly spaced times (default: 6)")
    parser.add_argument("--columns", type=int, default=0,
                        help="bodies side by side (default: as fits)")
    parser.add_argument("--mesh", action="store_true",
                        help="draw the cells on the cut")
    arguments = parser.parse_args()
    if not (pathlib.Path(arguments.folder) / "solution.pvd").exists():
        print(f"picture.py: no solution.pvd in '{arguments.folder}'; give the "
              "output folder of a run.", file=sys.stderr)
        return 1
    parameters = read_parameters(arguments.folder)
    draw_body(arguments.folder, parameters, arguments.times, arguments.count,
              arguments.columns, arguments.mesh)
    folder = pathlib.Path(arguments.folder)
    draw_table(read_table(folder / "segments.csv"), parameters,
               folder / "segments.png")
    print(f"Wrote picture.png and segments.png to {arguments.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
