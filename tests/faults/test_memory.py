# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory that ends was called a bug (std::bad_alloc, deal.II's posix_memalign,
MUMPS' codes -5, -7 and -13): exit code 3. It is a run that cannot go on: exit
code 2 wherever it happens, words that say so, and the last good state or
checkpoint left on disk."""
import os
import pathlib
import resource
import subprocess
import time

import pytest
from lumbricus_run import Run

BAR = pathlib.Path(__file__).resolve().parent.parent / "physics" / "bar.prm"
LARGE = ["Geometry/block/Cells=10, 10, 10", "Linear solver/Method=kept factor",
         "Time/First step=1", "Time/Largest step=1",
         "Boundary conditions/Names=push",
         "Boundary conditions/push/Boundary=x max",
         "Boundary conditions/push/Type=dead traction",
         "Boundary conditions/push/dead traction/Traction=-0.05*t; 0; 0"]


def start(folder, settings, ranks=1, megabytes=None):
    """Start a run whose ranks may have so many addresses each."""
    program = [os.environ["LUMBRICUS"], str(BAR), "--output", str(folder)]
    for setting in settings:
        program += ["--set", setting]
    if megabytes is not None:
        # mpirun and its daemon are not to have the limit.
        program = ["sh", "-c", f"ulimit -v {int(1024 * megabytes)}; "
                   'exec "$0" "$@"', *program]
    mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
    return subprocess.Popen((mpirun if ranks > 1 else []) + program,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True)


def finished(process, folder):
    out, err = process.communicate(timeout=300)
    return Run(subprocess.CompletedProcess(
        process.args, process.returncode, out, err), folder)


def most_addresses(folder, settings):
    """What a run has at its end [MB], by what the system says meanwhile."""
    process = start(folder, settings)
    status = pathlib.Path(f"/proc/{process.pid}/status")
    peak = 0
    while process.poll() is None:
        try:
            for line in status.read_text().splitlines():
                if line.startswith("VmPeak:"):
                    peak = max(peak, int(line.split()[1]) / 1024)
        except (OSError, ProcessLookupError):
            break
        time.sleep(0.005)
    assert finished(process, folder).exit_code == 0
    return peak


@pytest.fixture(scope="module")
def limits(tmp_path_factory):
    """From what the start takes to what the whole run does [MB]."""
    assert resource.getrlimit(resource.RLIMIT_AS)[0] == resource.RLIM_INFINITY
    folder = tmp_path_factory.mktemp("unlimited")
    least = most_addresses(folder / "small", LARGE + [
        "Geometry/block/Cells=2, 1, 1"])
    most = most_addresses(folder / "large", LARGE)
    assert most > least + 100
    return least, most


@pytest.mark.parametrize("ranks, part", [
    (1, 0.03), (1, 0.15), (1, 0.3), (1, 0.5), (1, 0.7), (1, 0.85), (2, 0.1),
    (2, 0.3), (2, 0.5)])
def test_memory_that_ends_is_said(tmp_path, limits, ranks, part):
    least, most = limits
    if ranks == 2:
        most = least + 0.6 * (most - least)
    result = finished(start(tmp_path, LARGE, ranks,
                            least + part * (most - least)), tmp_path)
    everything = result.log + result.message
    assert result.exit_code == 2, everything
    message = result.said()
    assert "lumbricus: Out of memory" in message, everything
    assert "'Mesh/Global refinements'" in message
    assert "bug" not in message
    if ranks == 2:
        assert "Out of memory on rank " in message
