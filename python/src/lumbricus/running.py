# SPDX-License-Identifier: LGPL-2.1-or-later
"""Let the program compute a case, and stop it without losing what it has done."""
from __future__ import annotations

import contextlib
import ctypes
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from .case import text_of
from .errors import LumbricusError, error_of
from .program import (
    environment,
    find_program,
    message_of,
    own_session_folder,
    settings_as_options,
)
from .results import Run, read_description

if TYPE_CHECKING:
    from .case import Case

LOOK_AGAIN = 0.2  # [s]
WIDTH = 40        # of the bar, in characters
PR_SET_PDEATHSIG = 1  # of Linux' prctl()
Progress = Callable[[float, float], None]
_LIBC = ctypes.CDLL(None)


def bar(t: float, end: float, width: int = WIDTH) -> str:
    """How far a run has come, in one line.

    >>> bar(0.5, 1.0, width=8)
    '[####    ]  50 %  t = 0.5'
    """
    part = min(max(t / end, 0.0), 1.0) if end > 0 else 1.0
    full = round(part * width)
    return f"[{'#' * full}{' ' * (width - full)}] {part:4.0%}  t = {t:g}".replace(
        "%", " %")


def show_bar(t: float, end: float) -> None:
    """Write the bar on standard error, over the one before."""
    print("\r" + bar(t, end), end="\n" if t >= end else "", file=sys.stderr, flush=True)


def _where(folder: pathlib.Path) -> tuple[float, float] | None:
    """The time that the run in a folder has reached, and that of its end."""
    with contextlib.suppress(OSError, ValueError, IndexError, KeyError):
        lines = (folder / "steps.csv").read_text(encoding="utf-8").split("\n")
        return float(lines[-2].split(",")[lines[0].split(",").index("t")]), \
            float(read_description(folder)["status"]["end_time"])
    return None


def _stop_with_this_process() -> None:
    """Between fork and exec: where the Python that waits for a run dies, the run gets
    the signal at which it writes a checkpoint and ends."""
    _LIBC.prctl(PR_SET_PDEATHSIG, int(signal.SIGUSR1))


def _wait(process: subprocess.Popen[str], folder: pathlib.Path,
          progress: Progress | None, stop: threading.Event | None) -> str:
    """Until the run ends; what it said on standard error."""
    shown = None
    while True:
        try:
            _, words = process.communicate(
                timeout=LOOK_AGAIN if progress or stop else None)
            break
        except subprocess.TimeoutExpired:
            if stop and stop.is_set():
                process.send_signal(signal.SIGUSR1)
                stop = None
            where = _where(folder) if progress else None
            if progress and where and where != shown:
                progress(*where)
                shown = where
    where = _where(folder) if progress and process.returncode == 0 else None
    if progress and where and where != shown:
        progress(*where)
    return words


def _start(command: list[str], folder: pathlib.Path, ranks: int,
           progress: bool | Progress | None,
           stop: threading.Event | None = None) -> Run:
    if progress is None:
        progress = sys.stderr.isatty()
    show = show_bar if progress is True else progress or None
    if ranks > 1:
        mpirun = os.environ.get("MPIRUN") or shutil.which("mpirun") or "mpirun"
        command = [mpirun, "-np", str(ranks), *command]
    with own_session_folder() as session:
        # In a session of its own, so that Ctrl-C in the terminal comes to Python only:
        # mpirun would kill the ranks before they have a checkpoint.
        process = subprocess.Popen(
            command, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, env=environment() | {"TMPDIR": session},
            start_new_session=True, preexec_fn=_stop_with_this_process)
        try:
            words = _wait(process, folder, show, stop)
        except BaseException as error:
            _stop(process)
            if (folder / "checkpoints").is_dir():
                error.add_note(f"lumbricus.restart('{folder}') goes on.")
            raise
    if process.returncode != 0:
        raise error_of(process.returncode, message_of(words), folder)
    return Run(folder)


def _stop(process: subprocess.Popen[str]) -> None:
    """Ask a run to write a checkpoint and end, and wait for it; end it at once where
    one is impatient."""
    try:
        process.send_signal(signal.SIGUSR1)
        process.communicate()
    except BaseException:
        process.kill()
        process.communicate()
        raise


def run(case: Case, folder: str | os.PathLike[str], *, ranks: int = 1,
        progress: bool | Progress | None = None,
        settings: Mapping[str, object] | None = None,
        stop: threading.Event | None = None) -> Run:
    """Compute a case, and wait for its end.

    Args:
        case: what to compute.
        folder: for the results; a run that was there is replaced.
        ranks: processes of MPI.
        progress: True for a bar on standard error, the default on a terminal; or a
            function of the time that was reached and that of the end, which is called
            when that has changed, at most five times a second.
        settings: further changes to the case, looked at when the run begins.
        stop: set by another thread, it ends the run as a signal does.

    Returns the finished run.

    Raises InputError, RunFailed or Interrupted, with the program's message. At
    KeyboardInterrupt, or where progress() raises anything, the run writes a checkpoint
    and ends before the exception goes on: ``restart(folder)`` then goes on with the run.
    A second KeyboardInterrupt ends it at once.
    """
    path = pathlib.Path(folder).absolute()
    changes = case.settings | {name: text_of(value)
                               for name, value in (settings or {}).items()}
    # A bar that begins where an earlier run has ended would be wrong.
    if progress is None:
        progress = sys.stderr.isatty()
    if progress:
        progress = _after(path, show_bar if progress is True else progress)
    return _start([str(case.program), str(case.file), "--output", str(path), "--quiet",
                   *settings_as_options(changes.items())], path, ranks, progress, stop)


def _after(folder: pathlib.Path, progress: Progress) -> Progress:
    """The same, without what the table of an earlier run says."""
    def mark() -> tuple[int, int] | None:
        with contextlib.suppress(FileNotFoundError):
            now = (folder / "steps.csv").stat()
            return now.st_ino, now.st_mtime_ns
        return None

    before = mark()

    def of_this_run(t: float, end: float) -> None:
        if mark() != before:
            progress(t, end)
    return of_this_run


def restart(folder: str | os.PathLike[str], settings: Mapping[str, object] | None = None,
            *, ranks: int = 1, progress: bool | Progress | None = None,
            program: str | os.PathLike[str] | None = None) -> Run:
    """Let the run in a folder go on from its last checkpoint: one that was interrupted,
    or, with settings={"Time/End": 2}, one that has come to its end.

    Arguments, exceptions: as those of run().
    """
    path = pathlib.Path(folder).absolute()
    options = settings_as_options((name, text_of(value))
                                  for name, value in (settings or {}).items())
    return _start([str(program or find_program()), "--restart", str(path), "--quiet",
                   *options], path, ranks, progress)


def wait_until_free(folder: pathlib.Path, seconds: float = 60.0) -> None:
    """Until no run owns a folder, as one that was told to stop a moment ago.

    Raises LumbricusError.
    """
    again = threading.Event()
    for _ in range(int(seconds / LOOK_AGAIN)):
        if not (folder / "lumbricus.lock").exists():
            return
        again.wait(LOOK_AGAIN)
    raise LumbricusError(f"A run goes on in '{folder}': see lumbricus.lock there.",
                         folder=folder)
