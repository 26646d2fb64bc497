# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every test runs.

test_linear_solvers was in no CMakeLists.txt, and so it was run by nobody for as long
as it was there."""
import re

from lumbricus_run import SOURCE

TESTS = SOURCE / "tests"


def test_every_test_is_registered():
    found = sorted(TESTS.glob("*/test_*.py"))
    assert len(found) > 50
    missing = [str(path.relative_to(TESTS)) for path in found
               if not re.search(rf"^[^#\n]*\b{path.stem}\b",
                                (path.parent / "CMakeLists.txt").read_text(),
                                re.MULTILINE)]
    assert not missing


def test_every_unit_test_is_registered():
    listed = (TESTS / "unit" / "CMakeLists.txt").read_text()
    found = [path.stem for path in (TESTS / "unit").glob("*.cc")
             if "TEST" in path.read_text()]
    assert len(found) > 15
    assert not [name for name in found if not re.search(rf"\b{name}\b", listed)]
