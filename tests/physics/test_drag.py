# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds up a surface in proportion to its speed: a block that is held by
nothing else, pushed at its lower face, along it and against it."""
import pathlib

import numpy as np
import pytest
from lumbricus_run import go_on, run_well
from test_contact_output import condition, reactions, table

HERE = pathlib.Path(__file__).parent
GROUND = HERE / "ground.prm"
RANKS = pytest.mark.parametrize("ranks", [1, 2])
ALONG, AGAINST, PUSH = 0.02, 0.05, 3e-3


def pushed(direction, a=230):
    """A unit cube in mud with its lower face, and pushed there."""
    return [f"Tissues/block/Neo-Hooke/a={a}", "Boundary conditions/Names=mud, push",
            *condition("mud", "drag", "z min", Along_the_surface=ALONG,
                       Against_the_surface=AGAINST),
            *condition("push", "dead traction", "z min", Traction=direction),
            "Time/First step=0.25", "Time/Largest step=0.25",
            "Output/Points=0.5, 0.5, 0"]


@RANKS
@pytest.mark.parametrize("direction, axis, drag", [
    (f"{PUSH}; 0; 0", 0, ALONG), (f"0; -{PUSH}; 0", 1, -ALONG),
    (f"0; 0; {PUSH}", 2, AGAINST)])
def test_goes_at_its_speed(tmp_path, ranks, direction, axis, drag):
    """The speed of the lower face is the force over drag and area."""
    run_well(GROUND, tmp_path, pushed(direction), ranks)
    for row in table(tmp_path, "points.csv"):
        assert row["u" + "xyz"[axis]] == pytest.approx(PUSH / drag * row["t"],
                                                       rel=1e-6)
    for (t, name), force in reactions(tmp_path).items():
        expected = np.zeros(3)
        expected[axis] = np.copysign(PUSH, drag)
        if name == "mud":
            assert force == pytest.approx(-expected, abs=1e-9)


def test_it_is_the_speed_that_counts(tmp_path):
    """Twice as long steps go twice as far, and a load that ends leaves the block
    where it is: no spring pulls it back."""
    ends = {}
    for size in (0.125, 0.25):
        run_well(GROUND, tmp_path / str(size), [
            *pushed(f"t < 0.501 ? {PUSH} : 0; 0; 0"), "Time/Largest miss=1",
            f"Time/First step={size}", f"Time/Largest step={size}"])
        for row in table(tmp_path / str(size), "points.csv"):
            ends[size, row["t"]] = row["ux"]
    for t in (0.5, 0.75, 1):
        assert ends[0.25, t] == pytest.approx(ends[0.125, t], rel=1e-6)
    assert ends[0.25, 1] == pytest.approx(ends[0.25, 0.5], rel=1e-6)


def test_restart(tmp_path):
    """What the surface remembers goes on, on another number of ranks too."""
    settings = pushed(f"{PUSH}*sin(3*t); 0; {PUSH}*t", a=0.23)
    run_well(GROUND, tmp_path / "whole", settings)
    run_well(GROUND, tmp_path / "cut", [*settings, "Time/End=0.5"])
    go_on(tmp_path / "cut", ["Time/End=1"], ranks=2)
    whole, cut = (table(tmp_path / name, "points.csv") for name in ("whole", "cut"))
    assert len(whole) == len(cut) == 5
    for one, other in zip(whole, cut):
        for name in ("ux", "uy", "uz"):
            assert other[name] == pytest.approx(one[name], rel=1e-9, abs=1e-10)
