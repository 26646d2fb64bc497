# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points on the true circle of the skin are points of the body.

Where a formula puts a point on a round skin, the mesh, whose curved faces are
quadratic, is up to some thousandths of the radius inside: five of eight such
points were refused as outside of the body. The nearest point of the body within
a tenth of a cell stands for it, and the log says how far it is."""
import math
import re

import pytest
from lumbricus_run import run, run_well

RADIUS = 2.3
CASE = """
subsection Geometry
  set Shape = segment chain
  subsection segment chain
    set Number of segments     = 1
    set Wall layers            = wall
    set Wall layer thicknesses = 0.3
    set Cross-section          = quarter
    set Cells around a quarter = 2
  end
end
subsection Boundary conditions
  set Names = push
  subsection push
    set Boundary = skin
    set Type     = follower pressure
    subsection follower pressure
      set Pressure = 0.001*t
    end
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
"""
ANGLES = (0, 15, 22.5, 30, 45, 60, 80, 90)


def circle(radius):
    return "; ".join(f"1.5, {radius * math.cos(math.radians(a)):.6f}, "
                     f"{radius * math.sin(math.radians(a)):.6f}"
                     for a in ANGLES)


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    path = tmp_path_factory.mktemp("skin") / "case.prm"
    path.write_text(CASE)
    return path


@pytest.mark.parametrize("settings", [
    [], ["Mesh/Global refinements=1"],
    ["Adaptivity/Every=1", "Adaptivity/Cycles=1"]], ids=["coarse", "refined",
                                                         "adapted"])
def test_points_on_the_true_circle(case, settings, tmp_path):
    runs = [run_well(case, tmp_path / str(ranks),
                     [*settings, "Output/Points=" + circle(RADIUS)], ranks)
            for ranks in (1, 2)]
    one, two = (result.table("points.csv") for result in runs)
    assert len(one) == 2 * len(ANGLES)
    for row, other in zip(one, two):
        for name, value in row.items():
            assert other[name] == pytest.approx(value, rel=1e-9, abs=1e-9), name
    # The points are those that were asked for, and the skin goes inwards.
    for row, a in zip(one[len(ANGLES):], ANGLES):
        assert math.hypot(row["y"], row["z"]) == pytest.approx(RADIUS, abs=1e-6)
        assert row["ux"]**2 + row["uy"]**2 + row["uz"]**2 > 0
    for result in runs:
        said = re.findall(r"of 'Output/Points' is outside of the mesh: the "
                          r"nearest point of the body, (\S+) mm away",
                          result.log)
        assert 1 <= len(said) <= len(ANGLES)
        assert all(float(distance) < 2e-3 for distance in said)


def test_the_nearest_point_is_on_the_skin_and_that_far_away(case, tmp_path):
    # Cells there are 1.8 mm long: a tenth is 0.18 mm.
    result = run_well(case, tmp_path / "out",
                      ["Output/Points=1.5, 0, 2.4; 1.5, 0, 2.3"])
    distance, x, y, z = map(float, re.search(
        r"point \(1.5, 0, 2.4\) of 'Output/Points' is outside of the mesh: the "
        r"nearest point of the body, (\S+) mm away at \((\S+), (\S+), (\S+)\)",
        result.log).groups())
    assert (distance, x, z) == pytest.approx((0.1, 1.5, 2.3), abs=1e-6)
    assert y == pytest.approx(0, abs=1e-6)
    # What is written is that of the nearest point.
    outside, skin = result.table("points.csv")[-2:]
    for name in ("ux", "uy", "uz", "pressure", "sxx", "syy", "szz", "J"):
        assert outside[name] == pytest.approx(skin[name], rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("ranks", [1, 2])
def test_points_further_outside_are_refused(case, ranks, tmp_path):
    result = run(case, tmp_path / "out", ["Output/Points=1.5, 0, 2.6"], ranks)
    message = result.said()
    assert result.exit_code == 1
    assert "the point (1.5, 0, 2.6) is not in the body" in message
    assert re.search(r"nearest point of the mesh at rest is \(1.5, \S+, 2.3\), "
                     r"0.3 mm away, which is more than 0.1 of the cell there",
                     message), message
