# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps compute each point once, and lose nothing."""
import json
import math

import pandas as pd
import pytest
from lumbricus_run import SOURCE

import lumbricus
from lumbricus.sweeping import RunStore

PISTONS = SOURCE / "tests" / "physics" / "pistons.prm"
ONE_STEP = {"Time/First step": 1, "Time/Largest step": 1, "Output/Every": 0}
A = "Tissues/circular layer/Neo-Hooke/a"


@pytest.fixture(scope="module")
def case():
    return lumbricus.Case(PISTONS, ONE_STEP)


def times(folder):
    return {path.parent.name: path.stat().st_mtime_ns
            for path in folder.glob("*/run.json")}


def test_one_table_and_nothing_twice(case, tmp_path):
    table = lumbricus.sweep(case, {A: [0.1, 0.23]}, tmp_path, workers=2)
    assert list(table[A]) == [0.1, 0.23] and list(table["error"]) == ["", ""]
    assert table["fluid_pressure_1"][0] * 2.3 == pytest.approx(
        table["fluid_pressure_1"][1], rel=1e-8)
    assert pd.read_csv(tmp_path / "sweep.csv")["length"][0] == table["length"][0]
    before = times(tmp_path)
    # With one point more and one that fails.
    table = lumbricus.sweep(case, {A: [0.23, 0.3, -1, 0.1]}, tmp_path, workers=2)
    after = times(tmp_path)
    assert len(after) == 3 and before.items() <= after.items()
    assert "has to be" in table["error"][2] and math.isnan(table["length"][2])
    entries = json.loads((tmp_path / "manifest.json").read_text())
    assert sorted(entry["exit_code"] for entry in entries.values()) == [0, 0, 0, 1]
    # Another case is another run.
    lumbricus.sweep(case.changed({"Newton/Most iterations": 19}), {A: [0.1]}, tmp_path)
    assert len(times(tmp_path)) == 4


def test_interrupted_and_started_again(case, tmp_path):
    """What was done when it was interrupted is kept, and the rest is computed."""
    points = [{A: 0.1 * n} for n in range(1, 6)]
    store = RunStore(case, tmp_path, workers=1)

    def interrupt(done, of_all):
        if done == 2:
            raise KeyboardInterrupt
    with pytest.raises(KeyboardInterrupt):
        store.compute(points, progress=interrupt)
    done = [key for key, entry in store.manifest().items()
            if entry["state"] == "finished"]
    assert 2 <= len(done) < 5
    before = {key: time for key, time in times(tmp_path).items() if key in done}
    assert all(isinstance(run, lumbricus.Run)
               for run in RunStore(case, tmp_path).compute(points))
    assert before.items() <= times(tmp_path).items() and len(times(tmp_path)) == 5
