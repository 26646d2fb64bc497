# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forces on all points of tissues: a block in a box is hydrostatic, whatever it is
made of; what it weighs is what its supports carry; and what cannot be is refused."""
import pathlib

import pytest
from lumbricus_run import run, run_well
from test_reactions import reactions

BAR = pathlib.Path(__file__).parent / "free_bar.prm"
WEIGHT = ["Body forces/Names=weight", "Body forces/weight/Type=dead body force"]


def weight(force, *more):
    return [*WEIGHT, f"Body forces/weight/dead body force/Force={force}", *more]


def held(**named):
    """Boundaries that are held along some axes, by name of the boundary."""
    settings = ["Boundary conditions/Names=" + ", ".join(named)]
    for name, components in named.items():
        section = f"Boundary conditions/{name}"
        settings += [f"{section}/Boundary={name.replace('_', ' ')}",
                     f"{section}/Type=displacement",
                     f"{section}/displacement/Components={components}"]
    return settings


BLOCK = ["Geometry/block/Lengths=2, 1, 1", "Geometry/block/Cells=3, 2, 1",
         "Time/First step=0.5", "Time/Largest step=0.5"]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_block_in_a_box(ranks, tmp_path):
    """It does not move, and its pressure grows with the depth: -0.3 (2 - x)."""
    result = run_well(BAR, tmp_path, [
        *BLOCK, *weight("-0.3*t; 0; 0"),
        *held(x_min="x", y_max="y", z_max="z", y_min="y", z_min="z"),
        "Geometry/block/Symmetry=", "Output/Points=0, 0.5, 0.5; 1.5, 0.2, 0.9"],
        ranks)
    rows = result.table("points.csv")
    assert len(rows) == 6
    for row in rows:
        for stress in ("sxx", "syy", "szz"):
            assert row[stress] == pytest.approx(-0.3 * row["t"] * (2 - row["x"]),
                                                abs=1e-10)
        assert max(abs(row[u]) for u in ("ux", "uy", "uz")) < 1e-10
    table = (result.folder / "reactions.csv").read_text()
    for row in ("body force,weight", "boundary condition,x_min",
                "boundary condition,y_max", "sum,sum"):
        assert f"\n1,{row}," in table
    found = reactions(result)
    force, moment = found["weight"]
    assert [*force, *moment] == pytest.approx([-0.6, 0, 0, 0, -0.3, 0.3], abs=1e-10)
    assert found["x_min"][0][0] == pytest.approx(0.6, abs=1e-9)
    assert found["y_max"][0][1] == pytest.approx(-0.6, abs=1e-9)
    assert [*found["sum"][0], *found["sum"][1]] == pytest.approx([0] * 6, abs=1e-9)


def test_a_bar_that_hangs(tmp_path):
    """It gets longer, above more than below, and its support carries it all."""
    result = run_well(BAR, tmp_path, [
        *BLOCK, *weight("0.02*t; 0.01*t*x; 0"), *held(x_min="x, y, z"),
        "Geometry/block/Symmetry=", "Output/Points=1, 0.5, 0.5; 2, 0.5, 0.5"])
    rows = [row for row in result.table("points.csv") if row["t"] == 1]
    assert rows[0]["ux"] > rows[1]["ux"] / 2 > 0
    table = (result.folder / "reactions.csv").read_text()
    for row in ("body force,weight", "boundary condition,x_min", "sum,sum"):
        assert f"\n1,{row}," in table
    found = reactions(result)
    assert found["weight"][0] == pytest.approx([0.04, 0.02, 0], abs=1e-12)
    assert found["x_min"][0] == pytest.approx([-0.04, -0.02, 0], abs=1e-9)
    assert [*found["sum"][0], *found["sum"][1]] == pytest.approx([0] * 6, abs=1e-8)


CHAIN = pathlib.Path(__file__).parent / "chain.prm"
REFUSED = {
    "nothing holds it": (BAR, weight("0.1; 0; 0", "Geometry/block/Symmetry=",
                                     "Boundary conditions/Names="),
                         ["The loads are not in balance", "'weight' add up to"]),
    "not symmetric": (BAR, weight("0; 0.1; 0", "Geometry/block/Symmetry=y"),
                      ["body force 'weight' is not symmetric to the plane of "
                       "symmetry y = 0", "by = 0.1 N/mm^3"]),
    "a liquid": (CHAIN, weight("0; 0; 0", "Body forces/weight/Tissues=septum, liquid"),
                 ["'Body forces/weight/Tissues' has 'liquid', which is a liquid"]),
    "no tissue": (BAR, weight("0; 0; 0", "Body forces/weight/Tissues=bone"),
                  ["'Body forces/weight/Tissues' has 'bone', but this shape has no",
                   "Give some of 'bar'"]),
    "no number": (BAR, weight("1/(t - 0.5); 0; 0"),
                  ["'Body forces/weight/dead body force/Force'", "in all of these "
                   "tissues"]),
    "no type": (BAR, ["Body forces/Names=weight"],
                ["'Body forces/weight/Type' is not set", "'dead body force'"]),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(name, tmp_path):
    case, settings, words = REFUSED[name]
    result = run(case, tmp_path / "out", settings)
    assert result.exit_code == 1, result.log
    for part in words:
        assert part in result.said(), result.said()
    assert not list((tmp_path / "out").glob("*"))


def test_a_pulse_between_two_steps(tmp_path):
    """It is not stepped over."""
    result = run_well(BAR, tmp_path, [
        *BLOCK, *held(x_min="x, y, z"), "Geometry/block/Symmetry=",
        *weight("if(abs(t - 0.3) < 0.05, 0.02, 0); 0; 0")])
    assert "'Body forces/weight/dead body force/Force'" in result.log
    assert max(row["length"] for row in result.segments()) > 2.01
