# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that cannot be written."""
import pathlib

import pytest
from mistakes import ManyRuns

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"

run, call = ManyRuns().run, ManyRuns().call


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
    ("log.txt", 1), ("log.txt", 2), ("parameters.prm", 1), ("segments.csv", 1),
    ("points.csv", 1), ("vtu/solution_00000.0.vtu", 1), ("solution.pvd", 2)])
def test_file_that_cannot_be_written(name, ranks, tmp_path):
    (tmp_path / name).mkdir(parents=True)
    result = run(BLOCK, tmp_path, ["Output/Points=0, 0, 0"], ranks)
    assert result.exit_code == 1, result.log + result.message
    message = " ".join(result.message.split("\n---")[0].split())
    assert message == (
        f"lumbricus: The file '{tmp_path}/{name}' cannot be written: Is a "
        "directory. Nothing was computed. See that it may be written, or "
        "choose another folder with 'Output/Folder' or --output.")


def test_disk_that_is_full_from_the_start(tmp_path):
    """/dev/full is a disk that is."""
    (tmp_path / "newton.csv.incomplete").symlink_to("/dev/full")
    result = run(BLOCK, tmp_path)
    assert result.exit_code == 1, result.log + result.message
    assert f"'{tmp_path}/newton.csv' cannot be written: No space left" in \
        result.message


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
