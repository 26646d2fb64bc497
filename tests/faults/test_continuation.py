# SPDX-License-Identifier: LGPL-2.1-or-later
"""A continuation of the user's, in a library: it takes every step in two halves,
and the run comes to the same end, also when it goes on from a checkpoint, which
has the numbers of the continuation."""
import os

import pytest
from lumbricus_run import SOURCE, go_on, restart, run, run_well

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
HALVES = [f"Additional shared libraries={os.environ['HALVES']}",
          "Path/Control=in halves"]
SETTINGS = ["Time/First step=0.1", "Time/Largest step=0.25",
            "Checkpoints/Steps=1"]
# Every step is 1.25 times as long as the last one.
TIMES = [0.1, 0.225, 0.38125, 0.5765625, 0.820703125, 1]


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return run_well(BLOCK, tmp_path_factory.mktemp("whole"), HALVES + SETTINGS)


def times(result):
    return [row["t"] for row in result.steps()]


def check_same_end(result, expected):
    for name in ("t", "length", "wall_volume"):
        assert result.last()[name] == pytest.approx(expected.last()[name],
                                                    rel=1e-9), name


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_same_end(ranks, whole, tmp_path):
    by_time = run_well(BLOCK, tmp_path / "time", SETTINGS, ranks=ranks)
    assert times(by_time) != pytest.approx(TIMES)
    assert times(whole) == pytest.approx(TIMES, rel=1e-12)
    assert whole.log.count("two halves") == len(TIMES)
    assert whole.last()["length"] != pytest.approx(2, rel=1e-2)
    check_same_end(by_time, whole)


@pytest.mark.parametrize("before, after", [(1, 1), (1, 2), (2, 1)])
def test_it_goes_on(before, after, whole, tmp_path):
    # So long that it ends where the second step does.
    first = run_well(BLOCK, tmp_path, [*HALVES, *SETTINGS, "Time/End=0.225"],
                     ranks=before)
    assert times(first) == pytest.approx(TIMES[:2], rel=1e-12)
    result = go_on(tmp_path, ["Time/End=1"], ranks=after)
    assert times(result) == pytest.approx(TIMES, rel=1e-12)
    check_same_end(result, whole)


def test_another_control_at_a_restart(whole, tmp_path):
    """It begins anew, with a first step of its own."""
    run_well(BLOCK, tmp_path, [*HALVES, *SETTINGS, "Time/End=0.225"])
    result = go_on(tmp_path, ["Time/End=1", "Path/Control=time"])
    assert "by 'Path/Control' = 'time', which begins anew; so far it was " \
        "'in halves'." in result.log
    assert times(result)[2] == pytest.approx(0.325, rel=1e-12)
    check_same_end(result, whole)


def test_numbers_that_cannot_be(tmp_path):
    """They are seen before any file is changed, though only the library knows."""
    run_well(BLOCK, tmp_path, [*HALVES, *SETTINGS, "Time/End=0.1",
                               "Path/in halves/Growth=0"])
    log = (tmp_path / "log.txt").read_bytes()
    result = restart(tmp_path, ["Time/End=1"])
    assert result.exit_code == 1, result.log
    assert "numbers that 'Path/Control' = 'in halves' cannot go on with" in \
        result.said()
    assert (tmp_path / "log.txt").read_bytes() == log


def test_a_control_that_asks_no_controller(tmp_path):
    """Its muscles would stay at rest."""
    result = run(BLOCK, tmp_path, [*HALVES, "Muscles/biceps/Active stretch=server",
                                   "Muscles/biceps/server/Address=s"])
    assert result.exit_code == 1
    assert "'Path/Control' is 'in halves', which asks no controller, but the " \
        "muscle 'biceps' has one" in result.said()


def test_a_control_that_is_not_there(tmp_path):
    result = run(BLOCK, tmp_path, ["Path/Control=in halves"])
    assert result.exit_code == 1
    assert "'Path/Control' is 'in halves', but has to be" in result.said()
