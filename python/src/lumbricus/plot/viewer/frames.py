# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run as numbers for a browser: what is the same at all times, and what moves.

Where a body is at a time are 16 bits a coordinate, in a box around all times, as the
difference to the time before where the mesh is the same; colours are a byte a vertex
and field. All lower bytes of a coordinate follow one another, then all upper ones:
so written, most of it is zeros, and is packed to a third."""

import pathlib
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..arrays import Array, Series
from ..body import Body
from ..fields import read_grid, read_obstacles
from ..scene import LINE_COLOUR, OBSTACLE_COLOUR
from ..surface import ALONG_EDGE, Faces
from ..view import VIEW
from .colouring import Colouring, colourings_of
from .skin import DIVISIONS, Skin, moved

LEVELS = 65535          # of a coordinate
# The most bytes before they are packed. A scene with so many has some 10 MB.
MOST_BYTES = 24_000_000
FEWEST_FRAMES = 6


@dataclass
class Mesh:
    """The part of a body that is the same for some times: triangles, lines on the cut,
    and which vertices are liquid."""
    skin: Skin
    liquid: Array
    lines: Array            # [line, 2] numbers of vertices, behind those of the skin
    n_vertices: int


@dataclass
class Obstacle:
    """The edges of what is beside the body, which most often rests."""
    points: Array
    lines: Array            # [line, 2] numbers of its points


@dataclass
class Frame:
    time: float
    mesh: int
    obstacle: int           # -1 where there is none
    points: Array
    colours: list[Array] = field(default_factory=list)


def points_of_lines(polylines: Any, divisions: int) -> Array:
    """Of lines with ALONG_EDGE points, those that cut them into so many parts
    [line, point, 3]."""
    along = polylines.points.reshape(-1, ALONG_EDGE, 3)
    return np.asarray(along[:, ::(ALONG_EDGE - 1) // divisions])


def pairs(n_lines: int, n: int, begin: int) -> Array:
    """The pieces of lines with n points each, whose numbers follow one another."""
    numbers = begin + np.arange(n_lines * n).reshape(n_lines, n)
    return np.stack([numbers[:, :-1], numbers[:, 1:]], axis=-1).reshape(-1, 2)


class Recording:
    """The times of a run, one after the other, on as fine a mesh as there is room
    for. Where even the coarsest needs too much some times are left out."""

    def __init__(self, body: Body, shown: Series,
                 obstacles: dict[float, pathlib.Path]) -> None:
        self.body = body
        self.meshes: list[Mesh] = []
        self.obstacles: list[Obstacle] = []
        self.frames: list[Frame] = []
        first = self.faces_at(shown[0][1])
        self.colourings: list[Colouring] = colourings_of(first)
        self.divisions, n_frames = self.room_for(first, len(shown))
        kept = np.unique(np.linspace(0, len(shown) - 1, n_frames).round().astype(int))
        self.left_out = len(shown) - len(kept)
        for number in kept:
            time, file = shown[number]
            self.add(time, self.faces_at(file), obstacles.get(time))
        all_points = [*(frame.points for frame in self.frames),
                      *(obstacle.points for obstacle in self.obstacles)]
        corners = np.concatenate([[x.min(axis=0), x.max(axis=0)] for x in all_points])
        self.low, self.high = corners.min(axis=0), corners.max(axis=0)
        self.window = VIEW.window([f.points[:len(self.meshes[f.mesh].skin.first)]
                                   for f in self.frames])

    def faces_at(self, file: pathlib.Path) -> Faces:
        return Faces(*self.body.opened(read_grid(file)))

    def room_for(self, faces: Faces, n_frames: int) -> tuple[int, int]:
        """In how many parts to cut edges, and how many times to show."""
        n_lines = faces.lines(with_mesh=False).n_points // ALONG_EDGE
        for n in DIVISIONS:
            bytes_a_frame = (len(faces.nodes) * n * n * (6 + len(self.colourings))
                             + 6 * n_lines * (n + 1))
            if bytes_a_frame * n_frames <= MOST_BYTES:
                return n, n_frames
        return n, min(n_frames, max(FEWEST_FRAMES, MOST_BYTES // bytes_a_frame))

    def add(self, time: float, faces: Faces, obstacles: pathlib.Path | None) -> None:
        lines = points_of_lines(faces.lines(with_mesh=False), self.divisions)
        mesh = self.mesh_for(faces, lines)
        frame = Frame(time, len(self.meshes) - 1, self.number_of_obstacle(obstacles),
                      np.concatenate([moved(mesh.skin, faces), lines.reshape(-1, 3)]))
        liquid = np.isin(np.round(faces.fields["tissue"]), self.body.liquid_tissues)
        for colouring in self.colourings:
            values = mesh.skin.at_vertices(colouring.values(faces, liquid))
            for scale, chosen in colouring.scale_of(mesh.liquid):
                scale.take_in(values[chosen])
            frame.colours.append(values.astype(np.float32))
        self.frames.append(frame)

    def mesh_for(self, faces: Faces, lines: Array) -> Mesh:
        """That of the time before, where it fits, or a new one."""
        if self.meshes and self.meshes[-1].skin.fits(faces):
            return self.meshes[-1]
        skin = Skin(faces, self.divisions)
        tissue = np.round(faces.fields["tissue"])
        liquid = np.isin(tissue[faces.nodes[:, 8]], self.body.liquid_tissues)
        n_skin = len(skin.first)
        self.meshes.append(Mesh(
            skin, np.repeat(liquid, len(skin.weights))[skin.first],
            pairs(lines.shape[0], lines.shape[1], n_skin),
            n_skin + lines.shape[0] * lines.shape[1]))
        return self.meshes[-1]

    def number_of_obstacle(self, file: pathlib.Path | None) -> int:
        """That of the time before, where it rests, or a new one."""
        if file is None:
            return -1
        edges = read_obstacles(file).extract_all_edges()
        points, lines = np.asarray(edges.points), edges.lines.reshape(-1, 3)[:, 1:]
        if not self.obstacles or not (
                np.array_equal(self.obstacles[-1].points, points)
                and np.array_equal(self.obstacles[-1].lines, lines)):
            self.obstacles.append(Obstacle(points, lines))
        return len(self.obstacles) - 1

    def centre(self) -> Array:
        """What the scene turns about: the middle of the box, moved to the middle of
        the window in which it begins."""
        middle = 0.5 * (self.low + self.high)
        off = 0.5 * (self.window[0] + self.window[1]) - VIEW.project(middle)
        return np.asarray(middle + off[0] * VIEW.right + off[1] * VIEW.up)

    def places(self, points: Array) -> Array:
        """In 16 bits each [coordinate, vertex]."""
        within = (points - self.low) / self.size()
        return np.asarray(np.round(within * LEVELS).astype("<u2").T)

    def size(self) -> Array:
        return np.where(self.high > self.low, self.high - self.low, 1)

    def describe(self) -> tuple[dict[str, Any], bytes]:
        """What the page is told in words, and the numbers: of each mesh the triangles
        and lines as 32 bits, and a byte a vertex of the skin that says whether it is
        liquid; of each obstacle lines and coordinates; of each time the coordinates
        and the colours."""
        data: list[bytes] = []

        def add_numbers(numbers: Array) -> None:
            data.append(np.ascontiguousarray(numbers, dtype="<u4").tobytes())

        def add_places(places: Array) -> None:
            for shift in (0, 8):
                data.append((places >> shift).astype(np.uint8).tobytes())

        for mesh in self.meshes:
            add_numbers(mesh.skin.triangles)
            add_numbers(mesh.lines)
            data.append(mesh.liquid.astype(np.uint8).tobytes())
        for obstacle in self.obstacles:
            add_numbers(obstacle.lines)
            add_places(self.places(obstacle.points))
        mesh_before, before = -1, np.zeros((3, 0), dtype="<u2")
        for frame in self.frames:
            places = self.places(frame.points)
            # Modulo 2^16, as it is added up again.
            add_places(places - before if frame.mesh == mesh_before else places)
            for colouring, values in zip(self.colourings, frame.colours, strict=True):
                numbers = np.zeros(len(values), dtype=np.uint8)
                for scale, chosen in colouring.scale_of(self.meshes[frame.mesh].liquid):
                    numbers[chosen] = scale.as_bytes(values[chosen])
                data.append(numbers.tobytes())
            mesh_before, before = frame.mesh, places
        words = {
            "low": self.low.tolist(), "size": self.size().tolist(),
            "view": [VIEW.right.tolist(), VIEW.up.tolist(), VIEW.normal.tolist()],
            "centre": self.centre().tolist(),
            "window": (self.window[1] - self.window[0]).tolist(),
            "line": LINE_COLOUR, "obstacle": OBSTACLE_COLOUR,
            "meshes": [{"vertices": mesh.n_vertices, "skin": len(mesh.skin.first),
                        "triangles": len(mesh.skin.triangles),
                        "lines": len(mesh.lines)} for mesh in self.meshes],
            "obstacles": [{"points": len(obstacle.points),
                           "lines": len(obstacle.lines)}
                          for obstacle in self.obstacles],
            "frames": [{"time": frame.time, "mesh": frame.mesh,
                        "obstacle": frame.obstacle} for frame in self.frames],
            "colourings": [{"name": c.name,
                            "scales": [scale.describe() for scale in c.scales]}
                           for c in self.colourings]}
        return words, b"".join(data)
