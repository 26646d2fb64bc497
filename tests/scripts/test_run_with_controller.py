# SPDX-License-Identifier: LGPL-2.1-or-later
"""run.sh of the cases with a controller, as users call it, in a folder with a copy of
the scripts, where nothing has to be installed or built: a short run beside its
controller, tables and plots; and no process is left where the run does not begin."""
import os
import pathlib
import shutil
import subprocess
import sys

import pytest
from lumbricus_run import SOURCE, Run

# After the script's own environment: what the tests have is there.
NOTHING_TO_DO = """
repository={repository}
python={python}
install_missing() {{ :; }}
set_up_python() {{ :; }}
build() {{ :; }}
"""
SHORT = ["Time/End=0.1", "Time/First step=0.05", "Time/Largest step=0.05",
         "Geometry/segment chain/Cells around a quarter=2"]


@pytest.fixture
def checkout(tmp_path):
    """A folder that looks like that of the project, as far as the scripts see."""
    folder = tmp_path / "checkout"
    for name in ("scripts", "python/src"):
        shutil.copytree(SOURCE / name, folder / name)
    with open(folder / "scripts" / "environment.sh", "a") as file:
        file.write(NOTHING_TO_DO.format(repository=folder, python=sys.executable))
    for name in ("oscillators", "reflex"):
        shutil.copytree(SOURCE / "parameters" / name, folder / "parameters" / name)
    program = folder / "build-Release" / "lumbricus"
    program.parent.mkdir()
    program.symlink_to(os.environ["LUMBRICUS"])
    (folder / "mpirun").symlink_to(shutil.which(os.environ["MPIRUN"]))
    # What 'env python3' in the plot's first line finds.
    (folder / "python3").write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    (folder / "python3").chmod(0o755)
    return folder


def call(checkout, name, settings):
    words = [word for setting in settings for word in ("--set", setting)]
    process = subprocess.run(
        [str(checkout / "parameters" / name / "run.sh"), *words], text=True,
        capture_output=True, timeout=300, stdin=subprocess.DEVNULL, env=dict(
            os.environ, PATH=f"{checkout}:{os.environ['PATH']}"))
    return Run(process, checkout / "results" / name)


def controllers(checkout):
    """The controllers of the copy that are still there."""
    found = []
    for file in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = file.read_bytes().decode(errors="replace").split("\0")
            if any(word.endswith("controller.py") for word in words) and \
                    file.parent.joinpath("cwd").resolve() == checkout.resolve():
                found.append(words)
        except OSError:
            pass
    return found


@pytest.mark.parametrize("name, segments", [("oscillators", 6), ("reflex", 6)])
def test_a_case_runs_beside_its_controller(checkout, name, segments):
    run = call(checkout, name, SHORT)
    assert run.exit_code == 0, run.log + run.message
    rows = run.segments()
    assert [row["t"] for row in rows[::segments]] == pytest.approx([0, 0.05, 0.1])
    assert "2 ranks" in run.log
    for plot in ("segments.png", "kymograph.png", "report.html"):
        assert (run.folder / plot).stat().st_size > 1000
    assert not (checkout / f"{name}.sock").exists()
    assert controllers(checkout) == []


def test_nothing_is_left_of_a_run_that_does_not_begin(checkout):
    """The controller of an earlier one was killed."""
    (checkout / "reflex.sock").touch()
    run = call(checkout, "reflex", ["Time/End=-1"])
    assert run.exit_code != 0
    assert "'Time/End'" in run.said()
    assert controllers(checkout) == []
    assert not (checkout / "reflex.sock").exists()
    assert call(checkout, "reflex", SHORT).exit_code == 0
