# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs here are many and tiny: most of each is the start of the program,
which starts itself anew to choose the fastest BLAS kernels where this is not
set. These tests do without."""
import os

os.environ.setdefault("OPENBLAS_CORETYPE", "")
