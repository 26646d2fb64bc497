# SPDX-License-Identifier: LGPL-2.1-or-later
"""Along a branch: a column that buckles. It stayed straight, however far beyond Euler's
load, and the log said that a real one would not."""
import math
import pathlib
import re

import pytest
from lumbricus_run import go_on, run_well
from test_invariance import TO_THE_END, equal

COLUMN = pathlib.Path(__file__).parent / "column.prm"
LENGTH = 10.0
FOLLOW = "Path/arc length/Follow branch"


def quarter_period(k):
    """The complete elliptic integral K(k), by the arithmetic-geometric mean."""
    a, b = 1.0, math.sqrt(1 - k * k)
    while a - b > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return math.pi / (a + b)


def elastica(load):
    """How far the end of a cantilever goes aside [mm] under this many times its load
    of buckling: (2 K/pi)^2 is that, and 2 k/K of its length the way."""
    low, high = 0.0, 0.999
    for _ in range(60):
        k = (low + high) / 2
        low, high = (k, high) if (2 * quarter_period(k) / math.pi) ** 2 < load \
            else (low, k)
    return LENGTH * 2 * k / quarter_period(k)


def aside(result):
    """Time and how far the end is aside, in steps on the branch."""
    return [(row["t"], abs(row["uy"])) for row in result.table("points.csv")
            if abs(row["uy"]) > 1e-3]


@pytest.fixture(scope="module")
def column(tmp_path_factory):
    return run_well(COLUMN, tmp_path_factory.mktemp("column") / "run", TO_THE_END)


def test_a_column_buckles_as_the_elastica(column):
    found = re.findall(r"another branch begins at the time ([0-9.]+) or so, in a "
                       r"motion that is largest in segment 1, column", column.log)
    assert [float(time) for time in found] == [pytest.approx(1, rel=0.01)]
    # Its load of buckling is Euler's but for its width and how it is held; the time
    # on the branch is least there.
    at = aside(column)
    load = min(t for t, _ in at)
    assert load == pytest.approx(1, rel=0.015)
    large = [(t, u) for t, u in at if u > 2]
    assert len(large) > 5 and large[-1][1] > 6
    for t, u in large:
        assert u == pytest.approx(elastica(t / load), rel=0.02), t
    assert large[-1][1] == pytest.approx(elastica(large[-1][0] / load), rel=2e-3)


def test_without_it_the_column_stays_straight(tmp_path):
    straight = run_well(COLUMN, tmp_path, [f"{FOLLOW}=0"])
    assert straight.last()["t"] == 1.25 and aside(straight) == []
    assert "branch" not in straight.log


def test_two_ranks(tmp_path, column):
    again = run_well(COLUMN, tmp_path / "run", TO_THE_END, ranks=2)
    assert [row for pair in aside(again) for row in pair] == pytest.approx(
        [row for pair in aside(column) for row in pair], rel=1e-9)


@pytest.mark.parametrize("length", [0.6, 2])
def test_a_restart_before_and_on_the_branch(tmp_path, column, length):
    run_well(COLUMN, tmp_path / "run",
             [*TO_THE_END, f"Path/arc length/Length={length}"])
    whole = go_on(tmp_path / "run", ["Path/arc length/Length=0"])
    assert whole.log.count("another branch") == (length < 1)
    equal(column.segments(), whole.segments(), 1e-12)


def test_the_second_branch_goes_the_other_way(tmp_path):
    """Of a column of 0.5 x 1 mm, to the side of the millimetre, where it is four times
    as stiff."""
    result = run_well(COLUMN, tmp_path, [*TO_THE_END, f"{FOLLOW}=2", "Time/End=5"])
    assert result.log.count("another branch") == 1
    on_it = [(row["t"], abs(row["uz"])) for row in result.table("points.csv")
             if abs(row["uz"]) > 1e-3]
    load = min(t for t, _ in on_it)
    assert load == pytest.approx(4, rel=0.015)
    large = [(t, u) for t, u in on_it if u > 2]
    assert len(large) > 5 and large[-1][1] > 6
    for t, u in large:
        assert u == pytest.approx(elastica(t / load), rel=0.02), t
    assert aside(result) == []
