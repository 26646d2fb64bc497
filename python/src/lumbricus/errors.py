# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program says when a run does not come to its end."""
from __future__ import annotations

import pathlib
import signal

ENDING_SIGNALS = {signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1}


class LumbricusError(Exception):
    """The message of the program, its exit code, and the folder of the run.

    Attributes:
        message: the program's own words, without its name.
        exit_code: see ``lumbricus --help``; None where the program did not run.
        folder: of the results so far, or None.
    """

    def __init__(self, message: str, exit_code: int | None = None,
                 folder: pathlib.Path | None = None) -> None:
        super().__init__(message)
        self.message = message
        self.exit_code = exit_code
        self.folder = folder

    def __reduce__(self) -> tuple[type[LumbricusError], tuple[object, ...]]:
        return type(self), (self.message, self.exit_code, self.folder)


class ProgramNotFound(LumbricusError):
    """There is no program to run."""


class InputError(LumbricusError):
    """Exit code 1: the input is wrong, nothing was computed."""


class RunFailed(LumbricusError):
    """Exit code 2, or any other end: the last good state is in the folder."""


class Interrupted(LumbricusError):
    """Exit code 4: a signal ended the run; ``restart(folder)`` goes on."""


def error_of(exit_code: int, message: str,
             folder: pathlib.Path | None = None) -> LumbricusError:
    """The exception for an exit code that is not 0.

    >>> type(error_of(1, "Radus is unknown")).__name__
    'InputError'
    >>> type(error_of(-9, "killed")).__name__
    'RunFailed'
    >>> type(error_of(-signal.SIGUSR1, "")).__name__
    'Interrupted'
    """
    kinds: dict[int, type[LumbricusError]] = {1: InputError, 4: Interrupted}
    if -exit_code in ENDING_SIGNALS:
        # Before the program listens to signals, which is nearly at once.
        return Interrupted(message or "A signal ended the run before it had begun.", 4,
                           folder)
    if not message:
        message = f"The program ended with exit code {exit_code} and said nothing."
    return kinds.get(exit_code, RunFailed)(message, exit_code, folder)
