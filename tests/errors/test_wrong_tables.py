# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of activations that cannot be used ends a run before any work, with
exit code 1, and names the file, the line, the column and what is there."""
import pathlib

import pytest
from lumbricus_run import call, run

BLOCK = pathlib.Path(__file__).resolve().parent / "block.prm"
GOOD = "t, 1\n0, 1\n0.5, 0.95\n1, 0.9\n"


def settings(table):
    return ["Muscles/biceps/Active stretch=table",
            f"Muscles/biceps/table/File={table}"]


@pytest.mark.parametrize("text, parts", [
    ("t, 1\n0, 1\n1, 0\n", ["line 3", "column '1'", "is 0", "a number > 0"]),
    ("t, 1\n0, 1\n\n2, -0.5\n", ["line 4", "column '1'", "is -0.5"]),
    ("t, 1\n0, 1\n1, nan\n", ["line 3", "column '1'", "'nan'"]),
    ("t, 1\n0, 1\n1,\n", ["line 3", "column '1'", "there is nothing"]),
    ("t, 1\n0, 1\n1, 1\n1, 1\n", ["line 4", "column 't'", "increase"]),
    ("t, 1, 2\n0, 1, 1\n1, 1, 1\n", ["line 1", "'2'", "1 segment of"]),
    ("t, 1\n", ["has no rows"]),
    ("t, 1\n0, 1\n0.5, 0.9\n", ["from t = 0 to 0.5", "'Repeat'"]),
    (None, ["cannot be read", "No such file"])])
def test_a_wrong_table(tmp_path, text, parts):
    path = tmp_path / "table.csv"
    if text is not None:
        path.write_text(text)
    result = run(BLOCK, tmp_path / "out", settings(path))
    assert result.exit_code == 1, result.message
    for part in ["'Muscles/biceps/table/File'", str(path), *parts]:
        assert part in result.message, result.message
    assert not (tmp_path / "out" / "segments.csv").exists()


def test_a_table_that_has_changed_is_said_at_a_restart(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text(GOOD)
    result = run(BLOCK, tmp_path / "out", [
        *settings(path), "Time/End=0.5", "Checkpoints/Steps=1"])
    assert result.exit_code == 0, result.message
    path.write_text(GOOD.replace("0.9\n", "0.8\n"))
    again = call("--restart", tmp_path / "out", "--set", "Time/End=1")
    assert again.returncode == 1
    assert "'Muscles/biceps/table/File'" in again.stderr
    path.write_text(GOOD)
    again = call("--restart", tmp_path / "out", "--set", "Time/End=1")
    assert again.returncode == 0, again.stderr
