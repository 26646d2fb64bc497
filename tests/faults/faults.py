# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short run with many checkpoints, and how to end it early."""
import contextlib
import os
import pathlib
import signal
import subprocess
import time

from lumbricus_run import Run, children_of, run

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE / "short.prm"


def command(ranks, *arguments):
    return [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks),
            os.environ["LUMBRICUS"], *map(str, arguments)]


def start(ranks, *arguments):
    """A run in a process group of its own, so that all of it can be killed."""
    return subprocess.Popen(command(ranks, *arguments), text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            start_new_session=True)


def finish(process, folder):
    """Wait for the end."""
    out, err = process.communicate(timeout=300)
    return Run(subprocess.CompletedProcess(process.args, process.returncode,
                                           out, err), folder)


def fresh(folder, ranks, settings=()):
    """Run the case from its beginning to its end."""
    return run(CASE, folder, settings, ranks)


def ranks_of(process):
    """The process ids of the program under mpirun."""
    return children_of(process.pid)


def kill_rank(pid):
    """kill -9, unless it has just ended by itself."""
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)


def kill_all(process):
    """mpirun first would leave the ranks writing for a while, into the folder
    from which a restart goes on."""
    for pid in ranks_of(process):
        kill_rank(pid)
    process.kill()
    process.communicate()


def checkpoints(folder):
    """The steps of the complete checkpoints, in order."""
    return sorted(int(path.parent.name) for path in
                  pathlib.Path(folder).glob("checkpoints/*/MANIFEST"))


def wait_for_step(folder, step, process=None, timeout=120):
    """Wait until the run has a checkpoint of this step or a later one."""
    end = time.time() + timeout
    while not checkpoints(folder) or checkpoints(folder)[-1] < step:
        assert time.time() < end, "no checkpoint"
        assert process is None or process.poll() is None, "the run has ended"
        time.sleep(0.01)


def differences(run, reference, table="segments.csv"):
    """The largest relative difference of two runs in all numbers of a table but
    eta, which is what is left of the shear."""
    rows, others = run.table(table), reference.table(table)
    assert len(rows) == len(others)
    scale = {name: max(abs(row[name]) for row in others) for name in others[0]}
    return max(abs(row[name] - other[name]) / scale[name]
               for row, other in zip(rows, others) for name in row
               if name != "eta" and scale[name] > 0)
