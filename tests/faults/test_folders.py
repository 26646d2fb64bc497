# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whose folder it is, and whose files are in it.

A second run in a folder left what the first had and it had not: points.csv,
pictures, checkpoints. Killed before its first checkpoint it went on, at a
restart, with the state of the first. Two at once wrote into the same tables.
What users had put there was overwritten, or removed with old checkpoints."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

import pytest
from faults import checkpoints, kill_all, start
from lumbricus_run import SOURCE, Run, call, run

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
EVERY_STEP = ["Checkpoints/Steps=1", "Checkpoints/Minutes=0"]
# So many that a run can be met on its way.
LONG = ["Time/First step=1e-4", "Time/Largest step=1e-4", "Output/Every=0"]
TENTHS = ["Time/First step=0.1", "Time/Largest step=0.1"]


def block(folder, settings=(), ranks=1):
    return run(BLOCK, folder, settings, ranks)


def restart(folder, settings=(), cwd=None):
    arguments = ["--restart", folder]
    for setting in settings:
        arguments += ["--set", setting]
    return Run(call(*arguments, folder=cwd), folder)


def tree(folder):
    """What every file is, of links where they lead to."""
    return {str(path.relative_to(folder)):
            os.readlink(path) if path.is_symlink() else path.read_bytes()
            for path in sorted(
                pathlib.Path(base) / name
                for base, folders, files in os.walk(folder, followlinks=True)
                for name in [*folders, *files])
            if path.is_symlink() or path.is_file()}


def wait_for(condition, process, timeout=60):
    end = time.time() + timeout
    while not condition():
        assert process.poll() is None, process.communicate()
        assert time.time() < end
        time.sleep(0.01)


def read(path):
    """What is in a file that may not be there yet."""
    try:
        return path.read_text()
    except FileNotFoundError:
        return ""


def start_long(folder, settings=(), ranks=1):
    """A run that has begun to write its tables."""
    arguments, before = [], read(folder / "lumbricus.run")
    for setting in [*LONG, *settings]:
        arguments += ["--set", setting]
    process = start(ranks, BLOCK, "--output", folder, *arguments) \
        if ranks > 1 else subprocess.Popen(
            [os.environ["LUMBRICUS"], BLOCK, "--output", folder, *arguments],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    wait_for(lambda: "elapsed" in read(folder / "steps.csv") and
             read(folder / "steps.csv").count("\n") > 2 and
             read(folder / "lumbricus.run") != before, process)
    return process


def test_a_second_run_leaves_nothing_of_the_first(tmp_path):
    folder = tmp_path / "run"
    first = block(folder, [*EVERY_STEP, *TENTHS, "Output/Points=2, 0, 0"])
    assert first.exit_code == 0, first.message
    assert len(checkpoints(folder)) == 2
    second = block(folder, ["Tissues/flesh/Neo-Hooke/a=5",
                            "Checkpoints/Minutes=0"])
    alone = block(tmp_path / "alone", ["Tissues/flesh/Neo-Hooke/a=5",
                                       "Checkpoints/Minutes=0"])
    assert second.exit_code == alone.exit_code == 0, second.message
    assert set(tree(folder)) == set(tree(tmp_path / "alone"))
    assert (folder / "segments.csv").read_text() == \
        (tmp_path / "alone" / "segments.csv").read_text()
    assert not (folder / "checkpoints").exists()
    assert not (folder / "lumbricus.lock").exists()


USERS = ["notes.txt", "segments.csv.bak", "vtu/solution_00000.0.vtu.keep",
         "vtu/solution_0.0.vtu", "vtu/mine.vtu", "checkpoints/000001.keep",
         "checkpoints/notes", "checkpoints/zz_copy/MANIFEST",
         "checkpoints/000001/notes", "checkpoints/000077/mesh", ".hidden"]


@pytest.mark.parametrize("elsewhere", [False, True])
def test_files_of_the_user_stay(tmp_path, elsewhere):
    """All but the last two checkpoints were removed with everything that was
    in their folder; a copy of one was taken for the newest. The folder may be
    a link to another disk."""
    folder = tmp_path / "run"
    if elsewhere:
        folder.mkdir()
        (tmp_path / "disk").mkdir()
        (folder / "checkpoints").symlink_to(tmp_path / "disk")
    settings = [*EVERY_STEP, *TENTHS]
    assert block(folder, [*settings, "Time/End=0.1"]).exit_code == 0
    assert checkpoints(folder) == [1]
    shutil.copytree(folder / "checkpoints/000001",
                    folder / "checkpoints/000099")
    for name in USERS:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(f"mine: {name}")
    before = tree(folder)
    users = [*USERS, *(name for name in before if "000099" in name)]
    for again in range(3):
        # Longer, then from the beginning, then longer again.
        result = block(folder, [*settings, "Time/End=0.5"]) if again == 1 \
            else restart(folder, [f"Time/End={0.3 + 0.4 * again}"])
        assert result.exit_code == 0, result.message
        assert "no checkpoint" not in result.log
        after = tree(folder)
        assert {name: after.get(name) for name in users} == \
            {name: before[name] for name in users}
        assert result.last()["t"] == pytest.approx((0.3, 0.5, 1.1)[again])
    assert (folder / "checkpoints").is_symlink() == elsewhere


# The first of these was overwritten by '-o .', see parameters.prm.
@pytest.mark.parametrize("name, ranks", [
    ("parameters.prm", 1), ("parameters.prm", 2), ("segments.csv", 1),
    ("newton.csv", 2), ("log.txt", 1), ("run.json", 1), ("solution.pvd", 1),
    ("points.csv", 1), ("obstacles.pvd", 2), ("vtu/obstacles_00007.vtu", 1),
    ("vtu/solution_00007.3.vtu", 1), ("vtu/solution_00007.pvtu", 2),
    ("vtu", 1), ("steps.csv.incomplete", 1), ("lumbricus.run", 1),
    ("lumbricus.lock", 1), ("link to log.txt", 1), ("link to nothing", 1)])
def test_files_of_the_user_are_not_overwritten(name, ranks, tmp_path):
    folder = tmp_path / "folder"
    folder.mkdir()
    (tmp_path / "other").write_text("not to be changed\n")
    if name == "link to log.txt":
        name = "log.txt"
        (folder / name).symlink_to(tmp_path / "other")
    elif name == "link to nothing":
        name = "mesh.csv"
        (folder / name).symlink_to(tmp_path / "nothing")
    else:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("set End = 1\n")
    before = tree(tmp_path)
    result = block(folder, ["Output/Points=0, 0, 0"], ranks)
    assert result.exit_code == 1, result.log
    assert f"'{folder}/{name}' " in result.said()
    assert "--output" in result.said()
    assert tree(tmp_path) == before


def test_output_beside_the_own_parameters(tmp_path):
    """-o . beside one's own parameters.prm wrote all defaults over it."""
    own = tmp_path / "parameters.prm"
    own.write_text("# My study\n" + BLOCK.read_text())
    result = call("parameters.prm", "-o", ".", folder=tmp_path)
    assert result.returncode == 1
    assert "'./parameters.prm' is not as a run of lumbricus has left it" in \
        " ".join(result.stderr.split())
    assert own.read_text().startswith("# My study\n")
    assert list(tmp_path.iterdir()) == [own]


def test_parameters_that_were_changed_by_hand(tmp_path):
    """A run that goes on would have overwritten them without a word, and without
    taking them."""
    assert block(tmp_path, EVERY_STEP).exit_code == 0
    path = tmp_path / "parameters.prm"
    # As the run has left it, it can be the input.
    again = Run(call(path, "--output", tmp_path), tmp_path)
    assert again.exit_code == 0, again.message
    with open(path, "a") as file:
        file.write("# a = 5?\n")
    before = tree(tmp_path)
    for result in (Run(call(path, "--output", tmp_path), tmp_path),
                   restart(tmp_path, ["Time/End=2"])):
        assert result.exit_code == 1
        assert f"'{path}' is not as a run of lumbricus has left it" in \
            result.said()
        assert "--set changes them" in result.said()
        assert tree(tmp_path) == before


@pytest.mark.parametrize("settings", [
    ["Time/End=-1"], ["Geometry/Shape=banana"], ["Output/Points=9, 9, 9"],
    ["Muscles/biceps/expression/Formula=1/0"]])
def test_wrong_input_leaves_the_results_there_are(settings, tmp_path):
    assert block(tmp_path, EVERY_STEP).exit_code == 0
    before = tree(tmp_path)
    assert block(tmp_path, settings).exit_code == 1
    assert tree(tmp_path) == before


@pytest.mark.parametrize("ranks", [1, 2])
def test_killed_before_its_first_checkpoint(tmp_path, ranks):
    """--restart went on with the state of the run before, and its tables went
    on in the middle of a row."""
    folder = tmp_path / "run"
    assert block(folder, EVERY_STEP).exit_code == 0
    shutil.copytree(folder, tmp_path / "backup")
    process = start_long(folder, ["Tissues/flesh/Neo-Hooke/a=5"], ranks)
    if ranks == 1:
        process.kill()
        process.communicate()
    else:
        kill_all(process)
    before = tree(folder)
    result = restart(folder)
    assert result.exit_code == 1
    assert "has no checkpoint to go on from" in result.said()
    assert tree(folder) == before

    # Nor with checkpoints of the other run that somebody brings back.
    shutil.copytree(tmp_path / "backup/checkpoints", folder / "checkpoints")
    with open(folder / "lumbricus.run", "a") as record:
        record.write("checkpoint 000001\ncheckpoint 000002\n")
    result = restart(folder)
    assert result.exit_code == 1
    assert "of another run" in result.said()


@pytest.mark.parametrize("ranks", [1, 2])
def test_two_at_once(tmp_path, ranks):
    """They wrote into the same tables."""
    process = start_long(tmp_path, ["Checkpoints/Steps=5"], ranks)
    wait_for(lambda: checkpoints(tmp_path), process)
    lock = dict(line.split(" ", 1) for line in
                (tmp_path / "lumbricus.lock").read_text().splitlines())
    assert lock["host"] == socket.gethostname()
    for result in (block(tmp_path), block(tmp_path, ranks=2),
                   restart(tmp_path, ["Time/End=2"])):
        assert result.exit_code == 1
        assert f"'{tmp_path}' is in use: process {lock['process']} on " \
            f"'{lock['host']}', since {lock['since']}, writes there." in \
            result.said()
    assert process.poll() is None
    process.send_signal(signal.SIGUSR1)
    process.communicate(timeout=60)
    assert process.returncode == 4
    assert not (tmp_path / "lumbricus.lock").exists()
    run = Run(subprocess.CompletedProcess([], 4, "", ""), tmp_path)
    times = [row["t"] for row in run.segments()]
    assert times == sorted(set(times)) and len(times) > 5


def test_many_start_at_the_same_moment(tmp_path):
    """Of which one gets the folder."""
    arguments = [os.environ["LUMBRICUS"], BLOCK, "--output", tmp_path]
    for setting in LONG:
        arguments += ["--set", setting]
    processes = [subprocess.Popen(arguments, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE) for _ in range(6)]
    refused = []
    end = time.time() + 60
    while len(refused) < 5 and time.time() < end:
        refused = [process for process in processes
                   if process.poll() is not None]
        time.sleep(0.05)
    for process in processes:
        process.terminate()
        process.communicate(timeout=60)
    assert sorted(process.returncode for process in processes) == \
        [1, 1, 1, 1, 1, 4]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_lock_that_was_left(tmp_path, ranks):
    """kill -9 leaves the file, and the folder is free."""
    process = start_long(tmp_path, ranks=ranks)
    if ranks == 1:
        process.kill()
        process.communicate()
    else:
        kill_all(process)
    assert (tmp_path / "lumbricus.lock").exists()
    result = block(tmp_path, EVERY_STEP)
    assert result.exit_code == 0, result.message
    assert not (tmp_path / "lumbricus.lock").exists()


@pytest.mark.parametrize("settings, code", [
    (["Time/End=-1"], 1), (["Time/Smallest step=0.4", "Time/First step=0.5",
                            "Newton/Most iterations=1"], 2)])
def test_the_lock_goes_with_a_run_that_fails(settings, code, tmp_path):
    assert block(tmp_path, settings).exit_code == code
    assert not (tmp_path / "lumbricus.lock").exists()


def test_a_record_that_was_made_up(tmp_path):
    """The record says what may be removed: none of its names may lead out of
    the folder."""
    folder = tmp_path / "run"
    assert block(folder).exit_code == 0
    (tmp_path / "thesis.txt").write_text("years of work")
    record = (folder / "lumbricus.run").read_text()
    for line in ("file ../thesis.txt", "file /etc/hostname", "file a/../../x",
                 "file vtu/../../thesis.txt", "checkpoint ../..", "file ",
                 "file .", "run ", "thing 1", "parameters -1 1",
                 "file x/y/z"):
        (folder / "lumbricus.run").write_text(f"{record}{line}\n")
        before = tree(tmp_path)
        result = restart(folder) if ".." in line else block(folder)
        assert result.exit_code == 1
        assert "lumbricus.run' has the line" in result.said()
        assert tree(tmp_path) == before
    # The last line was not written whole when the run was killed.
    (folder / "lumbricus.run").write_text(f"{record}file vtu/sol")
    assert block(folder).exit_code == 0


def test_an_end_that_is_past(tmp_path):
    """parameters.prm was written anew, with an end the run does not have."""
    assert block(tmp_path, EVERY_STEP).exit_code == 0
    before = tree(tmp_path)
    result = restart(tmp_path)
    assert result.exit_code == 0
    assert "has come to its end, time 1. No file was changed." in result.log
    assert tree(tmp_path) == before
    result = restart(tmp_path, ["Time/End=0.5"])
    assert result.exit_code == 1
    assert "'Time/End' is 0.5, but the run that is to go on has come to time " \
        "1 already. Give a later end" in result.said()
    assert tree(tmp_path) == before


def test_check_of_a_restart_changes_nothing(tmp_path):
    assert block(tmp_path, EVERY_STEP).exit_code == 0
    before = tree(tmp_path)
    result = call("--restart", tmp_path, "--set", "Time/End=2", "--check")
    assert result.returncode == 0, result.stderr
    assert "The input is valid" in result.stdout
    assert tree(tmp_path) == before


def test_pictures_of_a_time_that_is_computed_again(tmp_path):
    """A restart from an earlier checkpoint, with fewer ranks and a shorter end,
    leaves no picture of what the run had been to."""
    settings = ["Checkpoints/Steps=2", *TENTHS]
    process = start(2, BLOCK, "--output", tmp_path,
                    *(word for setting in settings
                      for word in ("--set", setting)))
    process.communicate(timeout=60)
    assert process.returncode == 0
    shutil.rmtree(tmp_path / "checkpoints" / "000010")
    assert checkpoints(tmp_path) == [8]
    result = restart(tmp_path, ["Time/End=0.9"])
    assert result.exit_code == 0, result.message
    named = (tmp_path / "solution.pvd").read_text().count("DataSet")
    assert named == 10
    assert len(list((tmp_path / "vtu").glob("*.pvtu"))) == named
    assert not (tmp_path / "vtu/solution_00009.1.vtu").exists()
