# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that says what the muscles of a run do, while it goes on: make a class
of your own of Controller, with a step(), and let it serve() at the address that is
the muscles' 'server/Address'. See doc/controllers.md. Needs Python and nothing
else."""
from __future__ import annotations

import contextlib
import json
import os
import pathlib
import socket
import tempfile
from typing import Any


class Controller:
    """Answers before every load step."""

    def step(self, t: float, dt: float,
             segments: list[dict[str, Any]]) -> dict[str, Any]:
        """What the muscles do at time t + dt, which the body will have reached
        after the next load step: {"muscle": [a number for each segment], ...}, or
        one number for all. "largest_dt" may be there too: no step is longer.

        segments are how the segments are at time t, from the head on: a list of
        dictionaries with "segment" (from 1), "length", "radius", "pressure",
        "fluid_volume" and "contact" (the force with which obstacles press).

        The same t may come again, with a smaller dt: then the step did not
        converge. So what is said should depend on t and the segments, not on how
        often there was a question.
        """
        raise NotImplementedError

    def serve(self, address: str | os.PathLike[str]) -> None:
        """Wait for a run at a Unix socket, whose file is made here and removed at
        the end, and answer until the run is over."""
        # The name appears when a run can connect: made beside, then renamed.
        path = pathlib.Path(address)
        beside = pathlib.Path(tempfile.mktemp(prefix=".", dir=path.parent))
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(str(beside))
            listener.listen(1)
            os.replace(beside, path)
            try:
                connection, _ = listener.accept()
            finally:
                with contextlib.suppress(FileNotFoundError):
                    path.unlink()
        # A run that has ended meanwhile does not want its answer: neither when it is
        # written, nor when what was not sent is, at the end.
        with (contextlib.suppress(BrokenPipeError, ConnectionResetError),
              connection,
              connection.makefile("rw", encoding="utf-8", newline="\n") as lines):
            for line in lines:
                asked = json.loads(line)
                answer = self.step(asked["t"], asked["dt"], asked["segments"])
                lines.write(json.dumps(answer) + "\n")
                lines.flush()
