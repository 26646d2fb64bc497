# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts without what takes time and is not tested, and a folder for temporary
files of its own for what the tests start.

Open MPI keeps its session in a folder that all runs of a user share. Where one
run ends, and removes it, while another starts, that one does not find what it
has just made: two of 2,800 starts failed so; runs side by side have each its own,
by lumbricus_run.start(). The path is short, as sockets want
it: they lie in that folder."""
import atexit
import os
import shutil
import tempfile

from loaded_program import QUICK_START

for name, value in QUICK_START.items():
    os.environ.setdefault(name, value)

# Where pytest itself leaves its files: there they can be looked at afterwards.
tempfile.gettempdir()
os.environ["TMPDIR"] = tempfile.mkdtemp(prefix="t", dir="/tmp")
atexit.register(shutil.rmtree, os.environ["TMPDIR"], ignore_errors=True)
