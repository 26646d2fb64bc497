# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the program from a test and read what it leaves.

The program and mpirun come from the environment variables LUMBRICUS and
MPIRUN, which ctest sets; runs are those of the loaded_program().
"""
import contextlib
import csv
import os
import pathlib
import re
import subprocess
import tempfile

from loaded_program import loaded_program

SOURCE = pathlib.Path(__file__).resolve().parent.parent


def without_words_of_mpirun(text):
    """What is left without the paragraphs between lines of dashes that mpirun
    adds where processes fail, before or after or amid what they said."""
    return re.sub("^-{60,}\n.*?^-{60,}(\n|$)", "", text,
                  flags=re.MULTILINE | re.DOTALL)


class Run:
    """A finished run: exit code, what it said, and its tables."""

    def __init__(self, process, folder):
        self.exit_code = process.returncode
        self.log = process.stdout
        self.message = process.stderr
        self.folder = pathlib.Path(folder)

    def said(self):
        """The program's words on standard error, in one line."""
        return " ".join(without_words_of_mpirun(self.message).split())

    def table(self, name):
        """All rows of a .csv file as dictionaries of numbers."""
        with open(self.folder / name) as file:
            return [{key: float(value) for key, value in row.items()}
                    for row in csv.DictReader(file)]

    def segments(self):
        return self.table("segments.csv")

    def last(self, segment=1):
        """The last row of a segment."""
        return [row for row in self.segments() if row["segment"] == segment][-1]

    def steps(self):
        """The rows of steps.csv but the one of the state at rest."""
        return self.table("steps.csv")[1:]

    def costs(self):
        """What the run took: sums over its steps, unknowns of the mesh at rest,
        seconds in all and the peak memory of the largest rank."""
        steps = self.steps()
        return {**{name: int(sum(row[name] for row in steps)) for name in
                   ("newton_iterations", "linear_iterations",
                    "factorisations")},
                "steps": len(steps),
                "unknowns": int(self.table("mesh.csv")[0]["unknowns"]),
                "seconds": steps[-1]["elapsed_seconds"],
                "megabytes": int(re.search(r"largest rank: (\d+) MB",
                                           self.log).group(1))}


def start(command, **keywords):
    """subprocess.run(), with a folder for temporary files that no other run shares:
    tests start some side by side, and conftest.py says what Open MPI then does."""
    with tempfile.TemporaryDirectory(prefix="t", dir="/tmp") as temporary:
        return subprocess.run([str(word) for word in command], text=True,
                              stdin=subprocess.DEVNULL, capture_output=True,
                              env=dict(os.environ, TMPDIR=temporary), **keywords)


def call(*arguments, folder=None):
    """The program on one rank, in a folder, with any arguments."""
    return start([loaded_program(), *arguments], timeout=120, cwd=folder)


def run(parameter_file, folder, settings=(), ranks=1, options=(),
        timeout=900):
    """Run FILE.prm with "Section/Name=value" settings on some ranks; on one
    without mpirun, which takes longer to start than the program."""
    mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
    command = [*(mpirun if ranks > 1 else []),
               loaded_program(), str(parameter_file),
               "--output", str(folder), *options]
    for setting in settings:
        command += ["--set", setting]
    return Run(start(command, timeout=timeout), folder)


def run_well(*arguments, **keywords):
    """Run, and fail the test with the program's message if it fails."""
    result = run(*arguments, **keywords)
    assert result.exit_code == 0, result.log + result.message
    return result


def restart(folder, settings=(), ranks=1, timeout=900):
    """Let a run go on from its last checkpoint."""
    mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
    command = [*(mpirun if ranks > 1 else []), loaded_program(),
               "--restart", str(folder)]
    for setting in settings:
        command += ["--set", setting]
    return Run(start(command, timeout=timeout), folder)


def go_on(folder, settings=(), ranks=1, timeout=900):
    """The same, which has to go well."""
    result = restart(folder, settings, ranks, timeout)
    assert result.exit_code == 0, result.log + result.message
    return result


def outline(text):
    """The value of each parameter of a file, by its full name."""
    values, sections = {}, []
    for line in text.splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):])
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, value = line[len("set "):].split("=", 1)
            values["/".join([*sections, name.strip()])] = value.strip()
    assert not sections
    return values


def resolved(folder):
    """The text of parameters.prm in a folder, which is said to be the one for
    the results, without the name of that."""
    text = (folder / "parameters.prm").read_text(encoding="utf-8")
    assert outline(text)["Output/Folder"] == str(folder.resolve())
    return text.replace(str(folder.resolve()), "")


def children_of(parent):
    """The ids of all processes that a process has started, which under mpirun
    are the ranks."""
    found = []
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            # Process, name in parentheses, state, parent, ...
            if int(status.read_text().rpartition(")")[2].split()[1]) == parent:
                found.append(int(status.parent.name))
    return found
