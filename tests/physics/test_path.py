# SPDX-License-Identifier: LGPL-2.1-or-later
"""Along the path of equilibria, past a limit point. A balloon, under a pressure
that is given, ended there: beyond it no pressure that rises has an equilibrium."""
import math
import pathlib
import re

import pytest
import thick_sphere
from lumbricus_run import go_on, run, run_well
from test_invariance import TO_THE_END, equal

HERE = pathlib.Path(__file__).resolve().parent
SPHERE = HERE / "sphere.prm"
ALONG = ["Path/Control=arc length"]
# The pressure is the time.
BALLOON = [*ALONG, "Cavities/Content=pressure", "Cavities/pressure/Pressure=t",
           "Time/End=3", "Time/First step=0.05", "Time/Largest step=1"]
LENGTH = "Path/arc length/Length"
LIMIT = 0.8164236480, 6.10989264  # of the pressure, at this V/V_0


def pressure(volume):
    return thick_sphere.pressure(volume, 1, 1, 1)


def turns(result):
    """The times at which the log says that the path turns."""
    return [float(time) for time in
            re.findall(r"the path turns at the time ([0-9.]+)", result.log)]


@pytest.fixture(scope="module")
def balloon(tmp_path_factory):
    return run_well(SPHERE, tmp_path_factory.mktemp("path") / "run",
                    [*BALLOON, *TO_THE_END, f"{LENGTH}=9"])


def test_a_balloon_goes_past_its_limit_point(balloon):
    assert pressure(LIMIT[1]) == pytest.approx(LIMIT[0], rel=1e-8)
    assert turns(balloon) == [pytest.approx(LIMIT[0], rel=1e-5)]
    rows = balloon.segments()
    at_rest = rows[0]["fluid_volume"]
    volumes = [row["fluid_volume"] / at_rest for row in rows[1:]]
    assert volumes == sorted(volumes) and volumes[-1] > 27
    assert len([volume for volume in volumes if volume > LIMIT[1]]) > 3
    for row, volume in zip(rows[1:], volumes):
        assert row["t"] == pytest.approx(pressure(volume), rel=1e-4)
        assert row["fluid_pressure"] == pytest.approx(row["t"], rel=1e-9)


def test_it_takes_no_more_than_where_the_volume_is_given(tmp_path, balloon):
    volume = balloon.last()["fluid_volume"] / balloon.segments()[0]["fluid_volume"]
    given = run_well(SPHERE, tmp_path, [
        *TO_THE_END, "Cavities/Content=volume",
        f"Cavities/volume/Relative volume=exp({math.log(volume)}*t)",
        "Time/First step=0.01", "Time/Largest step=0.1"])
    along, over_time = balloon.costs(), given.costs()
    assert along["steps"] <= 1.5 * over_time["steps"]
    assert along["newton_iterations"] <= 1.5 * over_time["newton_iterations"]


def test_two_ranks(tmp_path, balloon):
    """The program with deal.II's assertions said that the volume of a cavity at rest,
    for its picture, was read where ghost entries were not known; this runs with them
    too."""
    again = run_well(SPHERE, tmp_path / "run",
                     [*BALLOON, *TO_THE_END, f"{LENGTH}=9"], ranks=2)
    equal(balloon.segments(), again.segments(), 1e-9)
    assert turns(again) == [pytest.approx(turns(balloon)[0], rel=1e-5)]


@pytest.mark.parametrize("length, is_behind", [(0.5, False), (2, False), (5, True)])
def test_a_restart_before_and_behind_it(tmp_path, balloon, length, is_behind):
    """Behind it no run went on: a past that was later was taken for damage."""
    first = run_well(SPHERE, tmp_path / "run",
                     [*BALLOON, *TO_THE_END, f"{LENGTH}={length}"])
    assert 1 < len(first.segments()) < len(balloon.segments()) - 2
    assert (len(turns(first)) > 0) == is_behind
    whole = go_on(tmp_path / "run", [f"{LENGTH}=9"])
    equal(balloon.segments(), whole.segments(), 1e-12)


@pytest.mark.parametrize("liquid", ["meshed", "cavity"])
def test_muscles_lead_where_they_do_in_time(tmp_path, liquid):
    """Their activation is among what depends on the load parameter; where nothing
    turns the end is that of steps in time."""
    settings = [f"Geometry/segment chain/Liquid={liquid}", *TO_THE_END]
    in_time = run_well(HERE / "segment.prm", tmp_path / "time", settings)
    along = run_well(HERE / "segment.prm", tmp_path / "path",
                     [*settings, *ALONG])
    assert turns(along) == []
    times = [row["t"] for row in along.segments()]
    assert times[-1] == 1 and len(set(times) - {0, 0.2, 1}) > 2
    for name, value in in_time.last().items():
        if name not in ("resets", "relaxed", "eta"):
            assert along.last()[name] == pytest.approx(
                value, rel=2e-6, nan_ok=True), name
    for row in along.steps():
        assert row["newton_iterations"] <= 8 * row["solves"]


def test_a_corner_is_gone_round_or_named(tmp_path):
    """Where the loads have a corner the path turns in no length at all."""
    corner = [*ALONG, "Muscles/fibres/Active stretch=expression",
              "Muscles/fibres/expression/Formula=1 - 0.2*abs(sin(t))",
              "Time/End=6", "Time/Largest step=0.3"]
    result = run(HERE / "twitch.prm", tmp_path / "named", corner)
    assert result.exit_code == 2, result.log
    for word in ["however short a step is", "'Path/arc length/Largest turn'"]:
        assert word in result.said(), result.message
    round_it = run_well(HERE / "twitch.prm", tmp_path / "round",
                        [*corner, "Path/arc length/Largest turn=90"])
    assert round_it.last()["t"] == 6


@pytest.mark.parametrize("case, settings, words", [
    ("chain.prm", ["Boundary conditions/Names=skin", "Boundary conditions/skin/"
                   "Boundary=skin", "Boundary conditions/skin/Type=drag",
                   "Boundary conditions/skin/drag/Along the surface=1e-3"],
     ["'Boundary conditions/skin' depends on how fast", "set 'time'"]),
    ("ground.prm", [], ["'Boundary conditions/top' prescribes displacements that "
                        "change", "Prescribe a load"]),
    ("ground.prm", ["Boundary conditions/Names=ground",
                    "Boundary conditions/ground/contact/Friction=0.3, 0.3, 0.3"],
     ["the skin slides with friction", "set 'time'"]),
    ("twitch.prm", ["Muscles/fibres/Action=active stress",
                    "Muscles/fibres/Activation=expression",
                    "Muscles/fibres/active stress/Force-velocity=Hill"],
     ["feels how fast it shortens", "'Force-velocity' to 'none'"]),
    ("sphere.prm", ["Cavities/Leak=1"], ["pores, leaks", "Close them"])])
def test_what_needs_a_time_that_goes_on_is_refused(tmp_path, case, settings, words):
    result = run(HERE / case, tmp_path / "out", [*settings, *ALONG])
    assert result.exit_code == 1, result.log + result.message
    for word in ["'Path/Control' is 'arc length'", *words]:
        assert word in result.said(), result.message
    assert not (tmp_path / "out" / "segments.csv").exists()


GROUND = ["Boundary conditions/top/Type=dead traction",
          "Boundary conditions/top/dead traction/Traction=0; 0; -0.1*t",
          "Time/First step=0.25", "Time/Largest step=0.25", *TO_THE_END]


def test_on_ground_without_friction_it_leads_where_it_does_in_time(tmp_path):
    """A block that is pressed on a plane; what it takes to have this height."""
    in_time = run_well(HERE / "ground.prm", tmp_path / "time", GROUND)
    along = run_well(HERE / "ground.prm", tmp_path / "path", [*GROUND, *ALONG])
    assert len({row["t"] for row in along.segments()}) > 3
    for name, value in in_time.last().items():
        assert along.last()[name] == pytest.approx(value, rel=1e-8, nan_ok=True), name
    long = in_time.last()["length"] / in_time.segments()[0]["length"]
    given = run_well(HERE / "ground.prm", tmp_path / "length", [
        *GROUND, "Path/Control=length of a segment", "Time/End=2",
        f"Path/length of a segment/Relative length={long!r}"])
    assert given.last()["t"] == pytest.approx(1, rel=1e-6)
