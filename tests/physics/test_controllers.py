# SPDX-License-Identifier: LGPL-2.1-or-later
"""Muscles that a running controller tells what to do: those that it tells what a
formula says do what the formula does, on any number of ranks and after a restart."""
import importlib.util
import math
import pathlib
import re

import pytest
from controlled_run import Controller, controlled, serving
from lumbricus_run import SOURCE, go_on, run_well
from test_active_stress import bar as active_bar
from test_active_stress import pulls
from test_energy import energy
from test_invariance import TO_THE_END, equal

HERE = pathlib.Path(__file__).parent
CHAIN = HERE / "chain.prm"
BAR = HERE / "twitch.prm"
FREE = HERE / "bar.prm"
MUSCLES = ["longitudinal", "circular"]
# Other steps than those that can be written down exactly.
STEPS = ["Time/First step=0.07", "Time/Largest step=0.07", "Time/End=0.21"]


class Formulas(Controller):
    """What chain.prm says, and what was asked."""

    def __init__(self):
        self.asked = []

    def step(self, t, dt, segments):
        self.asked.append((t, dt, segments))
        end = t + dt
        circular = []
        for s in (1, 2, 3):
            phase = (end - (s - 1) / 3) % 1 / 0.5
            pulse = (1 - math.cos(2 * math.pi * phase)) / 2 if phase < 1 else 0
            circular.append(1 - 0.1*pulse)
        return {"circular": circular,
                "longitudinal": [1 - 0.1*end*s/3 for s in (1, 2, 3)]}


class Bar(Controller):
    """One muscle that shortens by a fifth a time unit, with a limit for steps."""

    def __init__(self, largest_dt=None):
        self.asked = []
        self.largest_dt = largest_dt

    def step(self, t, dt, segments):
        self.asked.append((t, dt))
        answer = {"fibres": 1 - 0.2*(t + dt)}
        if self.largest_dt is not None:
            answer["largest_dt"] = self.largest_dt
        return answer


def steps(run):
    return [row["t"] for row in run.table("steps.csv")]


@pytest.fixture(scope="module")
def formulas(tmp_path_factory):
    return run_well(CHAIN, tmp_path_factory.mktemp("formulas"),
                    STEPS + TO_THE_END)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_controller_is_as_good_as_the_formula(tmp_path, formulas, ranks):
    controller = Formulas()
    with serving(controller) as address:
        run = run_well(CHAIN, tmp_path, [
            *controlled(MUSCLES, address), *STEPS, *TO_THE_END], ranks)
    assert steps(run) == steps(formulas)
    equal(run.segments(), formulas.segments(), 1e-9)
    # Asked once a step, and told what is in segments.csv at its beginning.
    assert [t for t, _, _ in controller.asked] == steps(run)[:-1]
    for t, dt, segments in controller.asked:
        assert dt == pytest.approx(0.07)
        rows = [row for row in run.segments() if row["t"] == t]
        for told, row in zip(segments, rows, strict=True):
            assert told.keys() == {"segment", "length", "radius", "pressure",
                                   "fluid_volume", "contact"}
            for name, column in (("segment", "segment"), ("length", "length"),
                                 ("radius", "mid_radius"),
                                 ("pressure", "fluid_pressure"),
                                 ("fluid_volume", "fluid_volume")):
                assert told[name] == pytest.approx(row[column], rel=1e-9,
                                                   abs=1e-12)
            assert told["contact"] == 0


def test_a_restart_asks_for_what_comes_only(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def asked(start):
        """The times that are asked for in a run, and the run."""
        controller = Formulas()
        with serving(controller, pathlib.Path("s")) as address:
            run = start(controlled(MUSCLES, address))
        return [t for t, _, _ in controller.asked], run

    def until(end, name):
        return asked(lambda settings: run_well(CHAIN, tmp_path / name, [
            *settings, *STEPS[:2], *TO_THE_END, "Checkpoints/Steps=2",
            "Output/Energy=true", f"Time/End={end}"]))

    times, whole = until(0.21, "whole")
    assert times == steps(whole)[:-1]
    until(0.14, "parts")
    times, parts = asked(lambda _: go_on(tmp_path / "parts", ["Time/End=0.21"]))
    assert times == steps(whole)[2:-1]
    equal(parts.segments(), whole.segments(), 1e-12)
    # The work of muscles in a step needs what they did before it.
    works = [energy(folder.folder, since=0.14) for folder in (parts, whole)]
    assert abs(works[0]["muscle", "longitudinal"]) > 1e-6
    assert works[0] == pytest.approx(works[1], rel=1e-10, abs=1e-14)


def test_a_restart_goes_on_with_steps_as_long_as_wanted(tmp_path):
    bar(tmp_path, Bar(0.02), ["Time/End=0.1"])
    controller = Bar(0.02)
    with serving(controller) as address:
        go_on(tmp_path, ["Time/End=0.2",
                         f"Muscles/fibres/server/Address={address}"])
    assert [dt for _, dt in controller.asked] == pytest.approx([0.02]*5)


class Pull(Controller):
    """The activation of one muscle, quicker and quicker."""

    def __init__(self):
        self.asked = []

    def step(self, t, dt, segments):
        self.asked.append(t)
        return {"m0": [(t + dt)**2]}


def test_an_active_stress_that_is_asked_for(tmp_path, monkeypatch):
    """As the formula, and through a restart to the last digits, with the speed that
    the fibres had before it."""
    monkeypatch.chdir(tmp_path)
    steps_of = ["Time/First step=0.1", "Time/Largest step=0.1", *TO_THE_END]
    hill = {"Force-length": "Blemker", "Force-velocity": "Hill", "Hill/Fastest": 2}

    def pulled(folder, end, start=None):
        """The run, and the times that were asked for in it."""
        controller = Pull()
        with serving(controller, pathlib.Path("s")) as address:
            settings = [s for s in active_bar(pulls("m0", 0.3, **hill))
                        if "expression" not in s]
            settings += controlled(["m0"], address, "Activation")
            run = start() if start else run_well(
                FREE, tmp_path / folder, [*settings, *steps_of, f"Time/End={end}"])
        return run, controller.asked

    formula = run_well(FREE, tmp_path / "formula", [
        *active_bar(pulls("m0", 0.3, activation="t^2", **hill)), *steps_of,
        "Time/End=0.6"])
    whole, times = pulled("whole", 0.6)
    equal(whole.segments(), formula.segments(), 1e-9)
    assert times == pytest.approx(steps(whole)[:-1])
    pulled("parts", 0.3)
    parts, times = pulled("parts", 0.6, lambda: go_on(
        tmp_path / "parts", ["Time/End=0.6"]))
    assert times == pytest.approx(steps(whole)[3:-1])
    equal(parts.segments(), whole.segments(), 1e-12)
    assert whole.last()["length"] < 0.95 * whole.segments()[0]["length"]


def bar(folder, controller, settings=()):
    with serving(controller) as address:
        return run_well(BAR, folder, [*controlled(["fibres"], address),
                                      "Time/End=0.2", *settings])


def test_one_number_is_for_all_segments(tmp_path):
    """A free bar is as long as its muscle says, at the end of each step."""
    run = bar(tmp_path, Bar())
    for row in run.table("points.csv"):
        assert row["ux"] == pytest.approx(-0.4*row["t"], abs=1e-9)


def test_a_controller_makes_steps_shorter(tmp_path):
    controller = Bar(0.02)
    run = bar(tmp_path, controller)
    assert steps(run) == pytest.approx([0.02*i for i in range(11)])
    # The first step is asked for again, the others are known to be so short.
    assert controller.asked[0] == (0, 0.05)
    assert [dt for _, dt in controller.asked[1:]] == pytest.approx([0.02]*10)


def test_a_step_that_is_cut_is_asked_for_again(tmp_path):
    """A muscle that shortens to a tenth at once: Newton's method wants shorter
    steps, each with a value of its own."""
    class Strong(Bar):
        def step(self, t, dt, segments):
            self.asked.append((t, dt))
            return {"fibres": 1 - 0.9*(t + dt)}

    controller = Strong()
    settings = ["Time/End=1", "Time/First step=1", "Time/Largest step=1",
                "Newton/Most iterations=4"]
    run = bar(tmp_path, controller, settings)
    assert sum(row["cuts"] for row in run.steps()) > 0
    assert len(controller.asked) == sum(1 + row["cuts"] for row in run.steps())
    for row in run.table("points.csv"):
        assert row["ux"] == pytest.approx(-1.8*row["t"], abs=1e-9)


def controllers_of(name):
    """What the controller.py of a case of the gallery has."""
    spec = importlib.util.spec_from_file_location(
        name, SOURCE / "parameters" / name / "controller.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def gallery(name, folder, controller, settings=()):
    case = SOURCE / "parameters" / name / "case.prm"
    muscles = re.findall("^  subsection (.+)\n    set Fibres", case.read_text(),
                         re.MULTILINE)
    with serving(controller) as address:
        return run_well(case, folder, [
            *(f"Muscles/{muscle}/server/Address={address}" for muscle in muscles),
            "Output/Every=0", *settings])


def lengths(run, t):
    return [row["length"] for row in run.segments() if abs(row["t"] - t) < 1e-9]


def test_oscillators(tmp_path):
    """The tables of its README."""
    controller = controllers_of("oscillators").Oscillators(6)
    run = gallery("oscillators", tmp_path, controller, ["Time/End=0.5"])
    assert lengths(run, 0.5) == pytest.approx(
        [2.128, 2.252, 2.266, 2.266, 2.252, 2.128], abs=1e-3)
    phases = controller.at(4)
    assert [math.degrees(a - b) for a, b in zip(phases, phases[1:])] == \
        pytest.approx([58.3, 57.1, 56.7, 57.1, 58.3], abs=0.1)


def test_reflex(tmp_path):
    pulled, held = (gallery("reflex", tmp_path / str(gain),
                            controllers_of("reflex").Reflex(2.1, gain))
                    for gain in (0, 0.6))
    assert sum(lengths(pulled, 2)) == pytest.approx(14.388, abs=1e-3)
    assert sum(lengths(held, 2)) == pytest.approx(13.887, abs=1e-3)
    assert lengths(held, 2) == pytest.approx(lengths(held, 1.9), abs=1e-4)
