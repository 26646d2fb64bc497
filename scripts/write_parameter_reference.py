#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turn what `lumbricus --parameters` prints into Markdown, from standard input
to standard output: a heading per section, a table of its parameters."""

import re
import sys

HEAD = """# Parameters

All parameters of a parameter file, with their defaults. Units are in brackets;
`[-]` and `[1]` are numbers without one. A name in angle brackets stands for
names of your own. A section is declared when the file asks for it: that of the
law, the fibres or the load that was chosen, one for every tissue and muscle
that has been named. Setting a parameter that nothing would read is an error.
A file is text in UTF-8, with at most 100,000 characters a line, 100 a name and
64 sections in each other; with those it includes it has at most 16 MiB.

On the command line, `--set "Section/Subsection/Name=value"` sets one.

This page is written by `scripts/write_parameter_reference.sh`.
"""


def escaped(text):
    return text.replace("|", "\\|").replace("<", "&lt;").replace(">", "&gt;")


def parse(text):
    """(path of the section, its comment, [(name, default, comment)]) of all
    sections, in the order of the text."""
    # The frame deal.II puts around the list.
    lines = [line for line in text.splitlines()
             if line not in ("# Listing of Parameters",
                             "# ---------------------")]
    sections = {(): ("", [])}
    path, comment = (), []
    for line in lines:
        line = line.strip()
        if line.startswith("#"):
            comment.append(line.lstrip("#").strip())
            continue
        if line.startswith("subsection "):
            path += (line[len("subsection "):],)
            sections[path] = (" ".join(comment), [])
        elif line == "end":
            path = path[:-1]
        elif line.startswith("set "):
            name, _, default = line[len("set "):].partition("=")
            sections[path][1].append(
                (name.strip(), default.strip(), " ".join(comment)))
        comment = []
    return [(path, *content) for path, content in sections.items()]


def entries(parameters):
    yield "| Parameter | Default | Unit | Meaning |"
    yield "|---|---|---|---|"
    for name, default, comment in parameters:
        unit, text = re.fullmatch(r"(?:\[(.*?)\]\s*)?(.*)", comment).groups()
        value = f"`{default}`" if default else ""
        yield (f"| {escaped(name)} | {value} | {escaped(unit or '')} "
               f"| {escaped(text)} |")


def main():
    sections = parse(sys.stdin.read())
    print(HEAD)
    for path, comment, parameters in sections:
        if not path:
            print("## At the top\n")
        else:
            level = min(2 + len(path) - 1, 4)
            print("#" * level, escaped(" / ".join(path)) + "\n")
        if comment:
            print(escaped(comment) + "\n")
        if parameters:
            print("\n".join(entries(parameters)) + "\n")
        elif not any(other[:len(path)] == path and other != path
                     for other, _, _ in sections):
            print("No parameters.\n")


if __name__ == "__main__":
    main()
