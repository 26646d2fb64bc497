# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that cannot be written."""
import os
import pathlib
import resource
import signal
import subprocess

import pytest
from lumbricus_run import Run, call, run

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"


@pytest.mark.parametrize("folder, ranks", [("file", 1), ("file/below", 1),
                                           ("file/below", 2),
                                           (300 * "x", 1),
                                           ("/proc/lumbricus", 1)])
def test_folder_that_cannot_be_written(folder, ranks, tmp_path):
    (tmp_path / "file").write_text("")
    result = run(BLOCK, tmp_path / folder, ranks=ranks)
    assert result.exit_code == 1
    assert result.message.count("cannot be written") == 1
    assert str(tmp_path / folder) in result.message
    assert "'Output/Folder' or --output" in result.message
    assert result.log == ""


# A log that could not be opened was left out without a word; the others ended
# with exit code 2, as if a solve had failed.
@pytest.mark.parametrize("name, ranks", [
    ("log.txt", 1), ("log.txt", 2), ("parameters.prm", 1), ("run.json", 1),
    ("run.json", 2), ("segments.csv", 1), ("points.csv", 1),
    ("vtu/solution_00000.0.vtu", 1), ("solution.pvd", 2)])
def test_folders_of_the_names_of_files(name, ranks, tmp_path):
    (tmp_path / name).mkdir(parents=True)
    result = run(BLOCK, tmp_path, ["Output/Points=0, 0, 0"], ranks)
    assert result.exit_code == 1, result.log + result.message
    assert result.said() == (
        f"lumbricus: The file '{tmp_path}/{name}' is not as a run of lumbricus "
        "has left it, and would be overwritten. Move it away, or choose "
        "another folder with 'Output/Folder' or --output.")


# On a loaded machine mpirun's own lines came before those of the ranks, and the
# message was not found among them.
@pytest.mark.parametrize("order", [(0, 1, 2), (1, 0, 2), (1, 2, 0)])
def test_words_of_mpirun_are_told_apart(order):
    line = "-" * 74 + "\n"
    parts = ["\nlumbricus: The file is -----\n--- not there.\n",
             line + "Primary job  terminated normally, but 1 process\n" + line,
             line + "mpirun detected that\n\n  Exit code: 1\n" + line]
    process = subprocess.CompletedProcess(
        [], 1, "", "".join(parts[i] for i in order))
    assert Run(process, ".").said() == \
        "lumbricus: The file is ----- --- not there."


@pytest.mark.parametrize("most, file", [
    (10, "lumbricus.lock"), (220, "lumbricus.run"), (700, "parameters.prm")])
def test_disk_that_is_full_from_the_start(most, file, tmp_path):
    """Files of so many bytes at most, the signal for which is ignored."""
    command = [os.environ["LUMBRICUS"], BLOCK, "--output", tmp_path]

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

    process = subprocess.Popen(command, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True,
                               preexec_fn=limit)
    _, message = process.communicate(timeout=60)
    assert process.returncode == 1, message
    assert "cannot be written: File too large" in message
    assert file in message or file == "lumbricus.lock"
    # There is room again, and what is there is the run's.
    assert run(BLOCK, tmp_path).exit_code == 0


def test_checkpoint_that_cannot_be_written(tmp_path):
    """The run says so and goes on."""
    (tmp_path / "checkpoints").write_text("")
    result = run(BLOCK, tmp_path, ["Checkpoints/Steps=1"])
    assert result.exit_code == 0, result.message
    assert f"no checkpoint: The folder '{tmp_path}/checkpoints/000001' " \
        "cannot be made: Not a directory. The last one is still there." in \
        result.log


def test_check_does_not_need_a_folder(tmp_path):
    (tmp_path / "file").write_text("")
    result = call("--check", BLOCK, "--output", tmp_path / "file")
    assert result.returncode == 0, result.stderr
