# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact.csv and body.csv: what is known of a block on the ground and of a chain
in a burrow, and that they agree with the other tables."""
import csv
import pathlib

import numpy as np
import pytest
from lumbricus_run import go_on, run_well

HERE = pathlib.Path(__file__).parent
GROUND = HERE / "ground.prm"
CHAIN = HERE / "chain.prm"
RANKS = pytest.mark.parametrize("ranks", [1, 2])
N = 0.01
MU_FORWARD, MU_BACKWARD = 0.3, 0.6
STEPS = ["Time/First step=0.125", "Time/Largest step=0.125"]


def condition(name, kind, boundary, **entries):
    section = f"Boundary conditions/{name}/"
    return [f"{section}Boundary={boundary}", f"{section}Type={kind}",
            *(f"{section}{kind}/{key.replace('_', ' ')}={value}"
              for key, value in entries.items())]


def conditions(**entries):
    """(kind, boundary, entries) by name, beside the ground."""
    settings = ["Boundary conditions/Names=ground, " + ", ".join(entries)]
    for name, (kind, boundary, more) in entries.items():
        settings += condition(name, kind, boundary, **more)
    return settings


def dragged(velocity):
    """A flat block, pressed by N onto ground that moves along x from t = 1/4 on;
    plane strain, so that it slides along x alone."""
    return [
        "Geometry/block/Lengths=1, 1, 0.2", "Geometry/block/Cells=4, 2, 1",
        "Boundary conditions/ground/contact/Friction="
        f"{MU_FORWARD}, {MU_BACKWARD}, 0.1",
        "Boundary conditions/ground/contact/plane/Point="
        f"{velocity}*max(0, t - 0.25); 0; 0", *STEPS,
        *conditions(
            top=("displacement", "z max", {
                "Components": "x, y", "Displacement": "0; 0; 0"}),
            press=("dead traction", "z max", {
                "Traction": f"0; 0; -{N}*min(1, 4*t)"}),
            one_side=("displacement", "y min", {"Components": "y"}),
            other_side=("displacement", "y max", {"Components": "y"}))]


def table(folder, name):
    with open(folder / name) as file:
        return [{key: float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def contacts(folder):
    with open(folder / "contact.csv") as file:
        return [{key: value if key == "name" else float(value)
                 for key, value in row.items()} for row in csv.DictReader(file)]


def reactions(folder):
    """The force of every condition by time and name."""
    with open(folder / "reactions.csv") as file:
        return {(float(row["t"]), row["name"]):
                np.array([float(row["force_" + c]) for c in "xyz"])
                for row in csv.DictReader(file)}


def vector(row, name):
    return np.array([row[f"{name}_{c}"] for c in "xyz"])


def check_sums(folder):
    """The forces on all segments are the reactions, and consist of pressure and
    friction."""
    sums = {}
    for row in contacts(folder):
        key = row["t"], row["name"]
        sums[key] = sums.get(key, 0) + vector(row, "force")
    expected = reactions(folder)
    assert len(sums) > 1
    for key, force in sums.items():
        if key[0] > 0:
            assert force == pytest.approx(expected[key], rel=1e-9, abs=1e-14)


@RANKS
@pytest.mark.parametrize("velocity, mu", [(0.2, MU_FORWARD),
                                          (-0.2, MU_BACKWARD)])
def test_dragged_block(tmp_path, velocity, mu, ranks):
    """The ground pulls it by mu N against its friction, and all of it slides; it
    is pulled towards the tail where it slides forward."""
    run_well(GROUND, tmp_path, dragged(velocity), ranks)
    rows = contacts(tmp_path)
    assert [row["t"] for row in rows] == [row["t"] for row in
                                          table(tmp_path, "body.csv")]
    assert {(row["name"], row["segment"]) for row in rows} == {("ground", 1)}
    # At rest it just touches, and does not press.
    assert rows[0]["area"] == pytest.approx(1, rel=1e-12)
    assert rows[0]["penetration"] < 1e-12
    assert abs(rows[0]["normal_force"]) < 1e-12
    assert (rows[0]["sliding"], rows[0]["anchored"]) == (0, 1)
    last = rows[-1]
    assert last["normal_force"] == pytest.approx(N, rel=1e-8)
    assert vector(last, "friction") == pytest.approx(
        np.array([np.sign(velocity) * mu * N, 0, 0]), rel=1e-8, abs=1e-12)
    assert vector(last, "force") == pytest.approx(
        vector(last, "friction") + [0, 0, N], rel=1e-8, abs=1e-12)
    assert (last["sliding"], last["anchored"]) == (1, 0)
    # 'Penetration' of the thickness of a cell.
    assert 0 < last["penetration"] < 1e-3 * 0.2
    assert 0 < last["area"] <= 1 + 1e-12
    check_sums(tmp_path)


@RANKS
def test_block_at_rest_is_anchored(tmp_path, ranks):
    """Under pressure alone, which is uniform where the block can widen: friction
    keeps it from sliding where it is strong."""
    run_well(GROUND, tmp_path, [
        *conditions(press=("dead traction", "z max",
                           {"Traction": f"0; 0; -{N}*t"})),
        "Boundary conditions/ground/contact/Friction=5, 5, 5",
        "Boundary conditions/ground/contact/Elastic slip=0.1",
        *STEPS], ranks)
    for row in contacts(tmp_path)[1:]:
        assert row["normal_force"] == pytest.approx(N * row["t"], rel=1e-8)
        assert row["area"] == pytest.approx(1, rel=1e-12)
        assert (row["sliding"], row["anchored"]) == (0, 1)
        assert vector(row, "friction") == pytest.approx(
            np.zeros(3), abs=1e-8 * N)


@RANKS
def test_without_friction_nothing_is_anchored(tmp_path, ranks):
    """ground.prm: the top goes down by 0.2, a patch of uniform pressure."""
    run_well(GROUND, tmp_path, [
        "Boundary conditions/ground/contact/Penetration=1e-8"], ranks)
    last = contacts(tmp_path)[-1]
    assert last["normal_force"] == pytest.approx(0.23 * (0.8**-2 - 0.8),
                                                 rel=1e-6)
    assert (last["sliding"], last["anchored"]) == (1, 0)
    assert vector(last, "friction") == pytest.approx(np.zeros(3), abs=1e-12)
    assert last["area"] == pytest.approx(1, rel=1e-12)


def burrow(section, liquid="cavity"):
    return [f"Geometry/segment chain/Cross-section={section}",
            f"Geometry/segment chain/Liquid={liquid}",
            "Boundary conditions/Names=wall, end", "Time/End=0.2",
            *condition("end", "displacement", "tail", Components="x"),
            *condition("wall", "contact", "skin", Obstacle="burrow",
                       Friction="0.5, 1, 0.5"),
            "Boundary conditions/wall/contact/burrow/Radius=2.53",
            "Muscles/longitudinal/expression/Formula=1 - 1.2*t",
            "Muscles/circular/wave/Amplitude=0"]


@pytest.fixture(scope="module")
def in_burrow(tmp_path_factory):
    folder = tmp_path_factory.mktemp("burrow")
    for section, ranks in (("quarter", 1), ("half", 2)):
        run_well(CHAIN, folder / section, burrow(section), ranks)
    return folder


def test_segments_in_a_burrow(in_burrow):
    """Only the segment in the middle is wide enough to touch at first; forces are
    those on the part that is computed."""
    quarter, half = (contacts(in_burrow / name) for name in ("quarter", "half"))
    assert [row["segment"] for row in quarter[:3]] == [1, 2, 3]
    assert [row["segment"] for row in quarter] == [row["segment"]
                                                   for row in half]
    pressed = {row["segment"] for row in quarter if row["normal_force"] > 0}
    assert 2 in pressed
    for one, two in zip(quarter, half):
        for name in ("normal_force", "area", "friction_x"):
            assert two[name] == pytest.approx(2 * one[name], rel=1e-6, abs=1e-9)
        assert two["anchored"] == one["anchored"]
        # The skin of the quarter is pushed towards the axis.
        if one["normal_force"] > 0:
            assert one["force_y"] < 0 and one["force_z"] < 0
            assert abs(two["force_z"]) < 1e-9
    for name in ("quarter", "half"):
        check_sums(in_burrow / name)


def test_what_is_apart_does_not_touch(in_burrow):
    """At rest all of the skin seemed to touch a burrow that is 0.03 mm away, where
    rounding made it so, and was pushed from there on: its anchors stayed in it."""
    for name in ("quarter", "half"):
        for row in contacts(in_burrow / name)[:3]:
            assert row["t"] == row["area"] == row["anchored"] == 0
            assert row["normal_force"] == 0


def test_body_of_a_part(in_burrow):
    """The centre of the whole body is on its axis."""
    quarter, half = (table(in_burrow / name, "body.csv")
                     for name in ("quarter", "half"))
    for one, two in zip(quarter, half):
        assert (one["y"], one["z"]) == (0, 0)
        assert abs(two["z"]) < 1e-9 and two["y"] == 0
        for name in ("x", "head_x", "tail_x", "length", "stride"):
            assert two[name] == pytest.approx(one[name], abs=1e-6)


@RANKS
@pytest.mark.parametrize("density", [1.05e-9, 0])
def test_moved_block(tmp_path, ranks, density):
    """Rigidly, by a prescribed displacement of two ends: the stride is that
    towards the head."""
    way = "-0.5*t^2; 0.1*t; -0.2*t"
    run_well(GROUND, tmp_path, [
        "Geometry/block/Lengths=2, 1, 0.5", *STEPS,
        f"Tissues/block/Density={density}",
        "Boundary conditions/Names=head, tail",
        *condition("head", "displacement", "x min", Displacement=way),
        *condition("tail", "displacement", "x max", Displacement=way)], ranks)
    rows = table(tmp_path, "body.csv")
    before = None
    for row in rows:
        t = row["t"]
        moved = np.array([-0.5 * t**2, 0.1 * t, -0.2 * t])
        assert [row[c] for c in "xyz"] == pytest.approx(
            np.array([1, 0.5, 0.25]) + moved, abs=1e-9)
        assert row["head_x"] == pytest.approx(moved[0], abs=1e-9)
        assert row["tail_x"] == pytest.approx(2 + moved[0], abs=1e-9)
        assert row["length"] == pytest.approx(2, abs=1e-9)
        assert row["stride"] == pytest.approx(0.5 * t**2, abs=1e-9)
        speed = 0 if before is None else 0.5 * (t + before)
        assert row["speed"] == pytest.approx(speed, abs=1e-7)
        before = t
    assert not (tmp_path / "contact.csv").exists()


def test_forward_is_that_of_the_contact(tmp_path):
    """A block that goes with the ground, along y and away from it."""
    settings = [
        "Boundary conditions/Names=ground, top",
        "Boundary conditions/ground/contact/Forward=0, 2, 0",
        *condition("top", "displacement", "z max",
                   Components="x, y, z", Displacement="t; 0.5*t; 0.1*t")]
    run_well(GROUND, tmp_path, settings)
    last = table(tmp_path, "body.csv")[-1]
    assert last["stride"] == pytest.approx(0.5, abs=1e-9)
    assert contacts(tmp_path)[-1]["normal_force"] == 0


def test_contents_weigh_too(tmp_path):
    """A chamber that is heavy against the wall has the body's centre in it: that of
    the second of three, wherever the wall is."""
    run_well(CHAIN, tmp_path, [
        "Geometry/segment chain/Liquid=cavity", "Time/End=0.1",
        "Cavities/Segments with their own content=2",
        "Cavities/Segment 2/Content=liquid",
        "Cavities/Segment 2/liquid/Density=1"])
    segments = table(tmp_path, "segments.csv")
    rows = table(tmp_path, "body.csv")
    for row in rows:
        lengths = [s["length"] for s in segments if s["t"] == row["t"]]
        # Septa are bent by the pressures of both sides.
        assert row["x"] == pytest.approx(
            row["head_x"] + lengths[0] + 0.5 * lengths[1], rel=0.05)
    assert rows[-1]["stride"] != 0


@pytest.mark.parametrize("ranks, tolerance", [(1, 1e-12), (2, 1e-8)])
def test_restart_in_the_middle_of_a_slip(tmp_path, ranks, tolerance):
    """All tables go on as if there had been no end: also the speed, which hangs on
    the step before."""
    settings = dragged(0.2)
    run_well(GROUND, tmp_path / "whole", settings)
    run_well(GROUND, tmp_path / "cut", [*settings, "Time/End=0.5"])
    assert contacts(tmp_path / "cut")[-1]["sliding"] == 1
    go_on(tmp_path / "cut", ["Time/End=1"], ranks=ranks)
    check_same(tmp_path / "cut", tmp_path / "whole", tolerance)


def check_same(folder, other, tolerance):
    """Relative; what is less than a thousandth of that is rounding of the largest
    numbers, which are about 1."""
    for name in ("contact.csv", "body.csv", "reactions.csv"):
        found, expected = ((one / name).read_text().splitlines()
                           for one in (folder, other))
        assert len(found) == len(expected)
        for row, of_other in zip(found[1:], expected[1:]):
            for a, b in zip(row.split(","), of_other.split(",")):
                assert a == b or float(a) == pytest.approx(
                    float(b), rel=tolerance, abs=1e-3 * tolerance), name


def test_step_that_is_cut_in_the_middle_of_a_slip(tmp_path):
    """A step that fails leaves nothing behind in what the skin remembers: at
    t = 0.55 the load is such that there is no solution, and the step to there,
    which is halved, ends as one that was to end so."""
    settings = [
        "Geometry/block/Lengths=4, 4, 1", "Geometry/block/Cells=4, 4, 1",
        "Tissues/block/Neo-Hooke/a=2.3",
        "Boundary conditions/ground/contact/Friction=0.3, 0.6, 1.2",
        *conditions(
            top=("displacement", "z max", {
                "Components": "x, y",
                "Displacement": "0.06*max(t - 0.2, 0); 0; 0"}),
            press=("dead traction", "z max", {
                "Traction": "0; 0; -1/16*min(1, 5*t)*"
                            "(1 + 1e4*exp(-((t - 0.55)/0.01)^2))"})),
        "Time/Largest miss=1", "Time/End=0.7", "Time/First step=0.05",
        "Time/Largest step=0.1", "Time/Growth=2", "Time/Easy iterations=100"]
    run = run_well(GROUND, tmp_path / "cut", settings)
    assert [row["cuts"] for row in run.steps()] == [0] * 5 + [1, 0, 0]
    calm = run_well(GROUND, tmp_path / "calm",
                    [*settings, "Time/Result interval=0.5"])
    assert [row["cuts"] for row in calm.steps()] == [0] * 8
    rows = {round(row["t"], 9): row for row in contacts(tmp_path / "cut")}
    assert 0 < rows[0.45]["sliding"] < rows[0.5]["sliding"] < 1
    check_same(tmp_path / "cut", tmp_path / "calm", 1e-8)


def test_refined_cells_under_contact(tmp_path):
    """Hanging nodes change neither the sums nor the area."""
    run_well(GROUND, tmp_path, [
        "Boundary conditions/ground/contact/Friction=0.3, 0.6, 0.45",
        "Adaptivity/Every=1", "Time/End=0.5", "Time/First step=0.25"], 2)
    assert table(tmp_path, "mesh.csv")[-1]["refined"] > 0
    assert contacts(tmp_path)[-1]["area"] == pytest.approx(1, rel=1e-12)
    check_sums(tmp_path)
