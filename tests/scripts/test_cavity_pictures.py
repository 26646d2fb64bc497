# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chambers without cells in pictures: they are filled with cells that have the
volume and the pressure of segments.csv, and look as liquid that is meshed."""
import json
import sys

import numpy as np
import pytest
from lumbricus_run import SOURCE, run_well
from PIL import Image

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.body import Body  # noqa: E402
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.fields import (  # noqa: E402
    FACES, nodes_of_cells, read_grid, read_series)
from lumbricus.plot.surface import Faces  # noqa: E402

# The ends of every edge of VTK's quadratic hexahedra.
EDGES = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7],
                  [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]])
CHAIN = "Geometry/segment chain/"
CAVITY = CHAIN + "Liquid=cavity"
PHYSICS = SOURCE / "tests" / "physics"
# The case, settings, ranks, and the number of the tissue of chambers.
CASES = {
    "quarter": ("chain.prm", [CAVITY], 2, 4),
    "full": ("chain.prm", [CAVITY, CHAIN + "Cross-section=full"], 1, 4),
    "mixed": ("chain.prm", [CHAIN + "Segment 2/Liquid=cavity"], 2, 0),
    "half of a tube": ("pistons.prm", [
        "Geometry/open cylinder/Cross-section=half"], 1, 1)}


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    made = {}

    def run_of(name):
        if name not in made:
            file, settings, ranks, _ = CASES.get(name, ("chain.prm", [], 1, 0))
            end = ["Time/End=0.1"] if file == "chain.prm" else []
            made[name] = run_well(
                PHYSICS / file, tmp_path_factory.mktemp("run"),
                [*settings, *end, "Output/Every=1"], ranks)
        return made[name]

    return run_of


def description(run):
    return json.loads((run.folder / "run.json").read_text())["body"]


def places_of_nodes():
    """Where the 27 nodes are in the unit cube."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                        [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    return np.concatenate([corners, corners[EDGES].mean(axis=1),
                           corners[FACES[:, :4]].mean(axis=1),
                           [[0.5, 0.5, 0.5]]])


def volumes(x):
    """Of cells with nodes x[cell, node], exactly."""
    def shape(s, node):
        return [(1 - s) * (1 - 2 * s), 4 * s * (1 - s),
                s * (2 * s - 1)][round(2 * node)]

    def slope(s, node):
        return [4 * s - 3, 4 - 8 * s, 4 * s - 1][round(2 * node)]

    points, weights = np.polynomial.legendre.leggauss(3)
    result = np.zeros(len(x))
    for index in np.ndindex(3, 3, 3):
        s = 0.5 + 0.5 * points[list(index)]
        gradients = np.array([[np.prod([
            (slope if e == d else shape)(s[e], place[e]) for e in range(3)])
            for d in range(3)] for place in places_of_nodes()])
        result += np.prod(weights[list(index)] / 2) * np.linalg.det(
            np.einsum("cni,nd->cid", x, gradients))
    return result


@pytest.mark.parametrize("name", CASES)
def test_volume_and_pressure(runs, name):
    run = runs(name)
    tissue = CASES[name][3]
    body = description(run)
    assert body["tissues"][tissue]["liquid"]
    whole = 2**len(body["symmetry_planes"])
    for t, file in read_series(run.folder):
        grid = read_grid(file)
        nodes = nodes_of_cells(grid)
        x = (grid.points + grid["displacement"])[nodes]
        for row in run.segments():
            if row["t"] != pytest.approx(t):
                continue
            inside = ((grid["tissue"][nodes[:, 0]] == tissue)
                      & (grid["segment"][nodes[:, 0]] == row["segment"]))
            of_cells = volumes(x[inside])
            assert (of_cells > 0).all()
            # The files have seven digits.
            assert whole * of_cells.sum() == pytest.approx(row["fluid_volume"],
                                                           rel=1e-6)
            if row["eta"] > 0:
                continue
            pressures = grid["pressure"][nodes[inside]]
            assert pressures == pytest.approx(
                np.full(pressures.shape, row["fluid_pressure"]), rel=1e-6)
            assert grid["J"][nodes[inside]] == pytest.approx(1, abs=1e-6)
            assert grid["pressure_unknown"][nodes[inside]] == \
                pytest.approx(-pressures)


@pytest.mark.parametrize("name", CASES)
def test_body_is_closed(runs, name):
    """Cut open, with nothing between the chambers and the wall around them."""
    run = runs(name)
    body = Body(description(run))
    grid = read_grid(read_series(run.folder)[-1][1])
    volume = 2**len(body.mirrors) * volumes(grid.points[
        nodes_of_cells(grid)]).sum()
    faces = Faces(*body.opened(grid))
    surface = faces.surface(np.full(len(faces.nodes), True))
    # VTK draws some triangles at a corner that is collapsed twice.
    edges = surface.clean(tolerance=1e-6).extract_feature_edges(
        boundary_edges=True, feature_edges=False, manifold_edges=False,
        non_manifold_edges=False)
    assert edges.n_cells == 0
    surface.points -= surface["displacement"]
    assert surface.volume == pytest.approx(0.75 * volume, rel=0.03)


def test_looks_like_the_rubber_fluid(runs, tmp_path):
    images = []
    for name in ("quarter", "rubber"):
        folder = tmp_path / name
        assert main([str(runs(name).folder), "--output", str(folder),
                     "--times", "0.1", "--only", "picture"]) == 0
        with Image.open(folder / "picture.png") as image:
            images.append(np.asarray(image.convert("RGB")).astype(int))
    assert images[0].shape == images[1].shape
    differ = (np.abs(images[0] - images[1]) > 12).any(axis=2)
    assert differ.mean() < 5e-3
