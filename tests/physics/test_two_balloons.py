# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two balloons of one pressure: they grow alike, until one takes it all. At a total
volume that is given they stayed alike, since nothing looked for the other branch."""
import math
import re
import sys

import numpy as np
import pytest
from lumbricus_run import SOURCE, go_on, run_well
from test_invariance import TO_THE_END, equal

CASE = SOURCE / "parameters" / "two_balloons"
sys.path.insert(0, str(CASE))

from balloons import make_balloons, write_msh  # noqa: E402
from two_spheres import limit, pressure  # noqa: E402

SETTINGS = [f"Geometry/mesh file/File={CASE / 'balloons.msh'}", "Output/Every=0",
            "Path/volume of a chamber/Relative volume=9", *TO_THE_END]
VOLUME = "Path/volume of a chamber/Relative volume"
FOLLOW = "Path/volume of a chamber/Follow branch"
TOGETHER = 12.219785  # [V_0] Where one begins to swell.


def volumes(result):
    """Of both, in times that at rest, and the pressure, in all steps."""
    rows = result.segments()
    one, other = (np.array([row["fluid_volume"] for row in rows
                            if row["segment"] == s]) for s in (1, 2))
    return (one / one[0], other / other[0],
            np.array([row["t"] for row in rows if row["segment"] == 1]))


@pytest.fixture(scope="module")
def balloons(tmp_path_factory):
    return run_well(CASE / "case.prm", tmp_path_factory.mktemp("two") / "run", SETTINGS)


def test_the_mesh_is_what_its_script_makes(tmp_path):
    write_msh(tmp_path / "balloons.msh", *make_balloons())
    assert (tmp_path / "balloons.msh").read_text() == (
        CASE / "balloons.msh").read_text()


def test_alike_until_one_swells(balloons):
    assert 2 * limit() == pytest.approx(TOGETHER, rel=1e-7)
    one, other, t = volumes(balloons)
    both, apart = one + other, np.abs(one - other)
    before = both < TOGETHER
    assert before.sum() > 15 and (~before).sum() > 3
    assert apart[before].max() < 1e-6 and apart[~before].min() > 1
    assert both[-1] == pytest.approx(18, rel=1e-9) and max(one[-1], other[-1]) > 14
    # One pressure, that of either volume.
    for volume in (one, other):
        assert t[1:] == pytest.approx(pressure(volume[1:]), rel=2e-3)
    # Where they part, by the log and by a parabola through the first steps on the branch.
    found = re.findall(r"another branch begins at the time ([0-9.]+)", balloons.log)
    assert [float(time) for time in found] == [pytest.approx(0.8164236, rel=1e-3)]
    part = np.polyfit(apart[~before][:3]**2, both[~before][:3], 2)[-1]
    assert part == pytest.approx(TOGETHER, rel=0.01)


def test_alike_for_ever_where_no_branch_is_followed(tmp_path):
    one, other, _ = volumes(run_well(CASE / "case.prm", tmp_path,
                                     [*SETTINGS, f"{FOLLOW}=0", f"{VOLUME}=7"]))
    assert one[-1] == pytest.approx(7, rel=1e-6)
    assert np.abs(one - other).max() < 1e-6


def test_two_ranks_and_a_restart(tmp_path, balloons):
    """Beside the fork what rounding leaves is multiplied."""
    n = 2 * 19  # rows before it
    run_well(CASE / "case.prm", tmp_path / "run",
             [*SETTINGS, f"{VOLUME}={math.exp(1.7)}"])
    whole = go_on(tmp_path / "run", [f"{VOLUME}=9"])
    assert whole.log.count("another branch") == 1
    two = run_well(CASE / "case.prm", tmp_path / "two",
                   [*SETTINGS, f"{VOLUME}={math.exp(2)}"], ranks=2)
    for again, tolerance in ((whole, 1e-12), (two, 1e-9)):
        rows = again.segments()
        assert len(rows) > n + 3
        equal(balloons.segments()[:n], rows[:n], tolerance)
        equal(balloons.segments()[n:len(rows)], rows[n:], 1e-9)
