# SPDX-License-Identifier: LGPL-2.1-or-later
"""What writes the site, and the package of this checkout."""
import sys

from lumbricus_run import SOURCE

sys.path[:0] = [str(SOURCE / "doc" / "site"), str(SOURCE / "python" / "src")]
