# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Controller of the package lumbricus (python/), for programs that have scripts/
on their path and do without an installation."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python" / "src"))
from lumbricus.controller import Controller as Controller  # noqa: E402
