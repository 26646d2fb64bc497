# SPDX-License-Identifier: LGPL-2.1-or-later
"""No two classes have one name.

Two plug-ins, a field and a boundary condition, were both classes Displacement of
namespace lumbricus, each in its own source. Neither compiler nor linker says a word:
the functions of one were called for objects of the other, and the program crashed at
its start."""
import collections
import re

from lumbricus_run import SOURCE

CLASS = re.compile(r"^  (?:class|struct) (\w+)(?: final)?(?: :.*|)$", re.MULTILINE)


def test_every_class_has_its_own_name():
    places = collections.defaultdict(list)
    for folder in ("include", "source"):
        for path in sorted((SOURCE / folder).rglob("*.[hc]*")):
            # Those in unnamed namespaces are farther to the right.
            for match in CLASS.finditer(path.read_text()):
                places[match[1]].append(str(path.relative_to(SOURCE)))
    assert len(places) > 150
    twice = {name: paths for name, paths in places.items() if len(paths) > 1}
    assert not twice, twice
