# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run that goes on from a checkpoint does what it would have done."""
import os
import shutil
import signal
import subprocess
import time
import zlib

import pytest
from faults import (CASE, checkpoints, differences, fresh, kill_all, ranks_of,
                    start, wait_for_step)
from lumbricus_run import restart

# On the same number of ranks, and on another.
SAME, OTHER = 1e-12, 1e-9


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """The run that nothing happens to, on one and two ranks."""
    runs = {}
    for ranks in (1, 2):
        runs[ranks] = fresh(tmp_path_factory.mktemp("whole"), ranks)
        assert runs[ranks].exit_code == 0, runs[ranks].message
    return runs


def killed_at(folder, ranks, step, settings=()):
    arguments = [CASE, "--output", folder]
    for setting in settings:
        arguments += ["--set", setting]
    process = start(ranks, *arguments)
    wait_for_step(folder, step, process)
    kill_all(process)


@pytest.mark.parametrize("before, after", [(1, 1), (2, 2), (1, 2), (2, 1)])
def test_same_numbers(tmp_path, reference, before, after):
    killed_at(tmp_path, before, 4)
    run = restart(tmp_path, ranks=after)
    assert run.exit_code == 0, run.message
    assert "Going on from time" in run.log
    assert differences(run, reference[before]) < \
        (SAME if before == after else OTHER)
    # The tables have every row once, the pictures every step.
    for table in ("steps.csv", "resets.csv"):
        assert len(run.table(table)) == len(reference[before].table(table))
    assert (tmp_path / "solution.pvd").read_text().count("DataSet") == \
        (reference[before].folder / "solution.pvd").read_text().count("DataSet")
    assert (tmp_path / "log.txt").read_text().count("lumbricus") == 2


@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGUSR1])
def test_a_signal_writes_a_checkpoint(tmp_path, reference, sent):
    """SIGTERM as a batch system sends it to all ranks; SIGUSR1 to mpirun, which
    passes it on. Not even checkpoints after steps are asked for."""
    process = start(2, CASE, "--output", tmp_path,
                    "--set", "Checkpoints/Steps=0")
    while not (tmp_path / "steps.csv").exists() or \
            len((tmp_path / "steps.csv").read_text().splitlines()) < 5:
        assert process.poll() is None
        # Busy waiting would take a core from the ranks.
        time.sleep(0.02)
    if sent == signal.SIGTERM:
        for pid in ranks_of(process):
            os.kill(pid, sent)
    else:
        os.kill(process.pid, sent)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 4, out + err
    assert sent.name in err and f"--restart '{tmp_path}'" in err
    assert len(checkpoints(tmp_path)) == 1
    run = restart(tmp_path, ranks=2)
    assert run.exit_code == 0, run.message
    assert differences(run, reference[2]) < OTHER


def test_longer_at_a_restart(tmp_path, reference):
    """The end of a run is a checkpoint: it can be made longer."""
    half = fresh(tmp_path, 1, ["Time/End=0.5"])
    assert half.exit_code == 0
    run = restart(tmp_path, ["Time/End=1"])
    assert run.exit_code == 0, run.message
    assert differences(run, reference[1]) < SAME


@pytest.mark.parametrize("setting", [
    "Geometry/segment chain/Radius=3", "Mesh/Global refinements=1",
    "Tissues/wall/Law=Mooney-Rivlin", "Interface/Coupling=slip",
    "Reset/Mode=full", "Output/Points=0, 0, 0"])
def test_what_cannot_change_is_refused_by_name(tmp_path_factory, setting):
    folder = tmp_path_factory.getbasetemp() / "short"
    if not folder.exists():
        assert fresh(folder, 1, ["Time/End=0.1"]).exit_code == 0
    run = restart(folder, [setting])
    assert run.exit_code == 1
    assert setting in run.message and "restart" in run.message


def damage(path, how):
    content = path.read_bytes()
    if how == "truncated":
        path.write_bytes(content[:len(content) // 2])
    elif how == "changed":
        middle = len(content) // 2
        path.write_bytes(content[:middle] + bytes([content[middle] ^ 1])
                         + content[middle + 1:])
    else:
        path.unlink()


@pytest.fixture(scope="module")
def three_steps(tmp_path_factory):
    """The first three steps, with two checkpoints."""
    folder = tmp_path_factory.mktemp("three")
    assert fresh(folder, 2, ["Time/End=0.3"]).exit_code == 0
    return folder


@pytest.mark.parametrize("how", ["truncated", "changed", "missing"])
@pytest.mark.parametrize("name", ["cells.1", "mesh", "progress", "MANIFEST"])
def test_a_damaged_checkpoint_is_left_out(tmp_path, reference, three_steps,
                                          name, how):
    folder = shutil.copytree(three_steps, tmp_path / "run")
    damage(folder / "checkpoints" / "000003" / name, how)
    run = restart(folder, ["Time/End=0.4"], 2)
    assert run.exit_code == 0, run.message
    assert "000003' cannot be used" in run.log
    assert "after step 2" in run.log
    rows = run.segments()
    whole = reference[2].segments()[:len(rows)]
    assert rows[-1]["t"] == pytest.approx(0.4)
    for row, other in zip(rows, whole):
        assert row["length"] == pytest.approx(other["length"], rel=SAME)


def rewrite(folder, name, change):
    """Change the content of a file of all checkpoints, which stay whole."""
    for manifest in folder.glob("checkpoints/*/MANIFEST"):
        lines = manifest.read_text().splitlines()[:-1]
        if name == "MANIFEST":
            lines = [change(line) for line in lines]
        for i, line in enumerate(lines):
            if line.endswith(f" {name}"):
                path = manifest.parent / name
                content = change(path.read_bytes())
                path.write_bytes(content)
                lines[i] = f"file {zlib.crc32(content)} {len(content)} {name}"
        text = "\n".join(lines) + "\n"
        manifest.write_text(f"{text}checksum {zlib.crc32(text.encode())}\n")


def of_another_version(line):
    return "version 99.9" if line.startswith("version") else line


def test_a_checkpoint_of_another_version(tmp_path, three_steps):
    """The log names the other version, and the run goes on."""
    folder = shutil.copytree(three_steps, tmp_path / "run")
    rewrite(folder, "MANIFEST", of_another_version)
    run = restart(folder, ["Time/End=0.4"], 2)
    assert run.exit_code == 0, run.message
    assert "written by version 99.9" in run.log


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_checkpoint_with_what_is_not_known_yet(ranks, tmp_path, three_steps):
    """An unknown entry ended the run with exit code 3 and a stack trace."""
    folder = shutil.copytree(three_steps, tmp_path / "run")
    rewrite(folder, "MANIFEST", of_another_version)
    rewrite(folder, "progress", lambda text: text + b"temperature 300\n")
    run = restart(folder, ["Time/End=0.4"], ranks)
    assert run.exit_code == 1, run.message
    message = run.said()
    assert "000003' cannot be used: it is of version 99.9 and has " \
        "'temperature'" in message
    assert "Go on with that version" in message
    assert "Stacktrace" not in message


def test_a_checkpoint_of_another_mesh(tmp_path, three_steps):
    """Its parameters cannot be changed by hand."""
    folder = shutil.copytree(three_steps, tmp_path / "run")
    rewrite(folder, "parameters.prm", lambda text: text.replace(
        b"set Number of segments ", b"set Cap thickness = 0.3 # "))
    run = restart(folder, ["Time/End=0.4"], 2)
    assert run.exit_code == 1, run.message
    message = run.said()
    assert "000003' is of " in message and "but the mesh of its parameters " \
        "has " in message
    assert "start the run from its parameter file" in message


def test_nothing_to_go_on_from(tmp_path):
    run = restart(tmp_path)
    assert run.exit_code == 1
    assert "no checkpoint" in run.message and str(tmp_path) in run.message


def test_a_table_that_is_gone(tmp_path):
    assert fresh(tmp_path, 1, ["Time/End=0.1"]).exit_code == 0
    (tmp_path / "segments.csv").unlink()
    run = restart(tmp_path, ["Time/End=0.2"])
    assert run.exit_code == 1
    message = run.said()
    assert f"'{tmp_path}/segments.csv' is shorter than it was at the " \
        "checkpoint (No such file or directory). Bring it back" in message


@pytest.fixture
def small_disk(tmp_path):
    """A file system with room for 236 kB."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=236k", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True).returncode != 0:
        pytest.skip("only root can mount a small disk")
    yield folder
    subprocess.run(["umount", "-l", str(folder)], check=True)


def test_a_full_disk(small_disk):
    """There is room for the tables and for one checkpoint of 124 kB. That the
    next cannot be written is said, and the run goes on; in the end the pictures
    cannot, which ends it. Nothing is half written, and what is there is good."""
    run = fresh(small_disk, 1, ["Output/Every=0", "Time/End=0.2"])
    assert run.exit_code == 2, run.log + run.message
    assert "no checkpoint" in run.log and "No space left" in run.log
    assert "cannot be written" in run.message
    assert len(run.table("steps.csv")) == 3
    assert checkpoints(small_disk) == [1]
    assert not list(small_disk.glob("checkpoints/*/*.incomplete"))


def test_the_folder_disappears(tmp_path):
    folder = tmp_path / "run"
    process = start(2, CASE, "--output", folder)
    wait_for_step(folder, 2, process)
    shutil.rmtree(folder, ignore_errors=True)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 2, out + err
    assert str(folder) in err and "cannot be" in err
