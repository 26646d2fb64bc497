# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run that is drawn again and again while it goes on."""

import errno
import fcntl
import os
import pathlib
import struct
import time
from collections.abc import Callable, Iterator
from typing import Any

from .run_folder import PlotError
from .tables import DESCRIPTION, read_description

LOCK = "lumbricus.lock"
# What tells that there is something new.
WATCHED = (DESCRIPTION, "segments.csv", "solution.pvd")
LOOK_EVERY = 0.2        # seconds
# The kernel's record of a lock, struct flock, with the two bytes that runs lock.
N_BYTES_OF_LOCK = 2


def is_locked(folder: pathlib.Path) -> bool:
    """Whether a process that lives writes to the folder. Its lock goes with it,
    however it ends."""
    try:
        file = os.open(folder / LOCK, os.O_RDONLY | os.O_NOFOLLOW)
    except OSError:
        return False
    try:
        wanted = struct.pack("hhqqi", fcntl.F_WRLCK, os.SEEK_SET, 0,
                             N_BYTES_OF_LOCK, 0)
        answer = fcntl.fcntl(file, fcntl.F_OFD_GETLK, wanted)
        return bool(struct.unpack("hhqqi", answer)[0] != fcntl.F_UNLCK)
    except OSError as error:
        # A file system without locks: only run.json says that a run has ended.
        return error.errno in (errno.EINVAL, errno.ENOLCK, errno.ENOTSUP)
    finally:
        os.close(file)


def state_of(folder: pathlib.Path) -> str:
    """As in run.json, "killed" where nobody is left who would write it anew, and
    "none" before a run has begun."""
    # The lock comes first and goes last. That it is gone counts when it is seen twice.
    for pause in (LOOK_EVERY, 0.):
        locked = is_locked(folder)
        try:
            state = str(read_description(folder)["status"]["state"])
        except (OSError, ValueError, KeyError, TypeError):
            return "none"
        if state != "running" or locked:
            return state
        time.sleep(pause)
    return "killed"


def signature(folder: pathlib.Path) -> list[tuple[int, int] | None]:
    """What changes when the run has written."""
    def of(name: str) -> tuple[int, int] | None:
        try:
            status = os.stat(folder / name)
        except OSError:
            return None
        return status.st_mtime_ns, status.st_size

    return [of(name) for name in WATCHED]


def changes(folder: pathlib.Path, pause: float,
            look_every: float = LOOK_EVERY) -> Iterator[str]:
    """The state of the run whenever it has written something new, and last its state
    at its end. Between two times are so many seconds, and at least as many as were
    used for the one before, so that whoever draws leaves half of a core to others."""
    before: Any = None
    while True:
        state = state_of(folder)
        if state not in ("running", "none"):
            yield state
            return
        now = signature(folder)
        begun = time.monotonic()
        if state == "running" and now != before:
            before = now
            yield state
        used = time.monotonic() - begun
        # Its end is noticed at once.
        until = time.monotonic() + (max(pause, used) if used > 0.01 else look_every)
        while time.monotonic() < until and state_of(folder) in ("running", "none"):
            time.sleep(look_every)


def watch(folder: pathlib.Path, pause: float, draw: Callable[[str], None]) -> str:
    """draw(state) whenever the run has something new, and once after its end; how it
    ended. While it goes on there may be nothing to draw yet.

    Raises PlotError where there is nothing to draw when it has ended.
    """
    state = ""
    for state in changes(folder, pause):
        try:
            draw(state)
        except (PlotError, FileNotFoundError):
            # No load step yet, or a file that a new start has just removed.
            if state != "running":
                raise
    return state
