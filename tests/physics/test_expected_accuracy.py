# SPDX-License-Identifier: LGPL-2.1-or-later
"""What errors --check says are to be expected, from those that earlier runs in the folder
of the results and beside it have estimated: within a factor of 2 what the run then
estimates; nothing where other parameters differ, or where what is there cannot be read."""
import json
import math
import pathlib
import re
import shutil

import pytest
from lumbricus_run import run, run_well

HERE = pathlib.Path(__file__).parent
SEGMENT = "Geometry/segment chain/"
NAMES = {"length": "length", "mid radius": "mid_radius",
         "fluid pressure": "fluid_pressure"}
COARSE = [f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment=2",
          f"{SEGMENT}Cells across the liquid=2", "Time/First step=0.1",
          "Time/Largest step=0.1", "Output/Errors=2"]


def sphere(cells):
    return [f"Geometry/hollow sphere/Cells around a quarter={cells}",
            f"Geometry/hollow sphere/Cells through the wall={cells}",
            "Cavities/Content=volume", "Output/Errors=4",
            "Cavities/volume/Relative volume=1 + 0.5*t",
            "Time/First step=0.25", "Time/Largest step=0.25"]


def said(folder, settings=(), case="segment"):
    """All that a check says of it, one line for each sentence."""
    before = sorted(folder.parent.rglob("*"))
    result = run(HERE / f"{case}.prm", folder, settings, options=["--check"])
    assert result.exit_code == 0, result.message
    assert "The input is valid; nothing was computed." in result.log
    assert sorted(folder.parent.rglob("*")) == before
    return result.log


def estimated(result):
    """The largest error of all segments and times, of the largest value, in percent."""
    rows = result.table("errors.csv")
    largest = {name: max(abs(row[column]) for row in rows if not math.isnan(row[column]))
               for name, column in NAMES.items()
               if not all(math.isnan(row[column]) for row in rows)}
    return {name: 100 * max(abs(row[f"{NAMES[name]}_error"]) for row in rows) / value
            for name, value in largest.items() if value > 0}


def expected(log):
    """From and to, of each number."""
    words = re.search(r"To be expected: (.*)\n", log).group(1)
    found = {}
    for name in NAMES:
        both = re.search(rf"{name} ([\d.e+-]+) to ([\d.e+-]+)%", words)
        one = re.search(rf"{name} about ([\d.e+-]+)%", words)
        if both or one:
            found[name] = tuple(map(float, both.groups() if both else
                                    2 * one.groups()))
    return found


@pytest.fixture(scope="module")
def coarse(tmp_path_factory):
    """A run of the closed segment, which all tests only look at or copy."""
    return run_well(HERE / "segment.prm",
                    tmp_path_factory.mktemp("runs") / "coarse", COARSE)


def test_same_mesh_and_finer_ones(coarse, tmp_path):
    assert "An earlier run" not in said(tmp_path / "alone", COARSE)
    log = said(coarse.folder, COARSE + ["Output/Every=3", "Title=Again"])
    assert f"An earlier run in '{coarse.folder}' on 909 unknowns" in log
    assert "This mesh is the same" in log
    numbers = re.search("at most length ([^%]*)%, mid radius ([^%]*)%, fluid pressure "
                        "([^%]*)%, middle x ", log).groups()
    for number, (name, error) in zip(numbers, estimated(coarse).items()):
        assert float(number) == pytest.approx(error, rel=0.06), name

    # A folder beside it, which is not there yet.
    finer = coarse.folder.parent / "finer"
    settings = COARSE + ["Mesh/Global refinements=1"]
    log = said(finer, settings)
    assert "cells 2 times smaller. To be expected:" in log
    ranges = expected(log)
    # The place of a segment has its own.
    assert NAMES.keys() <= ranges.keys()
    found = estimated(run_well(HERE / "segment.prm", tmp_path / "finer", settings))
    for name, (least, largest) in ranges.items():
        print(name, least, largest, found[name])
        assert least < largest < 0.52 * estimated(coarse)[name]
        assert least / 2 < found[name] < 2 * largest, name

    # Not hindered by what else is there.
    (finer.parent / "nowhere").symlink_to("away")
    (finer.parent / "file").touch()
    assert said(finer, settings) == log
    assert run(HERE / "segment.prm", f"{finer}/", settings,
               options=["--check"]).log == log

    # Half of the directions: perhaps no better than before.
    log = said(finer, COARSE[:1] + [f"{SEGMENT}Cells along a segment=4"] + COARSE[2:])
    assert "cells up to 2 times smaller, not in all directions" in log
    for name, (_, largest) in expected(log).items():
        assert largest == pytest.approx(estimated(coarse)[name], rel=0.06)
    log = said(finer, COARSE[:1] + [f"{SEGMENT}Cells along a segment=1"] + COARSE[2:])
    assert "cells up to 2 times larger, not in all directions" in log


def test_order_of_two_runs(tmp_path):
    """The pressure in a thick sphere."""
    for cells in (2, 4):
        run_well(HERE / "sphere.prm", tmp_path / f"cells-{cells}", sphere(cells))
    log = said(tmp_path / "cells-6", sphere(6), "sphere")
    assert f"An earlier run in '{tmp_path / 'cells-4'}'" in log
    assert f"as errors fell from '{tmp_path / 'cells-2'}' to there" in log
    order = float(re.search(r"\(order ([\d.]+)\)", log).group(1))
    assert 3 < order <= 4
    (value, _), = expected(log).values()
    found = estimated(run_well(HERE / "sphere.prm", tmp_path / "cells-6",
                               sphere(6)))
    print(order, value, found)
    assert 0.5 < value / found["fluid pressure"] < 2
    # Not where the way goes on in one direction only.
    settings = sphere(4) + ["Geometry/hollow sphere/Cells through the wall=6"]
    shutil.rmtree(tmp_path / "cells-6")
    assert "(order" not in said(tmp_path / "other", settings, "sphere")


def test_nothing_where_more_differs(coarse):
    settings = COARSE + ["Newton/Force tolerance=1e-7", "Mesh/Global refinements=1",
                         "Time/Largest step=0.2", "Mesh/Refine where=1 - x"]
    log = said(coarse.folder, settings)
    assert ("Nothing follows from that for this run, which differs in 'Mesh/Refine "
            "where', 'Newton/Force tolerance', 'Time/Largest step'.") in log
    assert "expected" not in log
    # Beside it there may be anything.
    assert "An earlier run" not in said(coarse.folder.parent / "other", settings)


def test_nothing_where_cells_are_not_what_parameters_say(coarse, tmp_path):
    """Of a mesh that has adapted itself, or has come from a file that has changed."""
    folder = tmp_path / "run"
    shutil.copytree(coarse.folder, folder)
    table = folder / "mesh.csv"
    table.write_text(table.read_text().replace(",909,", ",908,"))
    log = said(folder, COARSE)
    assert "how large its cells are beside those there is not known" in log
    head, row = (coarse.folder / "mesh.csv").read_text().splitlines()
    table.write_text("\n".join((head, row, row.replace(",909,", ",2000,"), "")))
    assert "To be expected" not in said(folder, COARSE + ["Mesh/Global refinements=1"])
    assert "This mesh is the same" in said(folder, COARSE)


@pytest.mark.parametrize("file, text", [
    ("run.json", ""), ("run.json", "{"), ("run.json", "[" * 100000),
    ("run.json", "[1, 2]"), ("run.json", '{"parameters": 3, "status": {"time": 1}}'),
    ("mesh.csv", "unknowns\n"), ("mesh.csv", "unknowns\n-1\n"), ("mesh.csv", "\0\n"),
    ("errors.csv", ""), ("errors.csv", "t,segment,length,length_error\n"),
    ("errors.csv", "t,segment,length,length_error\n0.2,1,1,nan\n"),
    ("errors.csv", "length,length_error\n1,2,3\n1e400,0.1\n1,0.1")])
def test_no_failure_where_it_cannot_be_read(coarse, tmp_path, file, text):
    folder = tmp_path / "run"
    shutil.copytree(coarse.folder, folder)
    (folder / file).write_text(text)
    assert "An earlier run" not in said(folder, COARSE)


def test_parameters_of_another_version(coarse, tmp_path):
    """One that the program no longer has; and numbers as another writer has them."""
    folder = tmp_path / "run"
    shutil.copytree(coarse.folder, folder)
    description = json.loads((folder / "run.json").read_text())
    entry = {"path": "Newton/Old", "value": 2, "default": 1, "unit": "", "meaning": ""}
    description["parameters"].append(entry)
    (folder / "run.json").write_text(json.dumps(description))
    assert "differs in 'Newton/Old'." in said(folder, COARSE)
