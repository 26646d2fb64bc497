# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole body from a half or a quarter of it, and its part that is shown
when it is cut open."""

import pathlib
import re

import numpy as np

from .fields import MIDDLE, MIRRORED, grid_of, nodes_of_cells
from .view import VIEW


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


class Body:
    """What the parameters say of the mesh: the planes of symmetry in which it
    is mirrored, those of the cut, and which tissues are liquid."""

    def __init__(self, parameters):
        shape = parameters["Geometry/Shape"]

        def get(name, default=""):
            return parameters.get(f"Geometry/{shape}/{name}", default)

        part = get("Cross-section", "full")
        self.mirrors = {"full": [], "half": [1], "quarter": [1, 2]}[part]
        if shape == "block":
            axes = [s.strip() for s in get("Symmetry").split(",")]
            self.mirrors = [d for d, a in enumerate("xyz") if a in axes]
        # The planes through the axis, or of symmetry, along which it is cut.
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

    def opened(self, grid):
        """The whole body without the part between both planes of the cut and
        the viewer. There are faces of cells on the planes, so that cells are
        left out and none is cut, which keeps all faces curved."""
        points, nodes = grid.points, nodes_of_cells(grid)
        # Tensors are not drawn.
        fields = {name: values for name, values in grid.point_data.items()
                  if values.ndim == 1 or is_vector(values)}
        for d in self.mirrors:
            nodes = np.concatenate([nodes, nodes[:, MIRRORED] + len(points)])
            points = with_image(points, d)
            fields = {name: with_image(values, d if is_vector(values) else None)
                      for name, values in fields.items()}
        if len(self.cut) == 2:
            middle = points[nodes[:, MIDDLE]][:, self.cut]
            behind = middle * VIEW.normal[self.cut] < 0
            nodes = nodes[behind.any(axis=1)]
        return grid_of(points, nodes, fields)


def is_vector(values):
    return values.shape[1:] == (3,)


def with_image(values, d):
    """Values at the points and at their images in the plane x_d = 0."""
    image = values.copy()
    if d is not None:
        image[:, d] *= -1
    return np.concatenate([values, image])
