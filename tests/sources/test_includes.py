# SPDX-License-Identifier: LGPL-2.1-or-later
"""Headers are included, not hoped for.

With deal.II 9.6 <mark_where.h> lost dealii::Utilities::MPI, and with 9.7
<extrusion.cc> lost dealii::CellData: both had come with some other header of
deal.II, which stopped to bring them. Compilers drop such gifts in the same way
from one version to the next. No compiler of today shows it, so each name is
looked up: its header has to come from this project's own files, named by the
file that uses it or by a header of ours that this includes. What only a header
of deal.II or of the standard library brings does not count.

headers_of_names.txt knows the header of each name; one that it lacks is an
error too."""
import pathlib
import re

from lumbricus_run import SOURCE

HERE = pathlib.Path(__file__).resolve().parent
FOLDERS = ("include", "source", "examples", "tests", "benchmarks")
FILES = sorted(path for folder in FOLDERS
               for path in (SOURCE / folder).rglob("*")
               if path.suffix in (".h", ".cc"))
NAME = re.compile(r"\b((?:dealii|std)(?:::\s*[A-Za-z_]\w*)+)")
# Macros and the functions of MPI belong to no namespace.
MACROS = {
    re.compile(r"\b(Assert\w*|DeclException\w*)\("): ["deal.II/base/exceptions.h"],
    re.compile(r"\b(MPI_[A-Z]\w+)"): ["deal.II/base/mpi.h", "mpi.h"],
    re.compile(r"\b(DEAL_II_\w+)"): ["deal.II/base/config.h"]}


def read_table():
    table = {}
    for line in (HERE / "headers_of_names.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, headers = line.split(": ")
            assert name not in table, name
            table[name] = headers.split()
    return table


TABLE = read_table()


def code_of(text):
    """The text without comments and without what strings say."""
    return re.sub(
        r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'',
        lambda match: '""' if match[0][0] == '"' else " ", text, flags=re.S)


def includes_of(text):
    return re.findall(r'^#include ["<]([^">]+)[">]', text, flags=re.M)


def reachable(path, includes):
    """All headers that a file includes itself or by headers of ours."""
    found, todo = set(), [path]
    while todo:
        here = todo.pop()
        for header in includes[here]:
            if header in found:
                continue
            found.add(header)
            for ours in (SOURCE / "include" / header, (here.parent / header)):
                ours = ours.resolve()
                if ours in includes:
                    todo.append(ours)
    return found


def headers_of(name):
    """Where a name is declared: that of the longest beginning in the table."""
    parts = name.split("::")
    for n in range(len(parts), 1, -1):
        headers = TABLE.get("::".join(parts[:n]))
        if headers:
            return headers
    return None


def missing_headers(files):
    """Each name that a file has no header of, and each that is unknown."""
    includes = {path: includes_of(text) for path, text in files.items()}
    faults = []
    for path, text in files.items():
        code = code_of(text)
        here = reachable(path, includes)
        wanted = {}
        for name in NAME.findall(code):
            name = "".join(name.split())
            wanted[name] = headers_of(name)
        for macro, headers in MACROS.items():
            for name in macro.findall(code):
                wanted[name] = headers
        # Not a name but a namespace, of which names are used elsewhere.
        for name in re.findall(r"\bnamespace(?: \w+ =)? (dealii[\w:]*)", code):
            wanted.pop(name, None)
        for name, headers in sorted(wanted.items()):
            if headers is None:
                faults.append(f"{path}: {name} is not in headers_of_names.txt")
            elif here.isdisjoint(headers):
                faults.append(f"{path}: {name} needs <{headers[0]}>")
    return faults


def test_each_name_has_its_header():
    files = {path: path.read_text() for path in FILES}
    assert len(files) > 200
    faults = missing_headers(files)
    assert not faults, "\n".join(
        fault.replace(str(SOURCE) + "/", "") for fault in faults)


def test_the_faults_of_old_are_found():
    """The two files as they were."""
    place = SOURCE / "source" / "old.cc"
    for text, fault in (
            ("#include <deal.II/distributed/tria.h>\n"
             "int n = dealii::Utilities::MPI::sum(1, comm);",
             "dealii::Utilities::MPI::sum needs <deal.II/base/mpi.h>"),
            ("#include <deal.II/grid/tria.h>\n"
             "dealii::CellData<3> cell;",
             "dealii::CellData needs <deal.II/grid/tria_description.h>"),
            ("#include <deal.II/base/point.h>\n// dealii::Tensor\n"
             'const char *s = "std::map"; dealii::Point<3> X;', None),
            ("dealii::Nonsense x;",
             "dealii::Nonsense is not in headers_of_names.txt")):
        faults = missing_headers({place: text})
        assert faults == ([f"{place}: {fault}"] if fault else [])
