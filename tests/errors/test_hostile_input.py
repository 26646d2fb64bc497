# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files and values that nobody would write by hand: too long, too deep, too
many, no files at all, and files in which something was changed at random. A
value of 15,000 letters, lists 10,000 deep in JSON and 'include /dev/zero' ended
with a signal, with exit code 3 or with the memory. Each has to end with exit
code 1, at once, and with a short message."""
import os
import pathlib
import random
import resource
import subprocess
import time

import pytest
from lumbricus_run import run
from mistakes import JARGON, run_all

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"
CHAIN = HERE / "chain.prm"
JSON = """{"Geometry": {"Shape": "block", "block": {"Lengths": [2, 1, 1],
  "Cells": [2, 1, 1], "Tissue name": "flesh"}}, "Tissues": {"flesh": {"Law":
  "Mooney-Rivlin", "Mooney-Rivlin": {"a": 1.5, "b": 1e-1, "nu": 0.5}}},
  "Time": {"End": 2, "First step": 0.5}, "Boundary conditions":
  {"Names": ["wall"], "wall": {"Boundary": "x min", "Type": "displacement"},
  "Minimal support": true}, "Output": {"Points": "1, 0.5, 0.5"}}"""
LONGEST_MESSAGE = 1000
MOST_SECONDS = 20

FORMULA = "Muscles/biceps/expression/Formula"
MANY = 10**6


def chain_of_files(folder, n):
    """Files that include each other; the first one's name."""
    for i in range(n):
        (folder / f"{i}.prm").write_text(f"include {i + 1}.prm\n")
    (folder / f"{n}.prm").write_text("set Title = x\n")
    return "0.prm"


def files_that_double(folder, n):
    """Files of which each includes the next twice: 2^n files in all."""
    for i in range(n):
        (folder / f"{i}.prm").write_text(2 * f"include {i + 1}.prm\n")
    (folder / f"{n}.prm").write_text("set Title = x\n")
    return "0.prm"


def sparse(folder, size):
    with open(folder / "sparse.prm", "wb") as file:
        file.truncate(size)
    return "sparse.prm"


def pipe(folder):
    os.mkfifo(folder / "pipe.prm")
    return "pipe.prm"


def text(content, name="case.prm"):
    """A file of this text."""
    def make(folder):
        (folder / name).write_text(content)
        return name
    return make


def with_value(parameter, value):
    """The block with one more value, in a file: settings cannot be long."""
    *sections, name = parameter.split("/")
    return text(f"include {BLOCK}\n" + "".join(
        f"subsection {section}\n" for section in sections) +
        f"set {name} = {value}\n" + len(sections) * "end\n")


# What it is; the file, or what makes it in a folder; settings; what is said.
HOSTILE = [
    ("folder", lambda folder: ".", [], "it is a folder"),
    ("device", "/dev/zero", [], "it is a device"),
    ("pipe", pipe, [], "it is a pipe"),
    ("name that is too long", "a" * 5000 + ".prm", [], "File name too long"),
    ("name with a line break", "a\nb.prm", [], "No such file"),
    ("name that is no UTF-8", b"\xe4.prm".decode(errors="surrogateescape"), [],
     "No such file"),
    ("10 GB", lambda folder: sparse(folder, 10 * 2**30), [],
     "is larger than the 16 MiB"),
    ("include of a device", text("include /dev/zero\n"), [], "it is a device"),
    ("include of a folder", text("include /\n"), [], "it is a folder"),
    ("include of itself", text("include case.prm\n"), [], "includes itself"),
    ("include of a pipe", lambda folder: text(f"include {pipe(folder)}\n")(
        folder), [], "it is a pipe"),
    ("include of a program", text("include /bin/sh\n"), [],
     "is not plain text"),
    ("include of a long name", text(f"include {'a' * 5000}\n"), [],
     "File name too long"),
    ("a chain of includes", lambda folder: chain_of_files(folder, 2000), [],
     "one of more than 64 that include each other"),
    ("includes that double", lambda folder: files_that_double(folder, 30), [],
     "one of more than 1000 that include each other"),
    ("many sections in each other", text(100000 * "subsection a\n"), [],
     "in more than 64 sections"),
    ("deep JSON", text(10000 * '{"a":' + "1" + 10000 * "}", "case.json"), [],
     "more than 64 objects and lists are in each other"),
    ("deep list in JSON", text(10**5 * "[", "case.json"), [],
     "more than 64 objects and lists are in each other"),
    ("long name", text(f"set {'a' * MANY} = 1\n"), [],
     "is longer than the 100000 characters"),
    ("long line that is none", text("a" * MANY), [],
     "is longer than the 100000 characters"),
    ("many lines that continue", text("set Title = a \\\n" + MANY * "a\\\n"),
     [], "is longer than the 100000 characters"),
    ("long wrong value", with_value("Time/End", "x" * 90000), [],
     "'Time/End' is 'xxx"),
    ("long wrong value of a list",
     with_value("Geometry/block/Lengths", "1, " * 30000), [],
     "'Geometry/block/Lengths' is '1, 1"),
    ("long wrong setting", BLOCK, ["Time/End=" + "x" * 90000],
     "'Time/End' is 'xxx"),
    ("setting in many sections", BLOCK, [10000 * "a/" + "a=1"],
     "in more than 64 sections"),
    ("many names", with_value("Boundary conditions/Names", ", ".join(
        f"a{i}" for i in range(10000))), [], "at most 1000 entries"),
    ("many levels", with_value("Adaptivity/Levels of tissues", ", ".join(
        f"flesh: {i} - 3" for i in range(5000))), [], "Levels of tissues'"),
    ("many points", with_value("Output/Points", ";".join(20000 * ["1,1,1"])),
     [], "is longer than the 100000 characters"),
    ("hexadecimal point", BLOCK, ["Output/Points=0x1, 0, 0"],
     "'0x1, 0, 0' is not a point"),
    ("long formula", with_value(FORMULA, "+".join(40000 * ["t"])), [],
     "it has more than 20000 characters"),
    ("many parentheses", with_value(FORMULA, 45000 * "(" + "t" + 45000 * ")"),
     [], "it has more than 20000 characters"),
    ("parentheses up to the limit",
     with_value(FORMULA, 9999 * "(" + "t" + 9000 * ")"), [],
     "cannot be read: "),
    ("conditions in each other",
     with_value(FORMULA, 2000 * "if(t>1," + "t" + 1999 * ",0)"), [],
     "cannot be read: "),
    ("more cells than there can be", BLOCK,
     ["Geometry/block/Cells=1000000000, 1, 1"], "'Geometry/block': the coarse mesh would have 1e+09 cells"),
    ("more segments than there can be", CHAIN,
     ["Geometry/segment chain/Number of segments=1000000000"],
     "'Geometry/segment chain/Number of segments'"),
    ("mesh that is a device", BLOCK,
     ["Geometry/Shape=mesh file", "Geometry/mesh file/File=/dev/zero"],
     "cannot be read"),
    ("fibres that are a device", BLOCK,
     ["Muscles/biceps/Fibres=file", "Muscles/biceps/file/File=/dev/zero"],
     "cannot be read"),
]


def limited_run(case, folder, run_of, settings):
    """A run with --check, and the seconds it took."""
    before = time.perf_counter()
    result = run_of(case, folder / "out", settings,
                    options=["--check"])
    return result, time.perf_counter() - before


def start(hostile, _ranks, folder, run_of):
    _, case, settings, _ = hostile
    folder.mkdir()
    case = folder / (case(folder) if callable(case) else case)
    return limited_run(case, folder, run_of, settings)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    # Memory: what is left to a run when all of the machine's is not.
    limits = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (6 * 2**30, limits[1]))
    try:
        return run_all(start, [(hostile, 1) for hostile in HOSTILE],
                       tmp_path_factory.mktemp("hostile"))
    finally:
        resource.setrlimit(resource.RLIMIT_AS, limits)


@pytest.mark.parametrize("i", range(len(HOSTILE)),
                         ids=[hostile[0] for hostile in HOSTILE])
def test_is_refused_at_once_with_few_words(i, results):
    result, seconds = results[i]
    assert result.exit_code == 1, result.message[:2000]
    assert len(result.message) < LONGEST_MESSAGE
    assert HOSTILE[i][3] in result.message
    assert not any(word in result.message for word in JARGON), result.message
    assert seconds < MOST_SECONDS


def test_two_ranks_say_it_once(tmp_path):
    """The file is read by every rank."""
    result = run("/dev/zero", tmp_path / "out", ranks=2, timeout=60)
    assert result.exit_code == 1
    assert result.message.count("it is a device") == 1


@pytest.mark.parametrize("option", ["--parameters", "--help", "--version",
                                    "--check"])
@pytest.mark.parametrize("output", ["/dev/full", None])
def test_what_cannot_be_printed_is_said(option, output, tmp_path):
    """The exit code was 0, and nobody had the text."""
    command = [os.environ["LUMBRICUS"], option]
    if option == "--check":
        command.append(str(BLOCK))
    # With an output that is closed, the first file opened takes its place.
    redirection = ">&-" if output is None else f">{output}"
    result = subprocess.run(
        ["sh", "-c", f'exec "$@" {redirection}', "sh", *command],
        capture_output=True, text=True, timeout=60, cwd=tmp_path)
    assert result.returncode == 1, result.stderr
    assert "Standard output cannot be written" in result.stderr
    assert not list(tmp_path.iterdir())


# Numbers that are none, or more than anything holds.
WORDS = ["", "nan", "inf", "-inf", "1e400", "-1", "0", "1e-320", "0x10", "{2}",
         "1,5", "5.", "+5", "99999999999", "true", "yes", "''", "\"", "\\",
         "#", "/", "a/b", "=", "end", "subsection x", "set x = 1", "include .",
         "t", "1/0", "sqrt(t - 2)", "\t", "\0", "\x07", "\xe4", "\ud83e",
         "x" * 20000, "1, " * 3000, "(" * 9000, "{" * 100, "[" * 100]


def mutated(content, chance):
    """The text of a case with one to three things changed."""
    lines = content.splitlines()
    for _ in range(chance.randint(1, 3)):
        i = chance.randrange(len(lines))
        kind = chance.randrange(7)
        if kind == 0:
            del lines[i]
        elif kind == 1:
            lines.insert(i, chance.choice(lines))
        elif kind == 2:  # another value
            name, equals, _ = lines[i].partition(
                "=" if "=" in lines[i] else ":")
            lines[i] = name + equals + " " + chance.choice(WORDS)
        elif kind == 3:  # another letter
            k = chance.randrange(len(lines[i]) + 1)
            lines[i] = (lines[i][:k] + chr(chance.randrange(256)) +
                        lines[i][k + 1:])
        elif kind == 4:  # a word in the middle
            k = chance.randrange(len(lines[i]) + 1)
            lines[i] = lines[i][:k] + chance.choice(WORDS) + lines[i][k:]
        elif kind == 5:  # two lines change places
            k = chance.randrange(len(lines))
            lines[i], lines[k] = lines[k], lines[i]
        else:  # cut
            lines = (lines[:i + 1] if chance.random() < 0.3 else
                     lines[:i] + [lines[i][:chance.randrange(
                         len(lines[i]) + 1)]] + lines[i + 1:])
        if not lines:
            lines = [""]
    return "\n".join(lines).encode("utf-8" if chance.random() < 0.9 else
                                   "latin-1", errors="replace")


def mutants(n, seed):
    """Names and contents of files."""
    chance = random.Random(seed)
    bases = [(path.read_text(), ".prm") for path in (
        BLOCK, CHAIN, *sorted((HERE.parent / "physics").glob("*.prm")))]
    bases += 2 * [(JSON, ".json")]
    for i in range(n):
        content, suffix = bases[i % len(bases)]
        yield f"{i}{suffix}", mutated(content, chance)


def check_mutants(folder, n, seed):
    """What is not as it should be: (file, exit code, message)."""
    cases = []
    for name, content in mutants(n, seed):
        (folder / name).write_bytes(content)
        cases.append((name, 1))

    def start_mutant(name, _ranks, _folder, run_of):
        return limited_run(folder / name, folder, run_of, [])

    return [(name, result.exit_code, result.message, seconds)
            for (name, _), (result, seconds) in zip(
                cases, run_all(start_mutant, cases, folder))
            if result.exit_code not in (0, 1) or
            len(result.message) >= LONGEST_MESSAGE or
            (result.exit_code == 1) != (result.message != "") or
            any(word in result.message for word in JARGON) or
            seconds > MOST_SECONDS]


def test_changes_at_random_are_refused_or_run(tmp_path):
    """N_MUTANTS and SEED in the environment try more, and others."""
    wrong = check_mutants(tmp_path, int(os.environ.get("N_MUTANTS", 300)),
                          int(os.environ.get("SEED", 1)))
    assert not wrong, wrong[:10]
