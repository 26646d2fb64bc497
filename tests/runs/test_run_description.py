# SPDX-License-Identifier: LGPL-2.1-or-later
"""run.json says what a run is, and parameters.prm runs it again, into its
folder."""
import json
import os
import signal
import subprocess
import sys
import time

import pytest

from loaded_program import loaded_program
from lumbricus_run import SOURCE, Run, go_on, outline, run, run_well

sys.path.insert(0, str(SOURCE / "scripts"))
from write_parameter_reference import parse  # noqa: E402

CHAIN = SOURCE / "tests" / "faults" / "short.prm"
BLOCK = SOURCE / "tests" / "errors" / "block.prm"
SHORT = ["Time/End=0.2"]
RANKS = pytest.mark.parametrize("ranks", [1, 2])


def described(folder):
    return json.loads((folder / "run.json").read_text(encoding="utf-8"))


def parameters_of(folder):
    return {entry["path"]: entry for entry in
            described(folder)["parameters"]}


@pytest.fixture(scope="module", params=[1, 2])
def chain(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("chain")
    return run_well(CHAIN, folder,
                    [*SHORT, 'Title=A "worm" of 2 mm², \\ and µm'],
                    ranks=request.param), request.param


def test_what_it_is(chain):
    result, ranks = chain
    found = described(result.folder)
    assert list(found) == ["format", "program", "title", "status", "restart",
                           "body", "boundary_conditions", "body_forces",
                           "obstacles", "where_the_time_went", "parameters"]
    assert found["format"] == 1
    assert found["title"] == 'A "worm" of 2 mm², \\ and µm'
    assert found["restart"] is None
    program = found["program"]
    assert program["ranks"] == ranks
    assert result.log.splitlines()[0] == (
        f"{program['name']} {program['version']} (deal.II "
        f"{program['deal_ii']}, {program['build_type']})")
    assert found["body"] == {
        "dimension": 3, "axis": "x", "segments": 2,
        "symmetry_planes": [{"normal": "y", "position": 0},
                            {"normal": "z", "position": 0}],
        "tissues": [
            {"name": "liquid", "liquid": True, "law": "Neo-Hooke",
             "muscles": []},
            {"name": "wall", "liquid": False, "law": "Neo-Hooke",
             "muscles": ["circular"]},
            *({"name": name, "liquid": False, "law": "Neo-Hooke",
               "muscles": []} for name in ("septum", "cap"))],
        "muscles": [{"name": "circular", "field": "circular",
                     "tissues": ["wall"], "fibres": "circumferential",
                     "action": "active stretch",
                     "activation": "expression"}],
        "boundaries": found["body"]["boundaries"]}
    assert "skin" in found["body"]["boundaries"]
    assert found["boundary_conditions"] == found["body_forces"] == \
        found["obstacles"] == []


def test_how_it_went(chain):
    result, _ = chain
    found = described(result.folder)
    last = result.table("steps.csv")[-1]
    status = found["status"]
    assert (status["state"], status["message"]) == ("finished", "")
    assert (status["step"], status["time"]) == (last["step"], last["t"])
    assert status["end_time"] == 0.2
    costs = found["where_the_time_went"]
    assert status["seconds"] == costs["seconds"] >= last["elapsed_seconds"]
    parts = {part["name"]: part for part in costs["parts"]}
    assert sum(part["seconds"] for part in parts.values()) < costs["seconds"]
    below = {part["name"]: part for part in parts["linear solver"]["parts"]}
    assert below["iterations"]["calls"] >= sum(
        row["linear_iterations"] for row in result.table("steps.csv")) > 0
    assert costs["peak_memory_mb"] > 10
    # The log has the same table.
    for name, part in parts.items():
        assert f"  {name:25}{part['seconds']:12.2f}" in result.log


def reference():
    """(default, unit, meaning) of all parameters there are, by path."""
    said = subprocess.run([loaded_program(), "--parameters"], text=True,
                          capture_output=True, check=True, timeout=60).stdout
    found = {}
    for section, _, entries in parse(said):
        for name, default, comment in entries:
            unit, text = "", comment
            if comment.startswith("["):
                unit, _, text = comment[1:].partition("]")
            found[section + (name,)] = default, unit, text.strip()
    return found


def entry_in(known, path):
    """The entry of a path; a name in angle brackets stands for any."""
    found = [entry for names, entry in known.items()
             if len(names) == len(path) and all(
                 name == own or (name[0] + name[-1] == "<>")
                 for name, own in zip(names, path))]
    assert found, path
    return found[0]


def same(value, text):
    """Whether a value is what a parameter file says."""
    if isinstance(value, bool):
        return text == ("true" if value else "false")
    if isinstance(value, str):
        return value == text
    return value == float(text)


def test_all_parameters_with_what_they_mean(chain):
    """As in parameters.prm, and as --parameters has them."""
    result, _ = chain
    found = parameters_of(result.folder)
    values = outline((result.folder / "parameters.prm").read_text())
    assert list(found) == list(values)
    known = reference()
    for path, entry in found.items():
        assert set(entry) == {"path", "value", "default", "unit", "meaning"}
        assert same(entry["value"], values[path]), path
        default, unit, meaning = entry_in(known, path.split("/"))
        assert entry["unit"] == unit, path
        assert entry["meaning"].split() == meaning.split(), path
        if path != "Tissues/liquid/Neo-Hooke/a":  # which hangs on the liquid
            assert same(entry["default"], default), path
    # What is always there is there.
    for section, name in (("Time", "End"), ("Newton", "Force tolerance"),
                          ("Output", "Every")):
        assert (section, name) in known and f"{section}/{name}" in found
    kinds = {path: type(found[path]["value"]) for path in (
        "Time/End", "Output/Every", "Tissues/wall/Neo-Hooke/a", "Title",
        "Boundary conditions/Minimal support")}
    assert kinds == {"Time/End": float, "Output/Every": int,
                     "Tissues/wall/Neo-Hooke/a": float, "Title": str,
                     "Boundary conditions/Minimal support": bool}
    assert found["Tissues/wall/Neo-Hooke/a"]["unit"] == "N/mm^2"


@RANKS
def test_loads_and_supports(ranks, tmp_path):
    run_well(BLOCK, tmp_path, ranks=ranks)
    found = described(tmp_path)
    assert found["body"]["symmetry_planes"] == []
    assert found["boundary_conditions"] == [
        {"name": "wall", "boundary": "x min", "type": "displacement",
         "prescribed_displacements": ["x", "y", "z"]},
        {"name": "push", "boundary": "x max", "type": "follower pressure",
         "prescribed_displacements": []}]


@RANKS
def test_a_run_that_goes_on(ranks, tmp_path):
    run_well(CHAIN, tmp_path, SHORT, ranks=ranks)
    before = described(tmp_path)
    go_on(tmp_path, ["Time/End=0.3"], ranks=3 - ranks)
    after = described(tmp_path)
    assert after["restart"] == {
        "step": 2, "time": before["status"]["time"],
        "version": before["program"]["version"]}
    assert after["program"]["ranks"] == 3 - ranks
    assert after["status"]["state"] == "finished"
    assert after["status"]["step"] == 3
    assert after["status"]["time"] == after["status"]["end_time"] == 0.3
    # Those before the checkpoint are among them.
    steps = Run(subprocess.CompletedProcess([], 0), tmp_path).steps()
    assert after["status"]["seconds"] > steps[-1]["elapsed_seconds"]
    assert steps[-1]["elapsed_seconds"] > steps[-2]["elapsed_seconds"]
    assert after["body"] == before["body"]
    changed = [a["path"] for a, b in zip(after["parameters"],
                                         before["parameters"]) if a != b]
    assert changed == ["Time/End"]


@RANKS
def test_a_run_that_is_interrupted(ranks, tmp_path):
    """Until then it says that it is running."""
    command = [os.environ["LUMBRICUS"], BLOCK, "--output", tmp_path,
               "--set", "Time/Largest step=1e-3", "--set", "Output/Every=0",
               "--set", "Time/First step=1e-3"]
    if ranks > 1:
        command = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks),
                   *command]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    end = time.time() + 120
    while not (tmp_path / "steps.csv").exists() or \
            (tmp_path / "steps.csv").read_text().count("\n") < 5:
        assert process.poll() is None and time.time() < end
        time.sleep(0.01)
    status = described(tmp_path)["status"]
    assert (status["state"], status["step"]) == ("running", 0)
    assert described(tmp_path)["where_the_time_went"] is None
    process.send_signal(signal.SIGUSR1)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 4, said
    found = described(tmp_path)
    assert found["status"]["state"] == "interrupted"
    assert "Interrupted by SIGUSR1" in found["status"]["message"]
    assert found["status"]["message"] in said
    assert found["where_the_time_went"]["seconds"] > 0
    steps = Run(process, tmp_path).steps()
    assert found["status"]["step"] == steps[-1]["step"]
    # Tables have 15 digits: after nine steps of 0.001 it is 0.009000000000000001.
    assert found["status"]["time"] == pytest.approx(steps[-1]["t"], rel=1e-14)
    assert steps[-1]["t"] < 1


@RANKS
def test_a_run_that_fails(ranks, tmp_path):
    result = run(BLOCK, tmp_path, [
        "Newton/Most iterations=1", "Newton/Force tolerance=1e-14",
        "Time/Smallest step=0.4"], ranks=ranks)
    assert result.exit_code == 2, result.message
    status = described(tmp_path)["status"]
    assert (status["state"], status["step"]) == ("failed", 0)
    assert status["message"] in result.message
    assert "The last good state" in status["message"]


@RANKS
def test_parameters_run_the_run_again(ranks, tmp_path):
    """Into its folder, from anywhere, after --output and --set. They had the
    folder of the parameter file, and names of files from where the run was."""
    here, elsewhere = tmp_path / "here", tmp_path / "else where"
    here.mkdir()
    elsewhere.mkdir()
    (here / "fibres.csv").write_text("0, 0, 0, 1, 0.1, 0\n1, 1, 1, 1, 0, 0\n")
    (here / "case.prm").write_text(
        f"include {BLOCK}\nsubsection Output\n  set Folder = not here\nend\n"
        "subsection Muscles\n  subsection biceps\n    set Fibres = file\n"
        "    subsection file\n      set File = fibres.csv\n    end\n  end\n"
        "end\n")

    def call(folder, *arguments):
        mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
        process = subprocess.run(
            [*(mpirun if ranks > 1 else []), loaded_program(), *arguments], cwd=folder, capture_output=True, text=True,
            timeout=120)
        assert process.returncode == 0, process.stdout + process.stderr

    call(here, "case.prm", "--output", "a/b", "--set",
         "Tissues/flesh/Neo-Hooke/a=2", "--set", "Time/First step=0.25")
    folder = here / "a/b"
    names = ("segments.csv", "reactions.csv", "newton.csv", "parameters.prm")
    before = {name: (folder / name).read_bytes() for name in names}
    assert described(folder)["status"]["step"] > 2
    values = outline((folder / "parameters.prm").read_text())
    assert values["Output/Folder"] == str(folder)
    assert values["Muscles/biceps/file/File"] == str(here / "fibres.csv")
    assert values["Tissues/flesh/Neo-Hooke/a"] == "2"

    (folder / "segments.csv").unlink()
    call(elsewhere, "../here/a/b/parameters.prm")
    assert {name: (folder / name).read_bytes() for name in names} == before
    assert list(elsewhere.iterdir()) == []
    assert sorted(path.name for path in here.iterdir()) == [
        "a", "case.prm", "fibres.csv"]
