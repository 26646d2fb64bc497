# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open MPI gives ranks a second to die after one has failed, as most of the runs
here do. These tests do without. What is read by the launcher has another name
since Open MPI 5."""
import os

for name in ("OMPI_MCA_odls_base_sigkill_timeout",
             "PRTE_MCA_odls_base_sigkill_timeout"):
    os.environ.setdefault(name, "0")
