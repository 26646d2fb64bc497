# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulses shorter than a load step were stepped over: a muscle that twitches four
times for four fifths of a step did not move at all, with exit code 0 and without a
word. Steps now end at the peaks, of waves and of formulas, of muscles and of loads."""
import pathlib

import pytest
from lumbricus_run import go_on, run_well

CASE = pathlib.Path(__file__).parent / "twitch.prm"
BEATS = range(4)

# Once in every period, much shorter than a step of 0.05; the peak is 1.
PULSE = "exp(-((t - floor(t) - 0.475)/0.004)^2)"


WAVE = ["Muscles/fibres/Active stretch=wave"] + [
    f"Muscles/fibres/wave/{setting}" for setting in (
        "Amplitude=0.4", "Wavelength=10", "Period=1", "Duty=0.04", "Ramp-in=0")]


def formula(text):
    return ["Muscles/fibres/Active stretch=expression",
            f"Muscles/fibres/expression/Formula={text}"]


def load(kind, **parameters):
    """A muscle at rest, and a load or displacement at the end of the bar."""
    section = "Boundary conditions/end"
    return formula("1") + [
        "Boundary conditions/Names=end", f"{section}/Boundary=x max",
        f"{section}/Type={kind}"] + [
        f"{section}/{kind}/{key}={value}" for key, value in parameters.items()]


def at(rows, t, tolerance=1e-6):
    """The row of a time."""
    row = min(rows, key=lambda row: abs(row["t"] - t))
    assert abs(row["t"] - t) < tolerance, (t, row["t"])
    return row


@pytest.mark.parametrize("ranks", [1, 2])
def test_every_beat_of_a_wave(tmp_path, ranks):
    """A free bar is as long as its active stretch says: 2 (0.6 - 1) = -0.8."""
    result = run_well(CASE, tmp_path, WAVE, ranks)
    rows = result.table("points.csv")
    for beat in BEATS:
        assert at(rows, beat + 0.02, 1e-12)["ux"] == \
            pytest.approx(-0.8, abs=1e-9)
        for rests in (beat, beat + 0.04):
            assert at(rows, rests, 1e-12)["ux"] == pytest.approx(0, abs=1e-9)
    # Not many more steps than without the pulses, and it is said, once.
    assert len(rows) < 80 + 4 * 5
    assert result.log.count("would miss a change of the active stretch of "
                            "muscle 'fibres' in segment 1") == 1


def test_every_beat_of_a_formula(tmp_path):
    result = run_well(CASE, tmp_path, formula(f"1 - 0.4*{PULSE}"))
    rows = result.table("points.csv")
    for beat in BEATS:
        assert at(rows, beat + 0.475)["ux"] == pytest.approx(-0.8, abs=1e-9)
    assert len(rows) < 80 + 4 * 5


def test_every_beat_of_a_load(tmp_path):
    """The traction that pulls the bar to l times its length: a (l - 1/l^2)."""
    stretch = 1.2
    traction = stretch - stretch**-2
    result = run_well(CASE, tmp_path, load(
        "dead traction", Traction=f"{traction}*{PULSE}; 0; 0"))
    rows = result.table("points.csv")
    for beat in BEATS:
        assert at(rows, beat + 0.475)["ux"] == pytest.approx(0.4, abs=1e-8)


def test_every_beat_of_a_displacement(tmp_path):
    """What is not prescribed is not looked at."""
    result = run_well(CASE, tmp_path, load(
        "displacement", Components="x",
        Displacement=f"-0.3*{PULSE}; sin(1e3*t); 0"))
    rows = result.table("points.csv")
    for beat in BEATS:
        assert at(rows, beat + 0.475)["ux"] == pytest.approx(-0.3, abs=1e-9)
    assert len(rows) < 80 + 4 * 5


def test_what_may_be_missed_can_be_said(tmp_path):
    result = run_well(CASE, tmp_path, WAVE + ["Time/Largest miss=1"])
    assert len(result.table("points.csv")) == 81


def test_a_restart_between(tmp_path):
    whole = run_well(CASE, tmp_path / "whole", WAVE + ["Time/End=2"])
    run_well(CASE, tmp_path / "parts", WAVE + ["Time/End=1"])
    parts = go_on(tmp_path / "parts", ["Time/End=2"])
    for row, other in zip(parts.table("points.csv"),
                          whole.table("points.csv"), strict=True):
        assert row == pytest.approx(other, abs=1e-12, nan_ok=True)
