# SPDX-License-Identifier: LGPL-2.1-or-later
"""Data flow one way: a folder includes only those above it in the table of
doc/structure.md, and headers beside a source are included from their folder only."""
import re

from lumbricus_run import SOURCE

# A continuation makes steps with the model of a run.
KNOWN = {("continuation", "program")}


def layers():
    """The number of the line of each folder."""
    text = (SOURCE / "doc" / "structure.md").read_text()
    table = text.split("| Folders | What |")[1].split("\n\n")[0]
    lines = [re.findall(r"`(\w+)`", line.split("|")[1])
             for line in table.splitlines()[2:]]
    return {folder: number for number, line in enumerate(lines) for folder in line}


def files():
    for base in ("include/lumbricus", "source"):
        for path in sorted((SOURCE / base).glob("*/**/*.[hc]*")):
            yield path.relative_to(SOURCE / base).parts[0], path


def test_a_folder_includes_only_those_above_it():
    level = layers()
    assert {folder for folder, _ in files()} == set(level)
    wrong = {(folder, other)
             for folder, path in files()
             for other in re.findall(r"#include <lumbricus/(\w+)/", path.read_text())
             if level[other] > level[folder]}
    assert wrong == KNOWN


def test_private_headers_stay_private():
    n = 0
    for folder, path in files():
        for name in re.findall(r'#include "([^"]+)"', path.read_text()):
            place = (path.parent / name).resolve()
            assert place.is_file(), (path, name)
            assert place.relative_to(SOURCE / "source").parts[0] == folder
            n += 1
    assert n > 30


def test_public_headers_are_for_others():
    """Those that only their own folder includes lie beside their source."""
    users = {}
    for base in ("include", "source", "tests", "examples", "benchmarks"):
        for path in (SOURCE / base).rglob("*.[hc]*"):
            if path.suffix in (".h", ".cc", ".prm"):
                for name in re.findall(r"#include <lumbricus/(\S+)>", path.read_text()):
                    users.setdefault(name, set()).add(path)
    headers = sorted((SOURCE / "include/lumbricus").rglob("*.h"))
    assert len(headers) > 100
    for header in headers:
        name = str(header.relative_to(SOURCE / "include/lumbricus"))
        folder = SOURCE / "source" / name.split("/")[0]
        assert any(folder not in path.parents for path in users.get(name, ())), name
