# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body without stress may move as far as it likes, on any mesh and in any
units. First seen with a free muscle: the residual was measured against a stress
of 1e-6 of the stiffness at least, of which Newton's tolerance of 1e-9 is less
than rounding leaves once nodes have moved by a millimetre. A block of 8 x 4 x 4
cells stopped at t = 0.984, one of 16 x 8 x 8 at 0.779, a bar that is pushed after
1 mm, all with "Newton's method does not converge ... increment 2e-16"."""
import math
import pathlib

import pytest
from lumbricus_run import run_well

HERE = pathlib.Path(__file__).parent
BAR = HERE / "free_bar.prm"
MUSCLE = HERE / "free_muscle.prm"
MOTION = "Boundary conditions/hand/displacement/Displacement="


def places(result):
    """Where the points are in the end, by where they are at rest."""
    rows = result.table("points.csv")
    assert rows[-1]["t"] == 1
    return {(row["x"], row["y"], row["z"]):
            [row[x] + row["u" + x] for x in "xyz"]
            for row in rows if row["t"] == 1}


def distance(at, a, b):
    return math.dist(at[a], at[b])


@pytest.mark.parametrize("cells, ranks", [("2, 1, 1", 1), ("3, 5, 2", 1),
                                          ("8, 4, 4", 2)])
def test_free_contraction(tmp_path, cells, ranks):
    """A muscle that shortens to 0.6 is 2 x 0.6 mm long and 0.6^(-1/2) wide."""
    at = places(run_well(MUSCLE, tmp_path,
                         [f"Geometry/block/Cells={cells}"], ranks))
    for point, length in (((2, 0, 0), 1.2), ((0, 1, 0), 0.6**-0.5),
                          ((0, 0, 1), 0.6**-0.5)):
        assert distance(at, (0, 0, 0), point) == pytest.approx(
            length, rel=1e-9), point


def rigid(at, expected, size):
    """All points where they are expected, to a relative 1e-9."""
    for point, place in at.items():
        for x, y in zip(place, expected(*point)):
            assert x == pytest.approx(y, abs=1e-9 * size), point


# The bar is 2 mm long.
@pytest.mark.parametrize("way", [(1.9, 0, 0), (2000, 0, 0),
                                 (-900, 1200, 2000)], ids=str)
def test_translation(tmp_path, way):
    """Pushed at one end, by up to a thousand of its lengths, a bar comes along.
    Further than its length in one step is no leap: all of it goes there."""
    result = run_well(BAR, tmp_path,
                      [MOTION + "; ".join(f"{x}*t" for x in way)])
    assert len(result.steps()) == 4
    rigid(places(result), lambda *X: [a + b for a, b in zip(X, way)],
          max(1, math.hypot(*way)))
    assert result.last()["wall_volume"] == pytest.approx(2, rel=1e-10)


@pytest.mark.parametrize("way", [0, 2000])
def test_rotation(tmp_path, way):
    """Turned by 150 degrees about z at one end, and taken away."""
    angle = 5 / 6 * math.pi
    c, s = f"cos({angle}*t)", f"sin({angle}*t)"
    result = run_well(BAR, tmp_path, [
        MOTION + f"{way}*t + ({c}-1)*x - {s}*y; {s}*x + ({c}-1)*y; 0",
        "Geometry/block/Cells=4, 2, 2", "Time/First step=0.1",
        "Time/Largest step=0.1"])
    cos, sin = math.cos(angle), math.sin(angle)
    rigid(places(result), lambda x, y, z: [way + cos * x - sin * y,
                                           sin * x + cos * y, z],
          max(1, way))


@pytest.mark.parametrize("settings", [
    # Metres and pascals.
    ["Geometry/block/Lengths=2e-3, 1e-3, 1e-3", "Tissues/bar/Neo-Hooke/a=1e6",
     MOTION + "1.9e-3*t; 0; 0", "Output/Points=2e-3, 0, 0"],
    # Kilometres long, and soft.
    ["Geometry/block/Lengths=2e3, 1e3, 1e3", "Tissues/bar/Neo-Hooke/a=1e-9",
     MOTION + "1.9e3*t; 0; 0", "Output/Points=2e3, 0, 0"],
    # Half of it a hundred million times softer.
    ["Tissues/bar/Neo-Hooke/a=1e-8", MOTION + "1.9*t; 0; 0",
     "Output/Points=2, 0, 0"],
    # Compressible.
    ["Tissues/bar/Neo-Hooke/nu=0.3", MOTION + "1.9*t; 0; 0",
     "Output/Points=2, 0, 0"]], ids=["SI", "large", "soft", "nu = 0.3"])
def test_units(tmp_path, settings):
    row = run_well(BAR, tmp_path, settings).table("points.csv")[-1]
    assert row["t"] == 1
    assert row["ux"] == pytest.approx(0.95 * row["x"], rel=1e-9)
    for u in ("uy", "uz"):
        assert abs(row[u]) < 1e-9 * row["x"]


def test_a_loaded_body_is_solved_as_before(tmp_path):
    """Where there is stress, rounding is far below the tolerance: far away a
    load makes what it makes at home."""
    settings = ["Boundary conditions/Names=hand, pull",
                "Boundary conditions/pull/Boundary=x max",
                "Boundary conditions/pull/Type=dead traction",
                "Boundary conditions/pull/dead traction/Traction=0.5*t; 0; 0"]
    home = run_well(BAR, tmp_path / "home", settings + [MOTION + "0; 0; 0"])
    far = run_well(BAR, tmp_path / "far", settings + [MOTION + "2000*t; 0; 0"])
    for a, b in zip(home.table("newton.csv"), far.table("newton.csv")):
        assert a["force_residual"] < 1 and b["force_residual"] < 1
    last = {row["step"]: row for row in home.table("newton.csv")}
    assert len(last) == 4
    assert max(row["force_residual"] for row in last.values()) < 1e-9
    for point, place in places(home).items():
        assert places(far)[point] == pytest.approx(
            [place[0] + 2000, *place[1:]], abs=1e-9), point
