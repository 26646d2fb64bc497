# SPDX-License-Identifier: LGPL-2.1-or-later
"""An arch snaps through: the path turns back where the load is highest, and on again
where it is lowest. In time it ended at the first of these."""
import re
import sys

import pytest
from lumbricus_run import SOURCE, run, run_well

ARCH = SOURCE / "parameters" / "snap_through"
sys.path.insert(0, str(ARCH))

from arch import make_arch, write_msh  # noqa: E402
from shallow_arch import PER_TIME, limits, path  # noqa: E402

SETTINGS = [f"Geometry/mesh file/File={ARCH / 'arch.msh'}", "Output/Every=0"]


def test_the_mesh_is_what_its_script_makes(tmp_path):
    write_msh(tmp_path / "arch.msh", *make_arch())
    assert (tmp_path / "arch.msh").read_text() == (ARCH / "arch.msh").read_text()


def test_both_limit_points_and_what_is_between(tmp_path):
    result = run_well(ARCH / "case.prm", tmp_path, SETTINGS)
    down, load = path()
    turns = re.findall(r"turns at the time ([0-9.]+), from where it goes (\w+)",
                       result.log)
    assert [way for _, way in turns] == ["back", "on"]
    for (time, _), wanted in zip(turns, limits(down, load), strict=True):
        assert PER_TIME * float(time) == pytest.approx(wanted, rel=5e-3)
    # To where it hangs, and never back along the way.
    points = result.table("points.csv")
    crown = [-row["uy"] for row in points]
    assert crown == sorted(crown) and crown[-1] > 0.9
    for row in points[1:]:
        k = abs(down + row["uy"]).argmin()
        assert PER_TIME * row["t"] == pytest.approx(load[k], rel=0.02), row["t"]


def test_in_time_it_ends_at_the_first(tmp_path):
    result = run(ARCH / "case.prm", tmp_path,
                 [*SETTINGS, "Path/Control=time", "Time/Smallest step=0.005"])
    assert result.exit_code == 2, result.log
    assert "a limit point" in result.said()
    assert result.table("points.csv")[-1]["t"] == pytest.approx(0.659, rel=0.01)
