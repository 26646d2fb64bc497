# SPDX-License-Identifier: LGPL-2.1-or-later
"""An active stretch that jumped from 1 to 0.5 ended with "take a smaller step", which
cannot help: however small, a step has the whole jump in it. A ramp to the same state
went well. A jump is now applied in parts at its time."""
import pathlib

import pytest
from lumbricus_run import go_on, run, run_well

CASE = pathlib.Path(__file__).parent / "switch.prm"
BAR = pathlib.Path(__file__).parent / "twitch.prm"
FORMULA = "Muscles/circular/expression/Formula"


def as_after(result, other, tolerance=2e-3):
    """The reset liquid's state hangs on the way by little: by the divergence
    that is left."""
    row, ramped = result.last(), other.last()
    assert row["t"] == ramped["t"]
    for name in ("length", "mid_radius", "fluid_pressure"):
        assert row[name] == pytest.approx(ramped[name], rel=tolerance), name
    assert row["fluid_volume"] == pytest.approx(ramped["fluid_volume"],
                                                rel=1e-12)


@pytest.fixture(scope="module")
def ramp(tmp_path_factory):
    return run_well(CASE, tmp_path_factory.mktemp("ramp"),
                    [FORMULA + "=1 - 0.5*t"])


@pytest.fixture(scope="module")
def jump(tmp_path_factory):
    return run_well(CASE, tmp_path_factory.mktemp("jump"))


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_jump_is_a_ramp(tmp_path, ramp, jump, ranks):
    result = jump if ranks == 1 else run_well(CASE, tmp_path, ranks=ranks)
    as_after(result, ramp)
    # Rows are at times only, one of them right before and one right after.
    times = [row["t"] for row in result.table("steps.csv")]
    assert times == pytest.approx([0, 0.1, 0.2, 0.3, 0.4, 0.5 - 1e-9, 0.5, 0.6,
                                   0.7, 0.8, 0.9, 1], abs=1e-12)
    before, after = result.segments()[5:7]
    assert before["length"] == pytest.approx(result.segments()[0]["length"])
    assert after["length"] == pytest.approx(result.last()["length"], rel=1e-3)
    assert "the active stretch of muscle 'circular' in segment 1 jumps between" \
        " the times 0.499999999 and 0.5, from 1 to 0.5; applied in" in result.log


def test_back_again(tmp_path):
    """A relaxation that jumps: the segment is as it was."""
    result = run_well(CASE, tmp_path, [
        FORMULA + "=t >= 0.25 && t < 0.55 ? 0.5 : 1"])
    assert result.last()["length"] == \
        pytest.approx(result.segments()[0]["length"], rel=2e-3)
    assert abs(result.last()["fluid_pressure"]) < 2e-3 * 0.061


def test_active_from_the_start_on(tmp_path, ramp):
    """A run starts at rest, whatever the muscles do at time 0."""
    result = run_well(CASE, tmp_path, [FORMULA + "=0.5"])
    as_after(result, ramp)
    assert "is there from the start on" in result.log
    assert abs(result.segments()[0]["fluid_pressure"]) < 1e-12


def test_within_less_than_the_smallest_step(tmp_path, ramp):
    result = run_well(CASE, tmp_path, [
        FORMULA + "=1 - 0.5*max(0, min(1, (t - 0.43)/1e-6))"])
    as_after(result, ramp)


def test_a_restart_before_a_jump(tmp_path, jump):
    run_well(CASE, tmp_path, ["Time/End=0.4"])
    parts = go_on(tmp_path, ["Time/End=1"])
    assert "jumps between the times" in parts.log
    for row, other in zip(parts.segments(), jump.segments(), strict=True):
        for name in ("t", "length", "mid_radius", "fluid_pressure"):
            assert row[name] == pytest.approx(other[name], rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_jump_that_leads_nowhere(tmp_path, ranks):
    """A bar of 2 mm is pressed by 2.1 mm at once. It is said what jumps, when, by
    how much, and how far it went."""
    section = "Boundary conditions/end"
    result = run(BAR, tmp_path, [
        "Muscles/fibres/Active stretch=expression", "Time/End=1",
        "Boundary conditions/Names=end", f"{section}/Boundary=x max",
        f"{section}/Type=displacement", f"{section}/displacement/Components=x",
        f"{section}/displacement/Displacement=t < 0.25 ? 0 : -2.1; 0; 0"], ranks)
    assert result.exit_code == 2, result.log + result.message
    message = result.said()
    for words in ("No solution beyond time 0.25: the displacement of "
                  f"'{section}' along x jumps between the times 0.249999999 and "
                  "0.25, from 0 to -2.1. Of this change", "can be applied, in "
                  "parts, but not another", "The last good state, at time 0.25"):
        assert words in message, message
    # The last good state is that from before the jump.
    last = result.table("points.csv")[-1]
    assert last["t"] == pytest.approx(0.25 - 1e-9, abs=1e-15)
    assert last["ux"] == pytest.approx(0, abs=1e-12)
