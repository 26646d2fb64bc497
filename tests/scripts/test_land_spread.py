# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plot of Land's problems, of runs with a few cells: that it is drawn, and of
what."""
import importlib.util

import imageio
import pytest
from lumbricus_run import SOURCE, run_well

LAND = SOURCE / "parameters" / "land"
SHELL = [f"Geometry/truncated ellipsoid/Cells {which}" for which in
         ("around a quarter=2", "up to the base=3", "through the wall=1")]
COARSE = {"beam": ["Geometry/block/Cells=8, 1, 1"], "inflation": SHELL,
          "contraction": SHELL}


@pytest.fixture(scope="module")
def spread():
    spec = importlib.util.spec_from_file_location("spread", LAND / "spread.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("land")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(SOURCE)
        for name, settings in COARSE.items():
            run_well(LAND / f"{name}.prm", folder / name,
                     [*settings, "Output/Every=0"])
    return folder


def test_the_three_problems_are_drawn(runs, spread, capsys):
    assert spread.main([str(runs)]) == 0
    said = capsys.readouterr().out
    picture = imageio.v2.imread(runs / "spread.png")
    assert picture.shape[1] > 1000 and picture.std() > 10
    # Coarse, but the same problems.
    for problem in spread.PROBLEMS:
        found = spread.draw(runs)[problem.folder]
        assert found == pytest.approx(problem.independent, rel=0.06)
        assert f"{problem.folder}: {found:.4f} mm" in said


def test_lines_are_those_that_are_named(runs, spread):
    """Every point of a line is at rest where its title says."""
    for problem in spread.PROBLEMS:
        table = spread.read_table(runs / problem.folder / "points.csv")
        rest, deformed = spread.positions(table, problem.line, 1.)
        assert len(rest["x"]) == 11
        assert (rest["x"][1:] > rest["x"][:-1]).all()
        if problem.folder == "beam":
            assert rest["z"] == pytest.approx([0.5] * 11)
        else:
            assert (rest["x"] / 18.5)**2 + (rest["r"] / 8.5)**2 == \
                pytest.approx([1] * 11, abs=1e-4)
        # What is held stays.
        held = 0 if problem.folder == "beam" else -1
        for axis in "xyz":
            assert deformed[axis][held] == pytest.approx(rest[axis][held], abs=1e-6)


def test_runs_that_are_missing_are_named(tmp_path, spread, capsys):
    assert spread.main([str(tmp_path)]) == 1
    assert f"no run in '{tmp_path / 'beam'}'" in capsys.readouterr().err
