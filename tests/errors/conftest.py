# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs here are many and tiny: most of each is the start of the program,
which starts itself anew to choose the fastest BLAS kernels where this is not
set, and that of MPI, which looks for networks, starts a daemon, and gives ranks
a second to die after one has failed. These tests do without. What is read by
the launcher has another name since Open MPI 5."""
import os

for name, value in {
        "OPENBLAS_CORETYPE": "",
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "OMPI_MCA_ess_singleton_isolated": "1",
        "OMPI_MCA_odls_base_sigkill_timeout": "0",
        "PRTE_MCA_odls_base_sigkill_timeout": "0",
        "OMPI_MCA_pml": "ob1",
        "OMPI_MCA_btl": "self,vader"}.items():
    os.environ.setdefault(name, value)
