# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals, and an output that nobody reads any more, end a run with a
checkpoint. Ctrl-C without mpirun lost all since the last one, and so did
'| head -1' and a terminal that was closed; before the first step none was
noted. (SIGTERM and SIGUSR1 under mpirun: see test_restart.)"""
import fcntl
import os
import pathlib
import re
import signal
import subprocess
import time

import pytest
from faults import checkpoints, ranks_of
from loaded_program import QUICK_START
from lumbricus_run import SOURCE, restart

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
# So many steps, or one so long, that a signal comes in between.
STEPS = ["Time/First step=1e-3", "Time/Largest step=1e-3", "Output/Every=0"]
ONE_STEP = ["Mesh/Global refinements=3", "Time/First step=1",
            "Time/Largest step=1", "Output/Every=0"]


def start(folder, settings, options=(), mpirun=(), **keywords):
    command = [*mpirun, os.environ["LUMBRICUS"], BLOCK, "--output", folder,
               *options]
    for setting in settings:
        command += ["--set", setting]
    keywords.setdefault("stdout", subprocess.PIPE)
    # With all that Open MPI starts beside a program, as for users.
    environment = {name: value for name, value in os.environ.items()
                   if name not in QUICK_START}
    return subprocess.Popen(command, stderr=subprocess.PIPE, text=True,
                            start_new_session=True, env=environment, **keywords)


def wait_for(condition, process, timeout=60):
    end = time.time() + timeout
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.time() < end
        time.sleep(0.01)


def rows(folder):
    try:
        return (folder / "steps.csv").read_text().count("\n")
    except FileNotFoundError:
        return 0


def goes_on(folder):
    """The run that goes on has every step once, up to the end."""
    short = [f"Time/Largest step={size}" for size in ("0.5",)]
    run = restart(folder, short)
    assert run.exit_code == 0, run.message
    times = [row["t"] for row in run.segments()]
    assert times == sorted(set(times)) and times[-1] == 1.
    return run


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGHUP,
                                  signal.SIGTERM, signal.SIGUSR1])
def test_every_signal_leaves_a_checkpoint(sent, tmp_path):
    """As the terminal sends it: to the whole group, what Open MPI has started
    beside the program included."""
    process = start(tmp_path, STEPS)
    wait_for(lambda: rows(tmp_path) > 4, process)
    os.killpg(process.pid, sent)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 4, out + err
    assert f"Interrupted by {sent.name}" in err
    assert f"Go on with: lumbricus --restart '{tmp_path}'" in err
    assert f"Interrupted by {sent.name}" in (tmp_path / "log.txt").read_text()
    assert checkpoints(tmp_path) == [rows(tmp_path) - 2]
    assert not (tmp_path / "lumbricus.lock").exists()
    goes_on(tmp_path)


@pytest.mark.parametrize("mpirun", [(), ("mpirun", "-np", "2")])
def test_before_anything_was_done(mpirun, tmp_path):
    """While the mesh is made: what is there stays, and nothing is begun."""
    first = start(tmp_path, [])
    first.communicate(timeout=60)
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()
              if path.is_file()}
    process = start(tmp_path, ["Mesh/Global refinements=4"], mpirun=mpirun)
    wait_for((tmp_path / "lumbricus.lock").exists, process)
    for pid in ranks_of(process) if mpirun else [process.pid]:
        os.kill(pid, signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 4, out + err
    assert "Interrupted by SIGINT" in err
    assert "had not begun, and no file was changed. Start it again" in err
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()
            if path.is_file()} == before


def is_pending(process):
    """Whether a signal was sent to it that it has not been given yet."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return int(re.search(r"^ShdPnd:\s*(\w+)", status, re.MULTILINE)[1], 16) != 0


def test_in_the_first_step(tmp_path):
    """The state at rest is a checkpoint."""
    process = start(tmp_path, ONE_STEP)
    wait_for(lambda: rows(tmp_path) == 2, process)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 4, out + err
    assert checkpoints(tmp_path) == [0]
    run = restart(tmp_path)
    assert run.exit_code == 0, run.message
    assert "Going on from time 0, after step 0." in run.log
    assert [row["t"] for row in run.segments()] == [0., 1.]


def test_a_second_one_ends_at_once(tmp_path):
    """Sent while the process is stopped, so that no step can end in between."""
    process = start(tmp_path, ONE_STEP)
    wait_for(lambda: rows(tmp_path) == 2, process)
    process.send_signal(signal.SIGINT)
    # Or both would be handled when it goes on, as one. On a loaded machine that was
    # so although a while had passed in between.
    wait_for(lambda: not is_pending(process), process)
    process.send_signal(signal.SIGSTOP)
    time.sleep(1.2)
    process.send_signal(signal.SIGTERM)
    process.send_signal(signal.SIGCONT)
    process.communicate(timeout=60)
    assert process.returncode == -signal.SIGTERM


def test_two_at_the_same_moment_are_one(tmp_path):
    """A terminal that is closed, and batch systems, send several."""
    process = start(tmp_path, STEPS)
    wait_for(lambda: rows(tmp_path) > 3, process)
    for sent in (signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
        process.send_signal(sent)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 4, out + err
    assert len(checkpoints(tmp_path)) == 1


def test_nohup(tmp_path):
    """What is ignored from the start still is."""
    process = start(tmp_path, ["Time/First step=0.01",
                               "Time/Largest step=0.01", "Output/Every=0"],
                    preexec_fn=lambda: [
                        signal.signal(number, signal.SIG_IGN)
                        for number in (signal.SIGHUP, signal.SIGINT)])
    wait_for(lambda: rows(tmp_path) > 3, process)
    for _ in range(3):
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGINT)
        time.sleep(0.1)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0, out + err


def test_an_output_that_is_closed(tmp_path):
    """lumbricus case.prm | head -1"""
    process = start(tmp_path, STEPS)
    assert process.stdout.readline().startswith("lumbricus ")
    process.stdout.close()
    assert process.wait(timeout=60) == 4
    words = "Interrupted, because the standard output was closed"
    assert words in process.stderr.read()
    assert words in (tmp_path / "log.txt").read_text()
    assert len(checkpoints(tmp_path)) == 1
    goes_on(tmp_path)


def test_an_output_that_nobody_takes(tmp_path):
    """lumbricus case.prm | less, and no key is pressed; or Ctrl-S. The run
    waits for its reader, but ends where it is told to: it was stuck in the
    writing of a line, under mpirun after Ctrl-C too."""
    process = start(tmp_path, STEPS)
    fcntl.fcntl(process.stdout, fcntl.F_SETPIPE_SZ, 4096)

    def is_held_up():
        before = rows(tmp_path)
        time.sleep(0.5)
        return before > 4 and rows(tmp_path) == before
    wait_for(is_held_up, process)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=60) == 4
    assert "Interrupted by SIGTERM" in (tmp_path / "log.txt").read_text()
    assert checkpoints(tmp_path) == [rows(tmp_path) - 2]
    goes_on(tmp_path)


def test_an_output_that_is_full(tmp_path):
    """Nobody has closed it: log.txt has all of it."""
    with open("/dev/full", "w") as full:
        process = start(tmp_path, [], stdout=full)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    assert "Where the time went" in (tmp_path / "log.txt").read_text()


def test_what_is_asked_for_ends_with_its_reader():
    """lumbricus --parameters | head -1"""
    process = subprocess.Popen([os.environ["LUMBRICUS"], "--parameters"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    process.stdout.readline()
    process.stdout.close()
    assert process.wait(timeout=60) in (0, -signal.SIGPIPE)
    assert process.stderr.read() == ""


def test_ctrl_c_under_mpirun(tmp_path):
    """mpirun sends SIGTERM, and waits as long as the README says how to make it
    wait; without that the ranks are killed after a second."""
    mpirun = (os.environ.get("MPIRUN", "mpirun"), "--mca",
              "odls_base_sigkill_timeout", "3", "-np", "2")
    process = start(tmp_path, STEPS, mpirun=mpirun)
    wait_for(lambda: rows(tmp_path) > 4, process)
    os.killpg(process.pid, signal.SIGINT) # as a terminal does
    process.communicate(timeout=120)
    assert process.returncode != 0
    assert len(checkpoints(tmp_path)) == 1
    goes_on(tmp_path)
