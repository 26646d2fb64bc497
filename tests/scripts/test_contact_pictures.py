# SPDX-License-Identifier: LGPL-2.1-or-later
"""A contact in pictures: pressure and slip on the skin, the surfaces of obstacles
beside the body, and which segments are anchored."""
import csv
import json
import shutil
import sys

import numpy as np
import pytest
from lumbricus_run import SOURCE, go_on, run_well
from PIL import Image

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.anchors import ANCHORED, FREE, SLIDES, anchored  # noqa: E402
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.energy import read_work  # noqa: E402
from lumbricus.plot.fields import (  # noqa: E402
    read_grid, read_obstacles, read_series)

GROUND = SOURCE / "tests" / "physics" / "ground.prm"
DELTA = 1e-3
# All beside the ground touch nothing. Names are in alphabetical order.
OBSTACLES = {
    "ball": ("z max", "sphere", ["sphere/Centre=0.5; 0.5; 2.5 + t",
                                 "sphere/Radius=1.2"]),
    "bend": ("y max", "burrow", [
        "burrow/Point=0.5; 0.5; 0.5", "burrow/Radius=3", "burrow/Curvature=0.1",
        "burrow/Axis=1, 1, 0", "burrow/Bends towards=0, 0, 1"]),
    "ground": ("z min", "plane", []),
    "pipe": ("y min", "burrow", [
        "burrow/Point=0.5; 0.5; 0.5", "burrow/Radius=2 + t",
        "burrow/Axis=0, 0, 1"]),
    "slope": ("x min", "plane", ["plane/Point=-1; 0; 0",
                                 "plane/Normal=1; 0; t"])}


def settings(names):
    """ground.prm with these, in steps; its top goes sideways too."""
    found = [f"Boundary conditions/Names=top, {', '.join(names)}",
             "Boundary conditions/top/displacement/Components=x, y, z",
             "Boundary conditions/top/displacement/Displacement="
             "-0.2*t; 0; -0.2*t",
             "Time/First step=0.25", "Time/Largest step=0.25",
             "Output/Every=1", "Output/Energy=true"]
    for name in names:
        boundary, shape, entries = OBSTACLES[name]
        section = f"Boundary conditions/{name}/"
        found += [f"{section}Boundary={boundary}", f"{section}Type=contact",
                  f"{section}contact/Obstacle={shape}",
                  *(f"{section}contact/{entry}" for entry in entries)]
    return found


FRICTION = ["Boundary conditions/ground/contact/Friction=0.1, 0.1, 0.1",
            f"Boundary conditions/ground/contact/Elastic slip={DELTA}"]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return run_well(GROUND, tmp_path_factory.mktemp("run"),
                    settings(OBSTACLES) + FRICTION, 2)


def last_grid(folder):
    return read_grid(read_series(folder)[-1][1])


@pytest.mark.parametrize("ranks", [1, 2])
def test_pressure_of_a_patch(tmp_path, ranks):
    """Uniform where the block touches, by its closed form; zero elsewhere."""
    run_well(GROUND, tmp_path, [
        "Boundary conditions/ground/contact/Penetration=1e-8",
        "Output/Every=1"], ranks)
    grid = last_grid(tmp_path)
    on_ground = grid.points[:, 2] < 1e-9
    assert grid["contact_pressure"][on_ground] == pytest.approx(
        0.23 * (0.8**-2 - 0.8), rel=1e-6)
    assert (grid["contact_pressure"][~on_ground] == 0).all()
    assert (grid["slip"] == 0).all()


def test_slip_where_it_slides(run):
    """It is as long as the elastic slip nearly everywhere, in the plane and
    forward."""
    grid = last_grid(run.folder)
    touches = grid["contact_pressure"] > 0
    assert touches.any() and (grid.points[touches, 2] < 1e-9).all()
    slip = grid["slip"][touches]
    length = np.linalg.norm(slip, axis=1)
    assert length.max() == pytest.approx(DELTA, rel=1e-5)
    assert (length > (1 - 1e-5) * DELTA).mean() > 0.9
    assert slip[:, 2] == pytest.approx(0, abs=1e-9)
    assert slip[:, 0].mean() < -0.5 * DELTA
    assert (np.linalg.norm(grid["slip"][~touches], axis=1) == 0).all()


def test_without_a_contact_there_is_nothing_of_it(tmp_path):
    run_well(GROUND, tmp_path, ["Boundary conditions/Names=top",
                                "Output/Every=1"])
    assert {"contact_pressure", "slip"}.isdisjoint(
        last_grid(tmp_path).array_names)
    assert not list(tmp_path.glob("**/obstacles*"))
    assert json.loads((tmp_path / "run.json").read_text())["obstacles"] == []
    assert main([str(tmp_path), "--only", "anchors", "energy"]) == 0
    assert not (tmp_path / "anchors.png").exists()
    assert not (tmp_path / "energy.png").exists()


def distances(name, x, t):
    """How far points are from the surface of an obstacle, a closed form."""
    middle = np.array([0.5, 0.5, 0.5])
    if name == "ball":
        return np.linalg.norm(x - [0.5, 0.5, 2.5 + t], axis=1) - 1.2
    if name == "ground":
        return x[:, 2]
    if name == "slope":
        return (x - [-1, 0, 0]) @ [1, 0, t] / np.hypot(1, t)
    if name == "pipe":
        return np.linalg.norm((x - middle)[:, :2], axis=1) - (2 + t)
    # A torus: in the plane of the circle and across.
    centre = middle + [0, 0, 10]
    across = (x - centre) @ [1, -1, 0] / np.sqrt(2)
    within = np.linalg.norm(
        np.stack([(x - centre) @ [1, 1, 0] / np.sqrt(2),
                  (x - centre)[:, 2]]), axis=0)
    return np.hypot(within - 10, across) - 3


def check_normals(surface, t):
    """Away from the obstacle: the distance, which for burrows is positive within
    them, grows along the normal."""
    n = surface.compute_normals(
        consistent_normals=False, point_normals=False)["Normals"]
    middle = surface.cell_centers().points.astype(float)
    number = np.round(surface.point_data_to_cell_data()["obstacle"])
    for i, name in enumerate(OBSTACLES, 1):
        x, step = middle[number == i], 0.1 * n[number == i]
        grows = distances(name, x + step, t) - distances(name, x - step, t)
        if OBSTACLES[name][1] == "burrow":
            grows = -grows
        # The facets are not quite along the surface.
        assert (grows > 0.19).all(), name


def test_obstacles_are_where_they_are(run):
    series, obstacles = (read_series(run.folder, name)
                         for name in ("solution.pvd", "obstacles.pvd"))
    assert [t for t, _ in series] == [t for t, _ in obstacles]
    described = json.loads((run.folder / "run.json").read_text())["obstacles"]
    assert described == [
        {"name": name, "boundary": boundary, "shape": shape}
        for name, (boundary, shape, _) in OBSTACLES.items()]
    for t, file in obstacles:
        surface = read_obstacles(file)
        number = surface["obstacle"]
        assert set(number) == set(range(1, len(OBSTACLES) + 1))
        for i, name in enumerate(OBSTACLES, 1):
            x = surface.points[number == i].astype(float)
            assert distances(name, x, t) == pytest.approx(0, abs=1e-5)
        check_normals(surface, t)
    # A twentieth of the block's length, from the last state's box on outwards.
    ground = surface.points[number == 1 + list(OBSTACLES).index("ground")]
    x = np.unique(np.round(ground[:, 0] / 0.05, 3))
    assert x == pytest.approx(np.arange(x[0], x[-1] + 1))
    points = last_grid(run.folder)
    moved = points.points + points["displacement"]
    for d in (0, 1):
        assert ground[:, d].min() < moved[:, d].min()
        assert ground[:, d].max() > moved[:, d].max()
        assert np.ptp(ground[:, d]) < np.ptp(moved[:, d]) + 0.3


def test_obstacles_of_a_run_that_goes_on(tmp_path):
    run_well(GROUND, tmp_path, settings(["ground"]) + ["Time/End=0.5"])
    # As if a picture had been written since the checkpoint.
    shutil.copy(tmp_path / "vtu/obstacles_00002.vtu",
                tmp_path / "vtu/obstacles_00077.vtu")
    with open(tmp_path / "lumbricus.run", "a") as file:
        file.write("file vtu/obstacles_00077.vtu\n")
    go_on(tmp_path, ["Time/End=1"], ranks=2)
    series = read_series(tmp_path, "obstacles.pvd")
    assert [t for t, _ in series] == [0, 0.25, 0.5, 0.75, 1]
    assert sorted(tmp_path.glob("vtu/obstacles*")) == [file for _, file in series]


def test_drawings(run, tmp_path):
    """The same body with obstacles and without looks different, and the report has
    the anchored segments."""
    folder = shutil.copytree(run.folder, tmp_path / "copy")
    assert main([str(folder), "--count", "1", "--frames", "2"]) == 0
    report = (folder / "report.html").read_text()
    assert "Anchored segments" in report
    for name in ("anchors.png", "energy.png"):
        with Image.open(folder / name) as image:
            assert min(image.size) > 300
    with Image.open(folder / "picture.png") as image:
        seen = np.asarray(image.convert("RGB")).astype(int)
    (folder / "obstacles.pvd").unlink()
    assert main([str(folder), "--count", "1", "--only", "picture"]) == 0
    with Image.open(folder / "picture.png") as image:
        alone = np.asarray(image.convert("RGB")).astype(int)
    assert seen.shape == alone.shape
    assert (abs(seen - alone).max(axis=2) > 10).mean() > 0.01
    # The body is seen through them.
    assert (abs(seen - alone).max(axis=2) < 100).mean() > 0.99


def test_work_adds_up(run):
    """What is drawn are sums over time; the last ones are those of the table."""
    times, sums = read_work(run.folder / "energy.csv")
    assert list(times) == [0.25, 0.5, 0.75, 1]
    with open(run.folder / "energy.csv") as file:
        rows = [row for row in csv.DictReader(file) if row["kind"] == "stored"]
    assert sums["stored", "tissues"][-1] == pytest.approx(
        sum(float(row["work"]) for row in rows))
    assert set(sums) == {
        *(("boundary condition", name) for name in ("top", *OBSTACLES)),
        *(("friction", name) for name in OBSTACLES),
        ("stored", "tissues"), ("balance", "balance")}


def test_which_segments_are_anchored():
    """By any obstacle; a segment without skin is free."""
    contact = {name: np.array(values, dtype=float) for name, values in {
        "t": [0, 0, 0, 1, 1, 1], "segment": [1, 3, 1, 1, 3, 1],
        "area": [1, 0, 2, 1, 0, 0], "sliding": [1, 0, 0.1, 1, 1, 0],
        "anchored": [0, 0, 1, 0, 0, 0]}.items()}
    times, state = anchored(contact, np.array([1, 2, 3]))
    assert list(times) == [0, 1]
    assert state.tolist() == [[ANCHORED, FREE, FREE], [SLIDES, FREE, SLIDES]]
