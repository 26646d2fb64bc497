# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program as most tests start it: with its libraries loaded already, by one
process for all runs of a file of tests (starts/loaded.cc). A run as users start
it takes half a second for that alone; what a start itself, a kill or a signal
comes to is tested with such.

The two programs come from the environment variables LOADED and STARTER, which
ctest sets; without them every run is as usual."""
import atexit
import functools
import os
import pathlib
import subprocess
import tempfile


# The program starts itself anew to choose the fastest BLAS kernels where the first
# is not set; MPI starts a daemon and looks for networks. Most tests do without; all
# is as for users in the tests of signals and in those of reference outputs.
QUICK_START = {"OPENBLAS_CORETYPE": "", "OMP_NUM_THREADS": "1",
               "OPENBLAS_NUM_THREADS": "1",
               "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1",
               "OMPI_MCA_btl": "self,vader"}


@functools.lru_cache(maxsize=None)
def loaded_program():
    """What is to be called in the place of the program."""
    if "LOADED" not in os.environ:
        return os.environ["LUMBRICUS"]
    place = pathlib.Path(tempfile.mkdtemp(prefix="s", dir="/tmp")) / "s"
    process = subprocess.Popen([os.environ["LOADED"], str(place)],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def end():
        process.stdin.close()
        process.wait()
        place.unlink(missing_ok=True)
        place.parent.rmdir()

    atexit.register(end)
    assert process.stdout.readline(), "the program cannot be loaded"
    os.environ["STARTED_BY"] = str(place)
    return os.environ["STARTER"]
