# SPDX-License-Identifier: LGPL-2.1-or-later
"""kill -9 of one rank or of all at random times, also while a checkpoint is
written: the run that goes on ends in the same numbers. One chamber has a liquid with
cells, which is reset, the other none and a leak, so that what is inside changes. The
skin presses against a burrow at first, and then slides along its mucus: where it is
anchored is what it remembers."""
import random
import time

import pytest
from faults import (CASE, checkpoints, differences, finish, fresh, kill_all,
                    kill_rank, ranks_of, start)

N_KILLS = 30
SETTINGS = ["Geometry/segment chain/Segments with their own measures=2",
            "Geometry/segment chain/Segment 2/Liquid=cavity",
            "Cavities/Leak=500",
            "Boundary conditions/Names=burrow",
            "Boundary conditions/burrow/Boundary=skin",
            "Boundary conditions/burrow/Type=contact",
            *(f"Boundary conditions/burrow/contact/{entry}" for entry in (
                "Obstacle=burrow", "burrow/Radius=2.3",
                "Shear strength=1e-4, 2e-4, 0", "Mucus thickness=10",
                "Elastic slip=0.01"))]


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    run = fresh(tmp_path_factory.mktemp("whole"), 2, SETTINGS)
    assert run.exit_code == 0, run.message
    volumes = [row["fluid_volume"] for row in run.segments()
               if row["segment"] == 2]
    assert volumes[-1] < 0.99 * volumes[0]
    # All of one segment slides from its third step on, and it gets ahead.
    contacts = [row.split(",") for row in
                (run.folder / "contact.csv").read_text().splitlines()]
    sliding, segment = (contacts[0].index(name) for name in ("sliding", "segment"))
    assert [float(row[sliding]) for row in contacts[1:]
            if row[segment] == "1"][3:] == [1] * 8
    assert run.table("body.csv")[-1]["stride"] > 0.1
    return run


def check_same(run, reference):
    for table in ("segments.csv", "body.csv"):
        assert differences(run, reference, table) < 1e-12, table


def kill_one(process):
    """One rank; mpirun ends the others."""
    pids = ranks_of(process)
    if pids:
        kill_rank(random.choice(pids))
    process.communicate(timeout=60)


def go_on(folder):
    """From the last checkpoint, or from the beginning."""
    return start(2, "--restart", folder) if checkpoints(folder) else \
        start(2, CASE, "--output", folder,
              *(part for setting in SETTINGS for part in ("--set", setting)))


def words_in(folder):
    """How long the log of a run is."""
    log = folder / "log.txt"
    return log.stat().st_size if log.exists() else 0


def test_random_kills(tmp_path, reference):
    random.seed(20)
    duration = reference.steps()[-1]["elapsed_seconds"]
    n_kills, n_runs = 0, 0
    folder = tmp_path / "0"
    before = 0
    process = go_on(folder)
    while n_kills < N_KILLS:
        # A fifth is killed as it starts; what a start takes depends on what runs
        # beside it.
        if random.random() < 0.2:
            time.sleep(random.random())
        else:
            while words_in(folder) == before and process.poll() is None:
                time.sleep(0.01)
            time.sleep(0.25 * duration * random.random())
        if process.poll() is None:
            random.choice((kill_one, kill_all))(process)
            n_kills += 1
        elif process.wait() == 0:
            # The run ended before it could be killed: compare, start another.
            check_same(finish(process, folder), reference)
            n_runs += 1
            folder = tmp_path / str(n_runs)
        before = words_in(folder)
        process = go_on(folder)
    run = finish(process, folder)
    assert run.exit_code == 0, run.message
    check_same(run, reference)
