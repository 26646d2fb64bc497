# SPDX-License-Identifier: LGPL-2.1-or-later
"""The length of a segment or the volume of a chamber is given, and the loads are what
it takes. A length could only be found by trying, and a volume only be given where it was
all that the chamber knew."""
import math
import pathlib

import pytest
import thick_sphere
from lumbricus_run import go_on, run, run_well
from test_invariance import TO_THE_END, equal

HERE = pathlib.Path(__file__).resolve().parent
SPHERE = HERE / "sphere.prm"
LIMIT = 0.8164236480, 6.10989264  # of the sphere's pressure, at this V/V_0


def length(value, *more):
    section = "Path/length of a segment"
    return ["Path/Control=length of a segment", f"{section}/Relative length={value}",
            *(f"{section}/{setting}" for setting in more)]


def volume(value, *more):
    section = "Path/volume of a chamber"
    return ["Path/Control=volume of a chamber", f"{section}/Relative volume={value}",
            *(f"{section}/{setting}" for setting in more)]


def muscle(formula):
    return ["Muscles/fibres/Active stretch=expression",
            f"Muscles/fibres/expression/Formula={formula}"]


PRESSURE = ["Cavities/Content=pressure", "Cavities/pressure/Pressure=t",
            "Time/End=3", *TO_THE_END]
# e^3.25 in 13 steps.
BALLOON = [*PRESSURE, *volume(math.exp(3.25), "Step=0.25")]


@pytest.fixture(scope="module")
def balloon(tmp_path_factory):
    return run_well(SPHERE, tmp_path_factory.mktemp("balloon") / "run", BALLOON)


def test_a_balloon_at_volumes_that_are_given(tmp_path, balloon):
    rows = balloon.segments()
    at_rest = rows[0]["fluid_volume"]
    assert len(rows) == 14 and balloon.log.count("cut") == 0
    for i, row in enumerate(rows[1:], 1):
        assert row["fluid_volume"] / at_rest == pytest.approx(math.exp(0.25 * i),
                                                              rel=1e-9)
        assert row["fluid_pressure"] == pytest.approx(row["t"], rel=1e-12)
        assert row["t"] == pytest.approx(
            thick_sphere.pressure(row["fluid_volume"] / at_rest, 1, 1, 1), rel=1e-4)
    assert rows[-1]["fluid_volume"] / at_rest > 25
    assert balloon.log.count("the loads turn in this step, from where they go back") == 1
    top = run_well(SPHERE, tmp_path, [*PRESSURE, *volume(LIMIT[1], "Step=0.5")])
    assert top.last()["t"] == pytest.approx(LIMIT[0], rel=1e-5)


def test_two_ranks(tmp_path, balloon):
    equal(balloon.segments(),
          run_well(SPHERE, tmp_path, BALLOON, ranks=2).segments(), 1e-9)


@pytest.mark.parametrize("steps", [3, 9])
def test_a_restart_before_and_behind_the_limit(tmp_path, balloon, steps):
    """At another volume that is asked for: the run goes on to it."""
    run_well(SPHERE, tmp_path / "run",
             [*PRESSURE, *volume(math.exp(0.25 * steps), "Step=0.25")])
    whole = go_on(tmp_path / "run",
                  [f"Path/volume of a chamber/Relative volume={math.exp(3.25)}"])
    equal(balloon.segments(), whole.segments(), 1e-12)


def test_the_pressure_around_a_gas(tmp_path):
    """In a sphere with mu = 0.1 MPa it opens to a hoop stretch of 1.0941939033 inside
    where the pressure around it falls from 0.101325 to 0.05."""
    result = run_well(SPHERE, tmp_path, [
        *volume(1.0941939033**3), "Cavities/Content=gas",
        "Cavities/gas/Absolute pressure outside=0.101325*(1 - t)",
        "Tissues/wall/Neo-Hooke/a=0.1"])
    assert 0.101325 * (1 - result.last()["t"]) == pytest.approx(0.05, rel=1e-4)


@pytest.mark.parametrize("liquid", ["meshed", "cavity"])
def test_which_activation_gives_this_length(tmp_path, liquid):
    """That of a segment whose circular fibres shorten; it leads to the length again."""
    settings = [f"Geometry/segment chain/Liquid={liquid}", *TO_THE_END,
                "Reset/Tolerance=1e-9"]
    found = run_well(HERE / "segment.prm", tmp_path / "found",
                     [*settings, *length(1.04)])
    end = found.last()
    assert end["length"] == pytest.approx(1.04 * 3, rel=1e-9) and 0.1 < end["t"] < 1
    again = run_well(HERE / "segment.prm", tmp_path / "again",
                     [*settings, f"Time/End={end['t']!r}"])
    assert again.last()["length"] == pytest.approx(1.04 * 3, rel=1e-8)
    two = run_well(HERE / "segment.prm", tmp_path / "two", [*settings, *length(1.04)],
                   ranks=2)
    for row, other in zip(found.segments(), two.segments(), strict=True):
        assert row["t"] == pytest.approx(other["t"], rel=1e-9)
        assert row["length"] == pytest.approx(other["length"], rel=1e-9)


@pytest.mark.parametrize("formula, time", [
    ("1 - 0.2*sin(t)", math.asin(0.75)), ("1 - 0.05*t^2", math.sqrt(3))])
def test_a_muscle_alone(tmp_path, formula, time):
    """It is as long as its active stretch says, also where that begins with no slope."""
    result = run_well(HERE / "twitch.prm", tmp_path, [*muscle(formula), *length(0.85)])
    assert result.last()["t"] == pytest.approx(time, rel=1e-9)


def test_several_segments_together(tmp_path):
    result = run_well(HERE / "chain.prm", tmp_path,
                      [*length(0.97, "Segments=1, 3"), "Time/End=2",
                       "Muscles/circular/wave/Amplitude=0"])
    last = result.segments()[-3:]
    first = result.segments()[:3]
    assert sum(last[s]["length"] for s in (0, 2)) == pytest.approx(
        0.97 * sum(first[s]["length"] for s in (0, 2)), rel=1e-8)


@pytest.mark.parametrize("case, settings, steps, words", [
    ("segment.prm", length(1.3), 1,
     ["length of segment 1 is 1.05", "would need the loads of time 1.",
      "Raise 'Time/End', which is 1"]),
    ("segment.prm", length(0.9), 0,
     ["do the opposite", "the other side of 1"]),
    ("twitch.prm", [*muscle("1 - 0.2*sin(t)"), *length(0.7)], 5,
     ["does not get beyond 0.80", "'Path/length of a segment/Smallest step' = 0.0001",
      "choose a value that is nearer", "set 'Path/Control' to 'arc length'"]),
    ("twitch.prm", [*muscle("1"), *length(0.9)], 0,
     ["does not get beyond 1 of that at rest", "no loads of this kind"])])
def test_what_cannot_be_reached(tmp_path, case, settings, steps, words):
    result = run(HERE / case, tmp_path / "out", settings)
    assert result.exit_code == 2, result.log + result.message
    for word in [*words, "The last good state"]:
        assert word in result.said(), result.message
    assert len(result.segments()) >= 1 + steps


@pytest.mark.parametrize("case, settings, words", [
    ("sphere.prm", length(1.1), ["segment 1, which has no two plane sections"]),
    ("sphere.prm", volume(1.1), ["whose content sets the volume", "'gas'"]),
    ("segment.prm", volume(1.1), ["segment 1, which has no chamber without cells"]),
    ("segment.prm", length(1.1, "Segments=2"), ["'Segment 2' is not within"]),
    ("segment.prm", length(1.1, "Segments="), ["'Path/length of a segment/Segments' "
                                              "is empty"]),
    ("segment.prm", length(1.1, "Smallest step=1"),
     ["'Path/length of a segment/Smallest step' is 1, more than 'Step'"]),
    ("pistons.prm", length(1.1), ["'Path/Control' is 'length of a segment'",
                                  "'Boundary conditions/rear' prescribes"]),
    ("sphere.prm", [*volume(1.1), "Cavities/Leak=1"], ["pores, leaks"])])
def test_what_cannot_be_given_is_refused(tmp_path, case, settings, words):
    result = run(HERE / case, tmp_path / "out", settings)
    assert result.exit_code == 1, result.log + result.message
    for word in words:
        assert word in result.said(), result.message
    assert not (tmp_path / "out" / "segments.csv").exists()
