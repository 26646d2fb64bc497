# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the program starts: what it is called, and who reads its arguments."""
import os
import pathlib
import signal
import subprocess
import time

import pytest
from lumbricus_run import children_of, run_well

# Here it is the program itself that starts.
os.environ.pop("LOADED", None)

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"


def start_anew(*arguments, ranks=1):
    """A run in an environment that makes it start itself anew."""
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS",
                                   "OPENBLAS_CORETYPE")}
    mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
    return subprocess.Popen(
        [*(mpirun if ranks > 1 else []), os.environ["LUMBRICUS"],
         *map(str, arguments)], env=environment, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True)


def processes_called(name):
    """As pgrep -x finds them; ps and pkill look at the same."""
    found = set()
    for file in pathlib.Path("/proc").glob("[0-9]*/comm"):
        try:
            if file.read_text() == name + "\n":
                found.add(int(file.parent.name))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_process_keeps_its_name(tmp_path, ranks):
    """After it had started itself anew the process was called 'exe':
    'pkill -USR1 lumbricus', as the README has it for a checkpoint, found
    nothing."""
    out = tmp_path / "out"
    process = start_anew(
        BLOCK, "--output", out, "--set", "Checkpoints/Steps=1",
        "--set", "Time/First step=1e-3", "--set", "Time/Largest step=1e-3",
        ranks=ranks)
    ours = set()
    try:
        end = time.time() + 60
        while not (out / "checkpoints").exists():
            assert process.poll() is None, process.communicate()
            assert time.time() < end
            time.sleep(0.01)
        family = {process.pid} if ranks == 1 else set(children_of(process.pid))
        ours = processes_called("lumbricus") & family
        assert len(ours) == ranks, family
        # What Open MPI keeps for the run is in a folder of these tests alone, in
        # which its sockets have room for their names.
        if ranks > 1:
            session = os.environ["TMPDIR"]
            assert os.listdir(session) and len(session) < 20
        for pid in ours:
            # Started anew, with the arguments as they were.
            status = pathlib.Path(f"/proc/{pid}")
            assert b"OPENBLAS_NUM_THREADS=1" in (status / "environ").read_bytes()
            assert (status / "cmdline").read_bytes().startswith(
                os.environ["LUMBRICUS"].encode() + b"\0" + str(BLOCK).encode())
            os.kill(pid, signal.SIGUSR1)
        said = process.communicate(timeout=60)
        assert process.returncode == 4, said
    finally:
        for pid in ours:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        if process.poll() is None:
            process.kill()
        process.communicate()


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_arguments_are_ours_alone(tmp_path, monkeypatch, ranks):
    """deal.II hands the arguments of main() on to PETSc, Zoltan and Kokkos.
    PETSc of Debian 13 warned of '--output', which it does not know, at the end
    of every run, and everywhere it takes options of its own: with the folder
    '-log_view' for the results it wrote pages about its performance."""
    monkeypatch.chdir(tmp_path)
    result = run_well(BLOCK, "-log_view", ranks=ranks,
                      options=["--quiet"])
    assert (tmp_path / "-log_view" / "segments.csv").exists()
    assert result.log == "" and result.message == ""


def test_the_libraries_have_no_help(tmp_path):
    """'--kokkos-help' printed the help of Kokkos, and then that it is
    unknown."""
    process = subprocess.run([os.environ["LUMBRICUS"], "--kokkos-help"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert process.stdout == ""
    assert "'--kokkos-help' is unknown" in process.stderr
    assert len(process.stderr.strip().splitlines()) < 4
