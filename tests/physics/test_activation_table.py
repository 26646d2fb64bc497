# SPDX-License-Identifier: LGPL-2.1-or-later
"""A muscle whose active stretch is a table does what the formula does that the
table is of; steps end at its pulses and at its jumps, and a run goes on with it."""
import pathlib
import resource

import pytest
from lumbricus_run import go_on, run_well

CASE = pathlib.Path(__file__).parent / "twitch.prm"
WAVE = ["Muscles/fibres/Active stretch=wave"] + [
    f"Muscles/fibres/wave/{setting}" for setting in (
        "Amplitude=0.4", "Period=1", "Duty=0.5", "Ramp-in=0")]


def table(path, rows, **more):
    """The settings for a table with these rows."""
    path.write_text("t, all\n" + "".join(f"{t!r}, {d!r}\n" for t, d in rows))
    return ["Muscles/fibres/Active stretch=table",
            f"Muscles/fibres/table/File={path}"] + [
        f"Muscles/fibres/table/{key.replace('_', ' ')}={value}"
        for key, value in more.items()]


def same(run, other, tolerance):
    for row, expected in zip(run.table("points.csv"),
                             other.table("points.csv"), strict=True):
        assert row == pytest.approx(expected, abs=tolerance, nan_ok=True)


@pytest.mark.parametrize("between, ranks", [("linear", 1), ("linear", 2),
                                            ("cubic", 1)])
def test_a_sampled_wave_is_the_wave(tmp_path, between, ranks):
    """A free bar is as long as its active stretch says, so the run has the
    samples; one period of them is repeated."""
    wave = run_well(CASE, tmp_path / "wave", WAVE + ["Time/End=2"])
    rows = [(row["t"], 1 + row["ux"] / 2) for row in wave.table("points.csv")
            if row["t"] < 1 + 1e-9]
    assert len(rows) > 20 and min(d for _, d in rows) < 0.61
    settings = table(tmp_path / "wave.csv", rows, Repeat=1,
                     Between_rows=between)
    same(run_well(CASE, tmp_path / "table", settings + ["Time/End=2"], ranks),
         wave, 1e-9)


def test_a_table_in_each_of_its_ways(tmp_path):
    """Between the rows: a straight line, or the row before."""
    rows = [(0.0, 1.0), (1.0, 0.8), (3.0, 1.2), (4.0, 1.2)]
    linear = run_well(CASE, tmp_path / "linear", table(tmp_path / "a.csv", rows))
    for row in linear.table("points.csv"):
        t = row["t"]
        stretch = 1 - 0.2*t if t <= 1 else 0.8 + 0.2*(t - 1) if t <= 3 else 1.2
        assert row["ux"] == pytest.approx(2 * (stretch - 1), abs=1e-9)
    steps = run_well(CASE, tmp_path / "steps",
                     table(tmp_path / "b.csv", rows, Between_rows="steps"))
    for row in steps.table("points.csv"):
        t = row["t"]
        if min(abs(t - 1), abs(t - 3)) > 1e-6:
            stretch = 1 if t < 1 else 0.8 if t < 3 else 1.2
            assert row["ux"] == pytest.approx(2 * (stretch - 1), abs=1e-9)


@pytest.mark.parametrize("between", ["linear", "steps"])
def test_no_step_goes_past_a_pulse(tmp_path, between):
    """One row of a thousandth of a time unit, between steps of 0.05."""
    rows = [(0.0, 1.0), (0.477, 1.0), (0.478, 0.6), (0.479, 1.0), (1.0, 1.0)]
    result = run_well(CASE, tmp_path / "out", [
        *table(tmp_path / "pulse.csv", rows, Between_rows=between),
        "Time/End=1"])
    assert min(row["ux"] for row in result.table("points.csv")) == \
        pytest.approx(-0.8, abs=1e-9)
    assert "would miss a change of the active stretch" in result.log
    assert result.last()["t"] == pytest.approx(1)


def test_a_restart_goes_on_with_the_table(tmp_path):
    settings = table(tmp_path / "a.csv", [(0.0, 1.0), (0.3, 0.7), (1.0, 1.0)],
                     Repeat=1, Between_rows="cubic")
    whole = run_well(CASE, tmp_path / "whole", settings + ["Time/End=1.5"])
    run_well(CASE, tmp_path / "parts", settings + ["Time/End=0.75"])
    same(go_on(tmp_path / "parts", ["Time/End=1.5"]), whole, 1e-12)


def processor_seconds(start):
    """What a run takes, and the run."""
    def user():
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    before = user()
    run = start()
    return user() - before, run


def test_a_table_of_a_million_rows(tmp_path):
    """A day of one sample in a tenth of a second: read in seconds, each row once, and
    the muscle does what it says."""
    def stretch(t):
        return 1 - 0.2*t*t

    n = 10**6
    seconds, runs = zip(*(processor_seconds(lambda: run_well(
        CASE, tmp_path / f"out{rows}", [*table(
            tmp_path / f"{rows}.csv",
            ((i / rows, stretch(i / rows)) for i in range(rows + 1))), "Time/End=1"]))
        for rows in (2, n)))
    # 0.6 s where this was written.
    assert seconds[1] - seconds[0] < 10
    for row in runs[1].table("points.csv"):
        assert row["ux"] == pytest.approx(2 * (stretch(row["t"]) - 1), abs=1e-9)
