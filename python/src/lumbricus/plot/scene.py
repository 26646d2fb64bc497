# SPDX-License-Identifier: LGPL-2.1-or-later
"""Images of bodies, all with the same view, colours and light."""

import ctypes
import os
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np
import pyvista
from matplotlib import colormaps
from matplotlib.colors import LinearSegmentedColormap, Normalize
from PIL import Image

from .arrays import Array
from .run_folder import PlotError
from .surface import Drawing
from .view import LIGHT, VIEW

LIQUID_COLOURS = colormaps["YlGnBu"]
MUSCLE_COLOURS = LinearSegmentedColormap.from_list(
    "muscle", ["#f3e0d5", "#e39a83", "#c0392b", "#6d1010"])
LINE_COLOUR = "#402020"
FIBRE_COLOUR = "#14b8a6"
OBSTACLE_COLOUR = "#b9a98a"
OBSTACLE_OPACITY = 0.3
# An image is the mean of so many dots in both directions; pyvista's own ways to
# smooth edges depend on the driver.
SUPERSAMPLING = 3
FLOOR = 0.94  # brightness of the second plane of the cut
# From where, and how bright: the main light, and one that fills the shadows.
LIGHTS = [(LIGHT, 0.7), (VIEW.normal + [0.6, 0, -0.5], 0.35)]

# Where Linux has a screen VTK would ask it first, and complain if it is gone.
EGL = "vtkEGLRenderWindow"
if sys.platform == "linux":
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", EGL)
# The dots of an image are means already.
pyvista.global_theme.multi_samples = 1


class Scales:
    """What several drawings have in common: colours and the window."""

    def __init__(self, drawings: Sequence[Drawing]) -> None:
        surfaces = [s for drawing in drawings for s in drawing.surfaces]
        pressures = [s["pressure"][s["liquid"]].max()
                     for s in surfaces if s["liquid"].any()]
        self.has_liquid = bool(pressures)
        top = max(pressures, default=0.0)
        self.pressure = Normalize(0, top if top > 0 else 1)
        most = max(s["contraction"].max() for s in surfaces)
        self.has_contraction = most > 0
        self.contraction = Normalize(0, most if most > 0 else 1)
        self.low, self.high = VIEW.window([s.points for s in surfaces])

    def colours(self, surface: pyvista.PolyData, brightness: float) -> Array:
        rgb = MUSCLE_COLOURS(self.contraction(surface["contraction"]))[:, :3]
        liquid = LIQUID_COLOURS(self.pressure(surface["pressure"]))[:, :3]
        rgb[surface["liquid"]] = liquid[surface["liquid"]]
        return np.asarray((255 * brightness * rgb).round().astype(np.uint8))


def check_that_vtk_can_draw() -> None:
    """Without the library VTK says many things and crashes."""
    if os.environ.get("VTK_DEFAULT_OPENGL_WINDOW") == EGL:
        try:
            ctypes.CDLL("libEGL.so.1")
        except OSError as error:
            raise PlotError(
                "The library libEGL, with which bodies are drawn, is missing "
                f"({error}); run scripts/set_up_python.sh once.") from error


class Scene:
    """Draws without a screen, one time after the other."""

    def __init__(self, scales: Scales, low: Array, high: Array, width: int) -> None:
        """The window from low to high, so many dots wide."""
        check_that_vtk_can_draw()
        self.scales = scales
        self.size = np.array([width, round(width * (high - low)[1]
                                           / (high - low)[0])])
        # World units per dot, for what is as wide at all sizes of the body.
        self.dot = (high - low)[0] / width
        self.plotter = pyvista.Plotter(
            off_screen=True, lighting="none",
            window_size=[int(n) for n in SUPERSAMPLING * self.size])
        self.plotter.set_background("white")
        for position, intensity in LIGHTS:
            self.plotter.add_light(pyvista.Light(
                position=position, intensity=intensity,
                light_type="scene light"))
        self.place_camera(low, high)

    def place_camera(self, low: Array, high: Array) -> None:
        middle = 0.5 * (low + high)
        focus = middle[0] * VIEW.right + middle[1] * VIEW.up
        camera = self.plotter.camera
        camera.focal_point = focus
        camera.position = focus + 3 * (high - low).max() * VIEW.normal
        camera.up = VIEW.up
        camera.parallel_projection = True
        camera.parallel_scale = 0.5 * (high - low)[1]

    def image(self, drawing: Drawing) -> Image.Image:
        plotter = self.plotter
        plotter.clear_actors()
        self.add_surface(drawing.outside, 1.0, ambient=0.62, diffuse=0.42,
                         specular=0.05, specular_power=20, smooth_shading=True)
        for brightness, cut in zip((1.0, FLOOR), drawing.cuts):
            self.add_surface(cut, brightness, lighting=False)
        self.add_lines(drawing.lines)
        if drawing.fibres is not None:
            self.add_fibres(*drawing.fibres)
        if drawing.obstacles is not None:
            self.add_obstacles(drawing.obstacles)
        plotter.renderer.ResetCameraClippingRange()
        plotter.render()
        image = Image.fromarray(plotter.screenshot(return_img=True))
        return image.convert("RGB").reduce(SUPERSAMPLING)

    def add(self, mesh: pyvista.DataSet, **options: Any) -> None:
        self.plotter.add_mesh(mesh, reset_camera=False, render=False, **options)

    def add_surface(self, surface: pyvista.PolyData, brightness: float,
                    **options: Any) -> None:
        self.add(surface, scalars=self.scales.colours(surface, brightness),
                 rgb=True, **options)

    def add_lines(self, lines: pyvista.PolyData) -> None:
        """A dot before the surface, so that this does not hide half of it."""
        if lines.n_lines:
            self.add(lines.translate(self.dot * VIEW.normal), lighting=False,
                     color=LINE_COLOUR, line_width=0.65 * SUPERSAMPLING)

    def add_fibres(self, lines: pyvista.PolyData, dots: pyvista.PolyData) -> None:
        look = {"color": FIBRE_COLOUR, "ambient": 0.6, "diffuse": 0.5}
        if lines.n_lines:
            self.add(lines.tube(radius=1.1 * self.dot, n_sides=8), **look)
        if dots.n_points:
            ball = pyvista.Sphere(radius=2 * self.dot, theta_resolution=8,
                                  phi_resolution=8)
            self.add(dots.glyph(geom=ball, orient=False, scale=False), **look)

    def add_obstacles(self, surface: pyvista.PolyData) -> None:
        """Translucent, with lines that stay where they are in the obstacle. What
        is seen from within it would be in front of the body, and is left out."""
        towards = surface.compute_normals(
            point_normals=False, consistent_normals=False,
            auto_orient_normals=False)["Normals"] @ VIEW.normal
        surface = surface.extract_cells(towards > 0)
        if surface.n_cells == 0:
            return
        look = {"lighting": False, "color": OBSTACLE_COLOUR,
                "opacity": OBSTACLE_OPACITY}
        self.add(surface, **look)
        self.add(surface.extract_all_edges(), **look,
                 line_width=0.5 * SUPERSAMPLING)

    def close(self) -> None:
        self.plotter.close()
