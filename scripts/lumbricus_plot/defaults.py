# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parameters of a run differ from their defaults, which are those that
doc/parameters.md lists."""

import html
import pathlib
import re

REFERENCE = (pathlib.Path(__file__).resolve().parents[2] / "doc"
             / "parameters.md")


def read_reference(file_name=REFERENCE):
    """{(section, ..., name): (default, unit)}; empty where there is no file."""
    try:
        text = file_name.read_text(encoding="utf-8")
    except OSError:
        return {}
    found, section = {}, ()
    for line in text.splitlines():
        if line.startswith("##"):
            title = html.unescape(line.lstrip("#").strip())
            section = (() if title == "At the top" else
                       tuple(part.strip() for part in title.split(" / ")))
        elif line.startswith("| ") and not line.startswith("| Parameter |"):
            cells = [html.unescape(cell.strip())
                     for cell in line.strip().strip("|").split("|")]
            if len(cells) >= 3:
                found[section + (cells[0],)] = (cells[1].strip("`"), cells[2])
    return found


def reference_of(path, reference):
    """(default, unit) of a parameter, None where the reference has none. A
    name in angle brackets stands for any."""
    if path in reference:
        return reference[path]
    for candidate, entry in reference.items():
        if len(candidate) == len(path) and all(
                a == b or re.fullmatch("<.*>", a)
                for a, b in zip(candidate, path)):
            return entry
    return None


def equal(value, default):
    """Whether two values are the same, numbers by what they are worth."""
    def parts(text):
        found = []
        for part in re.split(r"[\s,;]+", text.strip()):
            try:
                found.append(float(part))
            except ValueError:
                found.append(part)
        return found

    return parts(value) == parts(default)


def parameters_with_defaults(parameters, reference):
    """(name, value, default, unit) of all; default and unit are None where
    they are not known."""
    return [(name, value, *(reference_of(tuple(name.split("/")), reference)
                            or (None, None)))
            for name, value in parameters.items()]


def that_differ(rows):
    return [row for row in rows if row[2] is None or not equal(row[1], row[2])]
