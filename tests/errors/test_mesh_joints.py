# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a mesh that touch and do not share their faces are refused, with the
place; slits are not.

Two boxes that are meshed apart, with 4 x 4 and 2 x 2 cells at their common face,
share a quarter of the nodes there when 'remove duplicate nodes' has been used:
a crack, at which a bar under a load of 0.5 moved by 4.046 or 1.195, by where one
looked, instead of 0.39486. Both were one part, as they share nodes."""
import itertools
import math

import pytest
from cube_mesh import HEXAHEDRON, Mesh
from lumbricus_run import run
from mesh_cases import FILE, start
from mistakes import check_one_message, names, on_ranks, run_all


class Boxes(Mesh):
    """Boxes of nx x ny x nz cells; nodes at the same place are one."""

    def __init__(self):
        super().__init__(())
        self.nodes = []
        self.known = {}

    def node(self, x, merge=True):
        key = tuple(round(c, 9) for c in x)
        if not merge or key not in self.known:
            self.nodes.append(list(x))
            self.known[key] = len(self.nodes)
        return self.known[key]

    def box(self, low, high, cells, bend=lambda x: x, merge=True):
        """Cells of [low, high], each point of which is bent to another."""
        number = {}
        for i in itertools.product(*(range(n + 1) for n in cells)):
            x = bend([a + (b - a) * k / n
                      for a, b, k, n in zip(low, high, i, cells)])
            number[i] = self.node(x, merge)
        for i, j, k in itertools.product(*map(range, cells)):
            self.add(HEXAHEDRON, "wall",
                     [number[i + a, j + b, k + c] for c in (0, 1)
                      for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
        return self


def around(x):
    """(radius, quarters around the x axis, along) in space."""
    r, phi = x[0], x[1] * math.pi / 2
    return [x[2], r * math.cos(phi), r * math.sin(phi)]


def interface(coarse, fine):
    """Two boxes with these numbers of cells along the edges of their face."""
    return Boxes().box((0, 0, 0), (1, 1, 1), (2, *fine)).box(
        (1, 0, 0), (2, 1, 1), (1, *coarse))


def shells(inner, outer, around_quarter=2):
    """Two shells, one around the other."""
    return Boxes().box((1, 0, 0), (1.5, 1, 1), (1, around_quarter * inner, 1),
                       around).box(
        (1.5, 0, 0), (2, 1, 1), (1, around_quarter * outer, 1), around)


HANGING = "with nodes in the middle of other faces at "
JOIN = ["are not joined", "'BooleanFragments'"]

# What is wrong; the mesh; settings; what the message has to say.
MISTAKES = [
    ("hanging nodes", interface((2, 2), (4, 4)), [],
     [FILE, HANGING + "16 places: the node (1, ",
      "of the cell at (1.5, ", "all are between (1, 0, 0) and (1, 1, 1)",
      *JOIN]),
    ("hanging nodes on edges", interface((1, 1), (1, 2)), [],
     [FILE, HANGING + "2 places: the node (1, 0, 0.5) lies on the face from",
      *JOIN]),
    ("three by two", interface((2, 2), (3, 3)), [], [FILE, HANGING, *JOIN]),
    ("rows across", interface((1, 3), (3, 1)), [], [FILE, HANGING, *JOIN]),
    ("face in the middle of a face",
     Boxes().box((0, 0, 0), (1, 3, 3), (1, 1, 1))
     .box((1, 1, 1), (2, 2, 2), (1, 1, 1)), [],
     [FILE, HANGING + "4 places", *JOIN]),
    # No node of one lies on a face of the other.
    ("crossed bars",
     Boxes().box((0, 0, 0), (3, 1, 1), (1, 1, 1))
     .box((1, -1, 1), (2, 2, 2), (1, 1, 1)), [],
     [FILE, "with edges that cross at 4 places: the edge from (", *JOIN]),
    ("boxes that overlap",
     Boxes().box((0, 0, 0), (2, 2, 2), (1, 1, 1))
     .box((1.1, 1.1, 1.1), (3, 3, 3), (1, 1, 1)), [],
     [FILE, "overlap and are not joined, with nodes inside of other cells at 2 "
      "places: the node (2, 2, 2) is inside of the cell at (2.05, 2.05, 2.05)",
      "all are between (1.1, 1.1, 1.1) and (2, 2, 2)", *JOIN]),
    # The finer nodes are on the circle, and so off the flat faces.
    ("hanging nodes outside of a curved face", shells(1, 2), [],
     [FILE, "with hanging nodes at 4 places", "both ends of which it is joined "
      "to", *JOIN]),
    ("three to one outside of a curved face", shells(1, 3), [],
     [FILE, "with hanging nodes", *JOIN]),
    ("hanging nodes inside of a curved face", shells(2, 1), [],
     [FILE, HANGING + "4 places", *JOIN]),
    ("three to two on a curved face", shells(3, 2), [],
     [FILE, "are not joined", *JOIN]),
    ("nodes twice", Boxes().box((0, 0, 0), (1, 1, 1), (2, 2, 2))
     .box((1, 0, 0), (2, 1, 1), (2, 2, 2), merge=False), [],
     [FILE, "two nodes at the same place", "is not joined", JOIN[1]]),
    # A hinge: these were taken for one part.
    ("parts that share an edge",
     Boxes().box((0, 0, 0), (1, 1, 1), (1, 1, 1))
     .box((1, 1, 0), (2, 2, 1), (1, 1, 1)), [],
     [FILE, "has 2 parts that share edges or nodes, but no faces, as the cells "
      "at (0.5, 0.5, 0.5) and (1.5, 1.5, 0.5) do at (1, 1, ", *JOIN]),
    ("parts that share a node",
     Boxes().box((0, 0, 0), (1, 1, 1), (1, 1, 1))
     .box((1, 1, 1), (2, 2, 2), (1, 1, 1)), [],
     [FILE, "has 2 parts that share edges or nodes", "at (1, 1, 1)", *JOIN]),
]

CASES = on_ranks(MISTAKES, on_two=["hanging nodes", "parts that share an edge"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("joints"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_parts_that_touch_are_refused(i, results):
    (_, _, _, words), _ = CASES[i]
    check_one_message(results[i], words)


def slit(gap, n_upper=2):
    """Two layers that are joined at one end, with a slit between them."""
    mesh = Boxes().box((0, 0, 0), (1, 1, 1), (1, 1, 1)).box(
        (0, 0, 1), (1, 1, 1 + gap), (1, 1, 1)).box(
        (0, 0, 1 + gap), (1, 1, 2 + gap), (1, 1, 1))
    return mesh.box((1, 0, 0), (3, 1, 1), (2, 1, 1)).box(
        (1, 0, 1 + gap), (3, 1, 2 + gap), (n_upper, 1, 1))


def notch(angle):
    """A slit with a tip."""
    def opened(x):
        return [x[0], x[1], x[2] * (1 + angle * x[0]) + angle * x[0]]
    return Boxes().box((0, 0, 0), (2, 1, -1), (2, 1, 1)).box(
        (0, 0, 0), (2, 1, 1), (2, 1, 1), opened).box(
        (-1, 0, -1), (0, 1, 1), (1, 1, 2))


@pytest.mark.parametrize("mesh", [
    pytest.param(slit(1e-2), id="narrow slit"),
    pytest.param(slit(2e-3), id="slit of a five hundredth"),
    pytest.param(slit(1e-2, 3), id="slit with other nodes on the other side"),
    pytest.param(notch(0.02), id="tip of a slit"),
    pytest.param(Boxes().box((1, 0, 0), (1.001, 4, 1), (1, 8, 1), around),
                 id="closed thin shell"),
    pytest.param(Boxes().box((0, 0, 0), (5, 5, 1e-4), (2, 2, 1)),
                 id="plate with cells 25000 times as wide as thick"),
])
def test_bodies_with_slits_are_taken(mesh, tmp_path):
    def check(case, output, settings, ranks):
        return run(case, output, settings, ranks, ["--check"])
    result = start(("", mesh, ["Muscles/all/Fibres=longitudinal"], []), 1,
                   tmp_path / "case", check)
    assert result.exit_code == 0, result.message
