# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library without debug info has none.

LUMBRICUS_DEBUG_INFO=OFF once had no effect: deal.II's -g came after the -g0,
and the library had 168 MB, of which 163 were debug info; it has 5 without."""
import os
import pathlib
import subprocess

LIBRARY = pathlib.Path(os.environ["LIBRARY"])


def sections():
    """The names of all sections of the library."""
    text = subprocess.run(["readelf", "--section-headers", "--wide", LIBRARY],
                          capture_output=True, text=True, check=True).stdout
    return {line.split("]")[1].split()[0] for line in text.splitlines()
            if line.strip().startswith("[") and "]" in line and
            not line.strip().startswith("[Nr]")}


def test_no_debug_info():
    found = sections()
    assert ".text" in found and ".dynsym" in found
    assert not {name for name in found if "debug" in name}


def test_size():
    assert LIBRARY.stat().st_size < 20e6
