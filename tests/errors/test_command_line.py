# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the command line and the parameter file offer beside a run."""
import contextlib
import json
import os
import pathlib
import pty
import re
import subprocess

import pytest
from lumbricus_run import call, outline, resolved, run, run_well

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"


@pytest.mark.parametrize("option", ["--help", "-h"])
def test_help(option):
    result = call(option)
    assert result.returncode == 0 and result.stderr == ""
    for word in ("--check", "--set", "--output", "--parameters", "--values", "--version",
                 "FILE.prm", "mpirun", "Exit codes"):
        assert word in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 80


@pytest.mark.parametrize("option", ["--version", "-v"])
def test_version(option):
    result = call(option)
    assert result.returncode == 0
    assert result.stdout.startswith("lumbricus ")
    assert "deal.II" in result.stdout and result.stdout.count("\n") == 1


def test_check_computes_and_writes_nothing(tmp_path):
    result = call("--check", BLOCK, folder=tmp_path)
    assert result.returncode == 0 and result.stderr == ""
    # 27 nodes with three displacements, four pressures.
    assert "1 segment, 1 cells, 85 unknowns" in result.stdout
    assert "nothing was computed" in result.stdout
    assert not list(tmp_path.iterdir())

    result = call("--check", BLOCK, "--set", "Time/Ende=1", folder=tmp_path)
    assert result.returncode == 1 and "'Time/Ende'" in result.stderr
    assert not list(tmp_path.iterdir())


def test_values_are_those_of_the_run(tmp_path):
    """--values says all that run.json will say of the parameters, and writes nothing."""
    settings = ["--set", "Time/End=0.125", "--set", "Output/Every=0"]
    result = call("--values", BLOCK, *settings, folder=tmp_path)
    assert result.returncode == 0 and result.stderr == ""
    assert not list(tmp_path.iterdir())
    run_well(BLOCK, tmp_path, ["Time/End=0.125", "Output/Every=0"])
    said, of_run = (
        {entry["path"]: entry for entry in entries if entry["path"] != "Output/Folder"}
        for entries in (json.loads(result.stdout), json.loads(
            (tmp_path / "run.json").read_text())["parameters"]))
    assert said == of_run and said["Time/End"]["value"] == 0.125
    # What --check finds, this finds.
    result = call("--values", BLOCK, "--set", "Time/Ende=1", folder=tmp_path)
    assert result.returncode == 1 and "'Time/Ende'" in result.stderr
    assert result.stdout == ""


def test_parameters_are_complete_and_can_be_read(tmp_path):
    result = call("--parameters")
    assert result.returncode == 0
    values = outline(result.stdout)
    for name in ("Geometry/Shape", "Geometry/block/Lengths",
                 "Geometry/open cylinder/Filled",
                 "Geometry/segment chain/Segments 8-10/Radius",
                 "Tissues/<tissue>/Law", "Tissues/<tissue>/Neo-Hooke/a",
                 "Tissues/<tissue>/Mooney-Rivlin/nu",
                 "Muscles/<muscle>/Fibres", "Muscles/<muscle>/helical/Angle",
                 "Muscles/<muscle>/wave/Amplitude",
                 "Muscles/<muscle>/expression/Formula",
                 "Boundary conditions/Names",
                 "Boundary conditions/<load or support>/Boundary",
                 "Boundary conditions/<load or support>/spring/Stiffness",
                 "Boundary conditions/<load or support>/dead traction/Traction",
                 "Time/Smallest step", "Reset/Limit", "Newton/Force tolerance",
                 "Linear solver/kept factor/Most iterations",
                 "Output/Folder", "Mesh/Global refinements"):
        assert name in values, name

    # Each parameter the program knows is documented right above.
    lines = result.stdout.splitlines()
    for above, line in zip(lines, lines[1:]):
        if line.strip().startswith("set "):
            assert above.strip().startswith("#"), line

    # With the names that stand for the user's, it is a file of defaults: a
    # run of the default body knows every parameter that it names.
    chosen = [name for name in values if "<" not in name and
              name.split("/")[0] in ("Time", "Reset", "Newton", "Mesh")]
    settings = []
    for name in chosen:
        settings += ["--set", f"{name}={values[name]}"]
    assert call("--check", BLOCK, *settings).returncode == 0


def test_set_wins_over_the_file(tmp_path):
    result = run_well(BLOCK, tmp_path / "out",
                      ["Time/End = 0.5", "Title=Set = twice", "Title=Set = 2",
                       "Tissues/flesh/Neo-Hooke/a=2.5",
                       "Boundary conditions/push/follower pressure/Pressure=0",
                       "Muscles/biceps/expression/Formula = 1"])
    values = outline((tmp_path / "out/parameters.prm").read_text())
    assert values["Time/End"] == "0.5"
    assert values["Title"] == "Set = 2"
    assert values["Tissues/flesh/Neo-Hooke/a"] == "2.5"
    assert values["Tissues/flesh/Neo-Hooke/nu"] == "0.5"
    assert "Set = 2" in result.log
    assert result.last()["t"] == 0.5
    assert result.last()["length"] == pytest.approx(2, abs=1e-9)


def test_set_can_choose_what_has_a_section(tmp_path):
    run_well(BLOCK, tmp_path / "out",
             ["Linear solver/kept factor/Most iterations=7",
              "Linear solver/Method=kept factor"])
    values = outline((tmp_path / "out/parameters.prm").read_text())
    assert values["Linear solver/kept factor/Most iterations"] == "7"


@pytest.mark.parametrize("option", ["--output", "-o"])
def test_output_wins_over_the_file(option, tmp_path):
    result = call(BLOCK, option, "here/and there",
                  "--set", "Output/Folder=elsewhere", folder=tmp_path)
    assert result.returncode == 0, result.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["here"]
    folder = tmp_path / "here/and there"
    assert {"log.txt", "parameters.prm", "segments.csv", "solution.pvd",
            "steps.csv", "vtu"} <= {path.name for path in folder.iterdir()}
    assert (folder / "log.txt").read_text() == result.stdout

    result = call(BLOCK, "--set", "Output/Folder=elsewhere", folder=tmp_path)
    assert result.returncode == 0
    assert (tmp_path / "elsewhere/segments.csv").exists()


@pytest.mark.parametrize("arguments, words", [
    (["--chek", BLOCK], ["'--chek' is unknown", "--help"]),
    (["-x", BLOCK], ["'-x' is unknown", "--help"]),
    ([BLOCK, "--set"], ["'--set' needs a value", "--help"]),
    ([BLOCK, "-o"], ["'-o' needs a value", "--help"]),
    ([BLOCK, "-o", ""], ["'--output' needs the name of a folder", "--help"]),
    ([BLOCK, "--set", "Output/Folder="], ["'' cannot be written", "--output"]),
    ([], ["No parameter file was given", "--help"]),
    ([BLOCK, "other.prm"], ["More than one parameter file", "other.prm",
                            "--help"]),
    (["--restart"], ["'--restart' needs a value", "--help"]),
    (["--restart", ""], ["'--restart' needs the name of a folder", "--help"]),
    (["--restart", "run", BLOCK], ["Leave out the parameter file", "--set"]),
    (["--restart", "run", "-o", "there"], ["Leave out '--output'", "--set"]),
    (["--restart", "nowhere"], ["'nowhere' has no checkpoint"]),
    (["none.prm"], ["'none.prm' cannot be read", "path of a .prm or .json file"]),
    (["."], ["'.' cannot be read", "path of a .prm or .json file"]),
])
def test_wrong_command_line(arguments, words, tmp_path):
    result = call(*arguments, folder=tmp_path)
    assert result.returncode == 1
    assert result.stderr.count("lumbricus: ") == 1
    for word in words:
        assert word in result.stderr
    assert not list(tmp_path.iterdir())


def test_include_is_relative_to_the_file_that_includes(tmp_path):
    deep = tmp_path / "cases" / "deep"
    deep.mkdir(parents=True)
    (tmp_path / "cases" / "base.prm").write_text(
        BLOCK.read_text() + "set Title = base\n")
    (deep / "middle.prm").write_text(
        "# A comment may come first.\n\ninclude ../base.prm\n"
        "set Title = middle # the last one wins\n")
    (deep / "case.prm").write_text(
        "include middle.prm # with a comment\n\nsubsection Time\n"
        "  set End = 0.25\nend\n")
    result = run_well(deep / "case.prm", tmp_path / "out")
    assert "middle" in result.log
    assert result.last()["t"] == 0.25


def test_include_has_to_be_at_the_top(tmp_path):
    case = tmp_path / "case.prm"
    case.write_text(f"set Title = x\ninclude {BLOCK}\n")
    result = call(case)
    assert result.returncode == 1
    assert f"{case}, line 2: 'include' must come before the first 'set'" in \
        result.stderr


def test_include_of_itself(tmp_path):
    (tmp_path / "a.prm").write_text("include ../%s/b.prm\n" % tmp_path.name)
    (tmp_path / "b.prm").write_text("include ./a.prm\n")
    result = call(tmp_path / "a.prm")
    assert result.returncode == 1
    assert "includes itself" in result.stderr
    assert "a.prm" in result.stderr and len(result.stderr) < 500


def test_include_of_a_file_that_does_not_exist(tmp_path):
    case = tmp_path / "case.prm"
    case.write_text("include none.prm\n")
    result = call(case)
    assert result.returncode == 1
    assert f"'{tmp_path}/none.prm', which '{case}' includes, cannot be " \
        "read: No such file or directory. Give the path of a .prm or .json " \
        "file, from the folder of the file that includes it." in result.stderr


@pytest.mark.parametrize("encode", [
    lambda text: b"\xef\xbb\xbf" + text.encode(),
    lambda text: text.replace("\n", "\r\n").encode(),
    lambda text: text.replace(" ", "\t").encode()])
def test_files_of_other_editors(encode, tmp_path):
    """A mark at the start of a file was 'could not be parsed'."""
    case = tmp_path / "case.prm"
    case.write_bytes(encode(f"include {BLOCK}\nsubsection Time\n"
                            "  set End = 1\nend\nset Title = Mark\n"))
    result = call("--check", case)
    assert result.returncode == 0, result.stderr
    assert "Mark" in result.stdout


@pytest.mark.parametrize("base", ["block.prm", "chain.prm"])
def test_resolved_parameters_reproduce_the_run(base, tmp_path):
    first = run_well(HERE / base, tmp_path / "first",
                     ["Newton/Most iterations=15", "Time/End=0.7"])
    again = run_well(tmp_path / "first/parameters.prm", tmp_path / "again")
    tables = [(result.folder / "segments.csv").read_text()
              for result in (first, again)]
    assert tables[0] == tables[1]
    assert resolved(first.folder) == resolved(again.folder)


def test_two_ranks_speak_once(tmp_path):
    result = run(BLOCK, tmp_path / "out", options=["--help"], ranks=2)
    assert result.exit_code == 0 and result.log.count("Usage") == 1
    result = run(BLOCK, tmp_path / "out", options=["--chek"], ranks=2)
    assert result.exit_code == 1 and result.message.count("--chek") == 1


def test_quiet_says_nothing_but_the_log_has_it(tmp_path):
    result = run_well(BLOCK, tmp_path, options=["--quiet"])
    assert result.log == "" and result.message == ""
    assert "Where the time went" in (tmp_path / "log.txt").read_text()


def test_verbose_says_what_every_iteration_and_reset_comes_to(tmp_path):
    """As many lines as the tables have rows, in the log too."""
    result = run_well(HERE / "chain.prm", tmp_path, options=["--verbose"])
    assert (tmp_path / "log.txt").read_text() in result.log
    n_iterations = len(result.table("newton.csv"))
    assert n_iterations > 3
    assert len(re.findall(r"Newton \d+: force .*, volume .*, increment .*, "
                          r"step length 1; \d+ linear", result.log)) == \
        n_iterations
    n_solves = len({(row["t"], row["cycle"], row["reset"])
                    for row in result.table("resets.csv")})
    assert len(re.findall(r"solved; divergence .* in segment \d", result.log)) \
        == n_solves
    n_resets = sum(row["resets"] for row in result.segments())
    assert sum(int(n) for n in re.findall(r"reset \d+, of (\d+) segment",
                                          result.log)) == n_resets > 0
    plain = run_well(HERE / "chain.prm", tmp_path)
    assert "Newton 1:" not in plain.log


def test_nothing_on_a_terminal_only_goes_to_files(tmp_path):
    result = run_well(BLOCK, tmp_path)
    assert "\r" not in result.log and "s left" not in result.log
    assert "\r" not in (tmp_path / "log.txt").read_text()


def test_progress_on_a_terminal(tmp_path):
    """The terminal is one of Python's: script(1) takes other options in every
    Debian."""
    ours, its = pty.openpty()
    with subprocess.Popen(
            [os.environ["LUMBRICUS"], BLOCK, "--output", tmp_path / "out"],
            stdin=its, stdout=its, stderr=its) as process:
        os.close(its)
        said = b""
        # At the end of the terminal Linux says that it cannot be read.
        with contextlib.suppress(OSError):
            while part := os.read(ours, 4096):
                said += part
        os.close(ours)
    said = said.decode()
    assert process.returncode == 0, said
    assert "step 2, to time 1 of 1: reset 0, Newton 1" in said
    assert re.search(r"about \d+ s left", said)
    assert "\033[K" in said
    assert "s left" not in (tmp_path / "out/log.txt").read_text()


def test_parameters_in_json(tmp_path):
    """A .prm and its .json give the same run."""
    sections, nested = [{}], None
    for line in BLOCK.read_text().splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            nested = sections[-1].setdefault(line[len("subsection "):], {})
            sections.append(nested)
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, _, value = line[len("set "):].partition("=")
            sections[-1][name.strip()] = value.strip()
    case = tmp_path / "case.json"
    case.write_text(json.dumps(sections[0], indent=2))
    results = [run_well(base, tmp_path / base.suffix[1:])
               for base in (BLOCK, case)]
    tables = [(result.folder / "segments.csv").read_text()
              for result in results]
    assert tables[0] == tables[1]

    sections[0]["Geometry"]["Shap"] = "block"
    case.write_text(json.dumps(sections[0]))
    result = run(case, tmp_path / "wrong")
    assert result.exit_code == 1
    assert "case.json: the parameter 'Geometry/Shap' is unknown" in result.message
    assert "Did you mean 'Geometry/Shape'?" in result.message


@pytest.mark.parametrize("settings, words", [
    (["Tissues/flesh/Neo-Hooke/a=2.3e5"], ["more than steel", "MPa"]),
    (["Geometry/block/Lengths=3000, 3000, 3000"], ["more than 1 m"]),
    (["Geometry/block/Lengths=0.02, 0.001, 0.01"], ["less than 0.01 mm"]),
    (["Units=m, N, Pa", "Geometry/block/Lengths=0.02, 0.01, 0.01",
      "Tissues/flesh/Neo-Hooke/a=0.23"],
     ["less than 1 Pa"]),
    (["Units=other", "Tissues/flesh/Neo-Hooke/a=2.3e5"], []),
    ([], [])])
def test_numbers_that_look_like_other_units(settings, words, tmp_path):
    result = run_well(BLOCK, tmp_path, settings, options=["--check"])
    assert result.log.count("Warning:") == (1 if words else 0), result.log
    for word in words:
        assert word in result.log
