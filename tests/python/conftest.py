# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package of this checkout, whether it is installed or not."""
import sys

from lumbricus_run import SOURCE

sys.path.insert(0, str(SOURCE / "python" / "src"))
