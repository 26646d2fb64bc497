# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads that are not in balance on the minimal support: a bar that was pulled
at one end and held by nothing went through with exit code 0, while the held
point pulled a spike out of it whose length had no limit under refinement. Where
it is known before work it is refused; else there is a warning, and
reactions.csv has the forces and moments of all loads and supports."""
import csv
import pathlib

import pytest
from lumbricus_run import go_on, run, run_well

HERE = pathlib.Path(__file__).parent
ERRORS = HERE.parent / "errors"

BAR = ["Geometry/block/Lengths=4, 1, 1", "Geometry/block/Cells=4, 2, 2",
       "Geometry/block/Symmetry=", "Time/First step=0.5",
       "Time/Largest step=0.5", "Tissues/bar/Neo-Hooke/a=1"]


def loads(**named):
    """Loads by name: (boundary, kind, settings...)."""
    settings = ["Boundary conditions/Names=" + ", ".join(named)]
    for name, (boundary, kind, *of_kind) in named.items():
        section = f"Boundary conditions/{name}"
        settings += [f"{section}/Boundary={boundary.replace('_', ' ')}",
                     f"{section}/Type={kind}",
                     *(f"{section}/{kind}/{s}" for s in of_kind)]
    return settings


def pull(boundary, traction):
    return boundary, "dead traction", f"Traction={traction}"


def press(boundary, pressure):
    return boundary, "follower pressure", f"Pressure={pressure}"


def reactions(result, t=1.):
    """{name: (force, moment)} of all rows at a time."""
    with open(result.folder / "reactions.csv") as file:
        return {row["name"]: tuple([float(row[f"{what}_{c}"]) for c in "xyz"]
                                   for what in ("force", "moment"))
                for row in csv.DictReader(file) if float(row["t"]) == t}


REFUSED = {
    "pulled at one end": (
        loads(pull=pull("x max", "0.1*t; 0; 0")),
        ["At time 1 'pull' add up to the force (0.1, 0, 0) N",
         "type 'displacement' or 'spring'"]),
    "pulled at one end for a while": (
        loads(pull=pull("x max", "if(abs(t - 0.3) < 0.015, 0.1, 0); 0; 0")),
        ["At time 0.29 'pull' add up to the force (0.1, 0, 0) N"]),
    "bent, with a moment only": (
        loads(one=pull("x max", "0.1*t*(z - 0.5); 0; 0")),
        ["add up to the force (0, 0, 0) N and the moment (0, 0.00833, 0) N mm "
         "about (0, 0, 0)"]),
    "held along x, pulled along y": (
        loads(hold=("x min", "displacement", "Components=x"),
              pull=pull("x max", "0.1*t; 0.1*t; 0")),
        ["add up to the force (0, 0.1, 0) N"]),
    "a spring along the normal only": (
        loads(bed=("x min", "spring", "Only along the normal=true"),
              pull=pull("x max", "0; 0; 0.1*t")),
        ["add up to the force (0, 0, 0.1) N"]),
    "two per cent more at one end": (
        loads(one=pull("x max", "0.1*t; 0; 0"),
              other=pull("x min", "-0.097*t; 0; 0")),
        ["'one', 'other' add up to the force (0.003, 0, 0) N"]),
}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("name", REFUSED)
def test_is_refused(tmp_path, name, ranks):
    if ranks == 2 and name != "bent, with a moment only":
        pytest.skip("one of them is enough")
    settings, words = REFUSED[name]
    result = run(HERE / "bar.prm", tmp_path / "out", BAR + settings, ranks)
    assert result.exit_code == 1, result.log + result.message
    message = result.said()
    for word in ["lumbricus: The loads are not in balance.", *words]:
        assert word in message, message
    assert not [p for p in result.folder.glob("**/*") if p.is_file()]


BALANCED = {
    "pulled at both ends": loads(one=pull("x max", "0.1*t; 0; 0"),
                                 other=pull("x min", "-0.1*t; 0; 0")),
    "bent at both ends": loads(one=pull("x max", "0.1*t*(z - 0.5); 0; 0"),
                               other=pull("x min", "-0.1*t*(z - 0.5); 0; 0")),
    "pressed from all sides": loads(**{
        face.replace(" ", "_"): press(face, "0.1*t")
        for face in ("x min", "x max", "y min", "y max", "z min", "z max")}),
    "held by a spring": loads(bed=("x min", "spring", "Stiffness=1"),
                              pull=pull("x max", "0.01*t; 0.01*t; 0")),
    "a muscle and no load": [
        "Tissues/bar/Muscles=m", "Muscles/m/Fibres=longitudinal",
        "Muscles/m/Active stretch=expression",
        "Muscles/m/expression/Formula=1 - 0.2*t*y"],
}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("name", BALANCED)
def test_nothing_is_said_of_loads_in_balance(tmp_path, name, ranks):
    result = run_well(HERE / "bar.prm", tmp_path, BAR + BALANCED[name], ranks)
    assert "balance" not in result.log
    forces = reactions(result)
    assert all(abs(f) < 1e-7 for f in forces["sum"][0] + forces["sum"][1])
    if "minimal support" in forces:
        assert all(abs(f) < 1e-7 for f in forces["minimal support"][0])


@pytest.mark.parametrize("ranks", [1, 2])
def test_what_follows_the_deformation_is_warned_of(tmp_path, ranks):
    """A pressure on one end: the minimal support pulls with P A."""
    settings = BAR + loads(push=press("x max", "0.02*t"))
    result = run_well(HERE / "bar.prm", tmp_path, settings, ranks)
    assert result.log.count("the loads are not in balance") == 1
    line = " ".join(result.log[result.log.index("Warning: from"):].split())
    assert line.startswith(
        "Warning: from time 0.5 on the loads are not in balance: at (0, 0, 0) "
        "the minimal support pulls with 0.0")
    assert "N along x, 100 % of all loads" in line
    assert "type 'displacement' or 'spring'" in line
    forces = reactions(result)
    push, support = forces["push"][0], forces["minimal support"][0]
    assert push[0] == pytest.approx(-0.02, rel=0.05)
    for c in range(3):
        assert support[c] == pytest.approx(-push[c], abs=1e-8)
        assert forces["sum"][0][c] == pytest.approx(0, abs=1e-8)
        assert forces["sum"][1][c] == pytest.approx(0, abs=1e-8)


@pytest.mark.parametrize("ranks", [1, 2])
def test_reactions_against_closed_forms(tmp_path, ranks):
    """A bar that is held at one end and pulled at the other by a force that is
    given: force and moment of the support are those of statics at the displaced
    points, with hanging nodes too."""
    settings = BAR + loads(
        wall=("x min", "displacement"),
        pull=pull("x max", "0.02*t; 0.001*t; -0.002*t")) + [
            "Adaptivity/Every=1", "Output/Points=4, 0.5, 0.5"]
    result = run_well(HERE / "bar.prm", tmp_path, settings, ranks)
    assert any(row["refined"] > 0 for row in result.table("mesh.csv"))
    forces = reactions(result)
    assert list(forces) == ["wall", "pull", "sum"]
    assert forces["pull"][0] == pytest.approx([0.02, 0.001, -0.002], rel=1e-9)
    assert forces["wall"][0] == pytest.approx([-0.02, -0.001, 0.002], rel=1e-6)
    # The resultant acts in the middle of the face, where it is now.
    x = [result.table("points.csv")[-1]["u" + c] + X
         for c, X in zip("xyz", (4, 0.5, 0.5))]
    f = forces["pull"][0]
    moment = [x[1] * f[2] - x[2] * f[1], x[2] * f[0] - x[0] * f[2],
              x[0] * f[1] - x[1] * f[0]]
    assert forces["pull"][1] == pytest.approx(moment, rel=2e-2, abs=2e-5)
    for a, b in zip(forces["pull"][1], forces["wall"][1]):
        assert a == pytest.approx(-b, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("coupling", ["tied", "slip"])
def test_all_forces_add_up(tmp_path, coupling, ranks):
    """On a quarter of a chain, with planes of symmetry that a pressure presses
    on: over p times their area, and with a liquid that slips."""
    result = run_well(ERRORS / "chain.prm", tmp_path, [
        f"Interface/Coupling={coupling}", "Time/First step=0.5"], ranks)
    assert "balance" not in result.log
    forces = reactions(result)
    assert list(forces)[:3] == ["push", "symmetry y", "symmetry z"]
    for what in (0, 1):
        assert forces["sum"][what] == pytest.approx([0, 0, 0], abs=1e-7)
    # The quarter is its own mirror image, with y and z exchanged.
    assert forces["push"][0][1] < -0.01 * 2 * 4
    assert forces["push"][0][2] == pytest.approx(forces["push"][0][1], rel=1e-6)
    assert forces["symmetry y"][0][1] == pytest.approx(
        -forces["push"][0][1], rel=1e-6)


def test_table_goes_on_after_a_restart(tmp_path):
    settings = BAR + BALANCED["pulled at both ends"] + ["Checkpoints/Steps=1"]
    whole = run_well(HERE / "bar.prm", tmp_path / "whole", settings)
    half = run_well(HERE / "bar.prm", tmp_path / "half",
                    settings + ["Time/End=0.5"])
    go_on(half.folder, ["Time/End=1"])
    for t in (0.5, 1.):
        for name, (force, moment) in reactions(whole, t).items():
            again = reactions(half, t)[name]
            assert again[0] == pytest.approx(force, abs=1e-9)
            assert again[1] == pytest.approx(moment, abs=1e-9)
