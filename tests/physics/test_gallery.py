# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery on coarser meshes or in fewer steps: the numbers of its READMEs,
closed forms, and mirror images. Cases that are not here have tests of their own."""
import math

import pytest
from lumbricus_run import SOURCE, run_well

CHAIN = "Geometry/segment chain/"


def case(name, folder, settings, monkeypatch):
    # Paths in the cases are relative to the top folder.
    monkeypatch.chdir(SOURCE)
    return run_well(SOURCE / "parameters" / name / "case.prm", folder,
                    settings + ["Output/Every=0"])


def steps_of(size):
    return [f"Time/{name}={size}" for name in
            ("First step", "Largest step", "Result interval")]


def at(rows, t):
    """The points at a time, by number."""
    return {int(row["point"]): row for row in rows if abs(row["t"] - t) < 1e-9}


def volumes_kept(result, tolerance):
    rows = result.segments()
    for row in rows:
        first = next(r for r in rows if r["segment"] == row["segment"])
        for volume in ("fluid_volume", "wall_volume"):
            assert row[volume] == pytest.approx(first[volume], rel=tolerance)


def rotation(one, other):
    """Of the line from the other point to the one, about the x axis."""
    return math.atan2(one["z"] + one["uz"] - other["z"] - other["uz"],
                      one["y"] + one["uy"] - other["y"] - other["uy"])


def test_helical_twist(tmp_path, monkeypatch):
    twists = []
    for angle in (45, -45):
        result = case("helical_twist", tmp_path / str(angle), [
            CHAIN + "Cells along a segment=4", "Time/End=0.5",
            f"Muscles/helix/helical/Angle={angle}"] + steps_of(0.25),
            monkeypatch)
        points = at(result.table("points.csv"), 0.5)
        twists.append(rotation(points[7], points[8]) -
                      rotation(points[1], points[2]))
        volumes_kept(result, 1e-10)
        # A long tube twists by so much per length, the closed form says.
        middle = (rotation(points[5], points[6]) -
                  rotation(points[3], points[4])) / \
            (points[5]["x"] - points[3]["x"])
        assert abs(middle) == pytest.approx(0.09398, rel=2e-3)
    assert math.degrees(twists[0]) == pytest.approx(-43.086, abs=0.1)
    assert twists[1] == pytest.approx(-twists[0], rel=1e-8)


def test_bending_tentacle(tmp_path, monkeypatch):
    angles = []
    for side in ("z > 0 ? 1 - 0.5*t*z/2 : 1", "z < 0 ? 1 + 0.5*t*z/2 : 1"):
        result = case("bending_tentacle", tmp_path / str(len(angles)), [
            CHAIN + "Cells along a segment=2", "Time/End=0.5",
            f"Muscles/upper/expression/Formula={side}"] + steps_of(0.125),
            monkeypatch)
        points = at(result.table("points.csv"), 0.5)
        angles.append(math.degrees(math.atan2(
            -(points[1]["ux"] - points[2]["ux"]),
            points[1]["z"] - points[2]["z"] +
            points[1]["uz"] - points[2]["uz"])))
        volumes_kept(result, 1e-10)
        assert min(row["wall_mesh_quality"] for row in result.segments()) > 0.7
    # A beam at large strains bends by 34.78 degrees.
    assert abs(angles[0]) == pytest.approx(34.393, rel=2e-3)
    assert abs(angles[0]) == pytest.approx(34.78, rel=0.05)
    assert angles[1] == pytest.approx(-angles[0], rel=1e-6)


def test_soft_actuator(tmp_path, monkeypatch):
    settings = ["Time/End=0.3"] + steps_of(0.1)
    bent = case("soft_actuator", tmp_path / "bent", settings, monkeypatch)
    volumes_kept(bent, 1e-10)
    straight = case("soft_actuator", tmp_path / "straight", settings +
                    ["Tissues/strip/Neo-Hooke/a=0.0005",
                     "Linear solver/Method=direct"], monkeypatch)
    length = straight.last()["length"]
    assert length - 16 == pytest.approx(1.4251, rel=3e-3)
    # A tube whose outside keeps its radius becomes 1.611 longer.
    assert 0.85 < (length - 16) / 1.611 < 0.95
    assert bent.last()["length"] < length
