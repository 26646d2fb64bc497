# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that a run has read, at a restart: --restart took what they were then.
A mesh that had been made anew, with as many cells, went in without a word, and
the volumes of the table read 2, 2, 2, 6, 6."""
import os
import pathlib
import shutil
import subprocess

import pytest
from loaded_program import loaded_program
from lumbricus_run import SOURCE, Run, call


CASE = """
include common.prm
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File = meshes/body.msh
    set Liquid tissues =
    set Wall layers =
  end
end
subsection Muscles
  subsection biceps
    set Fibres = file
    subsection file
      set File = fibres.csv
    end
    set Active stretch = expression
    subsection expression
      set Formula = 1 - 0.1*t
    end
  end
end
subsection Boundary conditions
  set Names = left
  subsection left
    set Boundary = left
    set Type = displacement
  end
end
"""
COMMON = """
subsection Tissues
  subsection bar
    set Muscles = biceps
  end
end
subsection Time
  set End = 0.5
  set First step = 0.25
  set Largest step = 0.25
end
subsection Checkpoints
  set Steps = 1
end
"""


def mesh(n, height):
    """A bar of n cells of the length 2."""
    nodes = [f"{4 * i + k + 1} {2 * i / n} {y} {z * height}"
             for i in range(n + 1)
             for k, (y, z) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1)))]
    cells = [f"{i + 1} 5 2 1 1 " +
             " ".join(str(4 * i + k) for k in range(1, 9)) for i in range(n)]
    return "\n".join([
        "$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2",
        '3 1 "bar"', '2 2 "left"', "$EndPhysicalNames", "$Nodes",
        str(len(nodes)), *nodes, "$EndNodes", "$Elements", str(n + 1), *cells,
        f"{n + 1} 3 2 2 2 1 2 3 4", "$EndElements", ""])


def fibres(along):
    return "".join(f"{x}, 0.5, 0.5, {along}\n" for x in (0.5, 1.5))


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    """A folder with a run, and the run that goes on from it."""
    folder = tmp_path_factory.mktemp("study") / "study"
    (folder / "meshes").mkdir(parents=True)
    (folder / "meshes/body.msh").write_text(mesh(2, 1))
    (folder / "fibres.csv").write_text(fibres("1, 0, 0"))
    (folder / "case.prm").write_text(CASE)
    (folder / "common.prm").write_text(COMMON)
    result = call("case.prm", "-o", "run", folder=folder)
    assert result.returncode == 0, result.stderr
    whole = shutil.copytree(folder, folder.parent / "whole")
    expected = restart(whole, "run")
    assert expected.exit_code == 0, expected.message
    return folder, expected


def restart(cwd, folder, settings=("Time/End=1",)):
    arguments = ["--restart", folder]
    for setting in settings:
        arguments += ["--set", setting]
    return Run(call(*arguments, folder=cwd), pathlib.Path(cwd, folder))


@pytest.mark.parametrize("name, content, parameter", [
    ("meshes/body.msh", mesh(2, 3), "Geometry/mesh file/File"),
    ("meshes/body.msh", mesh(3, 1), "Geometry/mesh file/File"),
    ("fibres.csv", fibres("0, 1, 0"), "Muscles/biceps/file/File")])
def test_a_file_that_has_changed(study, tmp_path, name, content, parameter):
    folder = shutil.copytree(study[0], tmp_path / "study")
    shutil.move(study[0], study[0].parent / "away")
    try:
        (folder / name).write_text(content)
        before = (folder / "run/segments.csv").read_text()
        result = restart(folder, "run")
        assert result.exit_code == 1, result.log
        assert f"The file '{name}' (parameter '{parameter}') is not the one " \
            "that the checkpoint was made with: it has changed since. Bring " \
            "it back" in result.said()
        assert (folder / "run/segments.csv").read_text() == before
        (folder / name).unlink()
        result = restart(folder, "run")
        assert result.exit_code == 1
        assert f"'{name}'" in result.said()
        assert f"is not there any more, neither from the working directory " \
            f"nor at '{study[0]}/{name}'" in result.said()
    finally:
        shutil.move(study[0].parent / "away", study[0])


def test_on_two_ranks(study, tmp_path):
    folder = shutil.copytree(study[0], tmp_path / "study")
    content = (study[0] / "fibres.csv").read_text()
    (study[0] / "fibres.csv").write_text(fibres("0, 0, 1"))
    (folder / "fibres.csv").write_text(fibres("0, 0, 1"))
    try:
        process = subprocess.run(
            [os.environ.get("MPIRUN", "mpirun"), "-np", "2",
             loaded_program(), "--restart", "run", "--set",
             "Time/End=1"], cwd=folder, capture_output=True, text=True,
            timeout=60)
        assert process.returncode == 1, process.stdout
        assert process.stderr.count("'fibres.csv' (parameter") == 1
    finally:
        (study[0] / "fibres.csv").write_text(content)


def test_what_is_the_same_goes_on(study, tmp_path):
    """Written anew; from elsewhere; by the files where they were; and with what
    was only included gone."""
    expected = study[1].segments()
    folder = shutil.copytree(study[0], tmp_path / "study")
    for name in ("meshes/body.msh", "fibres.csv"):
        (folder / name).write_text((folder / name).read_text())
    (folder / "common.prm").unlink()
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    # From the same folder, from another, and again from the first.
    for cwd, to in ((folder, 0.75), (elsewhere, 0.875), (folder, 1)):
        result = restart(cwd, folder / "run", [f"Time/End={to}"])
        assert result.exit_code == 0, result.message
        assert result.last()["t"] == to
    for key in expected[-1]:
        if key not in ("eta", "resets"):
            assert result.last()[key] == pytest.approx(
                expected[-1][key], rel=1e-9, nan_ok=True)


def test_another_mesh_of_that_name_where_the_run_goes_on(study, tmp_path):
    """The one the run has read is taken, which is where it was."""
    folder = shutil.copytree(study[0] / "run", tmp_path / "run")
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes/body.msh").write_text(mesh(3, 3))
    result = restart(tmp_path, folder)
    assert result.exit_code == 0, result.message
    assert result.last()["length"] == pytest.approx(
        study[1].last()["length"], rel=1e-9, nan_ok=True)
    assert f"set File = {study[0]}/meshes/body.msh" in " ".join(
        (folder / "parameters.prm").read_text().split())


def test_other_fibres_that_are_asked_for(study, tmp_path):
    """Muscles may change at a restart, where the user says so."""
    folder = shutil.copytree(study[0], tmp_path / "study")
    (folder / "other.csv").write_text(fibres("0, 1, 0"))
    result = restart(folder, "run", ["Time/End=0.75",
                                     "Muscles / biceps/file/File = other.csv"])
    assert result.exit_code == 0, result.message
    (folder / "fibres.csv").unlink()
    assert restart(folder, "run").exit_code == 0
    (folder / "other.csv").write_text(fibres("1, 1, 0"))
    result = restart(folder, "run", ["Time/End=2"])
    assert result.exit_code == 1
    assert "'other.csv' (parameter 'Muscles/biceps/file/File')" in result.said()


def test_a_mesh_out_of_a_pipe(study, tmp_path):
    """Every rank would read a part of it, and a restart nothing."""
    folder = shutil.copytree(study[0], tmp_path / "study")
    os.mkfifo(folder / "pipe")
    result = call("case.prm", "-o", "piped", "--set",
                       "Geometry/mesh file/File=pipe", folder=folder)
    assert result.returncode == 1
    assert "'pipe' cannot be read" in result.stderr
