# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the program, and start it as its scripts do."""
from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Sequence

from .errors import ProgramNotFound

BUILT = pathlib.Path("build-Release") / "lumbricus"


def find_program() -> pathlib.Path:
    """The program that the environment variable LUMBRICUS names, else that of the
    checkout which this package or the working directory lies in, else that on PATH.

    Raises ProgramNotFound.
    """
    named = os.environ.get("LUMBRICUS")
    if named:
        found = shutil.which(named)
        if found is None:
            raise ProgramNotFound(f"LUMBRICUS is '{named}', which is no program.")
        return pathlib.Path(found).absolute()
    here = pathlib.Path(__file__).resolve()
    for folder in (*here.parents, pathlib.Path.cwd(), *pathlib.Path.cwd().parents):
        if (folder / BUILT).is_file():
            return folder / BUILT
    found = shutil.which("lumbricus")
    if found is None:
        raise ProgramNotFound(
            "The program 'lumbricus' was found neither in build-Release of a checkout "
            "nor on PATH. Build it with scripts/main_job.sh, or let the environment "
            "variable LUMBRICUS name it.")
    return pathlib.Path(found)


def environment() -> dict[str, str]:
    """What Open MPI and the BLAS need to know, as in scripts/environment.sh, beside
    what the environment says: where it says something else, that holds."""
    wanted = {
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
        "OMPI_MCA_hwloc_base_binding_policy": "none",
        "PRTE_MCA_hwloc_default_binding_policy": "none",
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    if os.geteuid() == 0:
        wanted |= {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    return wanted | dict(os.environ)


def own_session_folder() -> tempfile.TemporaryDirectory[str]:
    """A folder for Open MPI's session: one that runs share is removed by the run that
    ends first. The path is short, as sockets want it."""
    return tempfile.TemporaryDirectory(prefix="l", dir="/tmp", ignore_cleanup_errors=True)


def settings_as_options(settings: Iterable[tuple[str, str]]) -> list[str]:
    """
    >>> settings_as_options([("Time/End", "2")])
    ['--set', 'Time/End=2']
    """
    return [word for name, value in settings for word in ("--set", f"{name}={value}")]


def message_of(words: str) -> str:
    """What the program said on standard error, without its name, and without the
    paragraphs between lines of dashes that mpirun adds.

    >>> message_of("\\nlumbricus: 'Radus' is unknown.\\n")
    "'Radus' is unknown."
    """
    words = re.sub("^-{60,}\n.*?^-{60,}(\n|$)", "", words,
                   flags=re.MULTILINE | re.DOTALL)
    return words.strip().removeprefix("lumbricus: ")


def call(program: pathlib.Path,
         arguments: Sequence[str]) -> subprocess.CompletedProcess[str]:
    """Run the program on one rank until its end."""
    with own_session_folder() as folder:
        return subprocess.run(
            [str(program), *arguments], text=True, capture_output=True, check=False,
            stdin=subprocess.DEVNULL, env=environment() | {"TMPDIR": folder})
