# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every notebook runs to its end."""
import os
import subprocess
import sys

import pytest
from lumbricus_run import SOURCE

NOTEBOOKS = sorted((SOURCE / "python" / "notebooks").glob("*.py"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(notebook):
    process = subprocess.run(
        [sys.executable, str(notebook)], cwd=SOURCE, text=True, capture_output=True,
        env=os.environ | {"PYTHONPATH": str(SOURCE / "python" / "src"),
                          "MPLBACKEND": "Agg"})
    assert process.returncode == 0, process.stdout + process.stderr
    assert "Found " in process.stdout
