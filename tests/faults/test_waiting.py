# SPDX-License-Identifier: LGPL-2.1-or-later
"""A signal while a run waits for its controller: the run ends at once, with a
checkpoint and exit code 4, long before the controller is late. And a run that goes on
from there asks a new controller."""
import os
import signal
import subprocess
import threading
import time

import pytest
from controlled_run import Controller, controlled, serving
from faults import checkpoints, ranks_of, start
from lumbricus_run import SOURCE, go_on

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
SOON = 10  # [s], where a controller has an hour


class Silent(Controller):
    """Answers the first question, and then none until it is let go."""

    def __init__(self):
        self.asked = []
        self.is_silent = threading.Event()
        self.let_go = threading.Event()

    def step(self, t, dt, segments):
        self.asked.append(t)
        if len(self.asked) > 1:
            self.is_silent.set()
            self.let_go.wait(120)
        return {"biceps": 0.95}


# A controller whose answer comes too late ends without an error, too.
@pytest.mark.filterwarnings("error::pytest.PytestUnhandledThreadExceptionWarning")
@pytest.mark.parametrize("sent, ranks", [
    (signal.SIGTERM, 1), (signal.SIGUSR1, 1), (signal.SIGTERM, 2),
    (signal.SIGUSR1, 2)])
def test_a_signal_while_a_run_waits(tmp_path, sent, ranks):
    folder = tmp_path / "out"
    controller = Silent()
    with serving(controller) as address:
        settings = [*controlled(["biceps"], address),
                    "Muscles/biceps/server/Late after=3600", "Checkpoints/Steps=0"]
        process = start(ranks, BLOCK, "--output", folder, *(
            word for setting in settings for word in ("--set", setting)))
        try:
            assert controller.is_silent.wait(60), process.communicate()
            began = time.time()
            # To mpirun, which passes it on; SIGTERM as a batch system sends it.
            for pid in (ranks_of(process) if sent == signal.SIGTERM else
                        [process.pid]):
                os.kill(pid, sent)
            out, err = process.communicate(timeout=SOON)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
        finally:
            controller.let_go.set()
        assert time.time() - began < SOON
    assert process.returncode == 4, out + err
    assert f"Interrupted by {sent.name}" in err
    assert f"--restart '{folder}'" in err
    # The step that was done, and no second one.
    assert checkpoints(folder) == [1]
    assert controller.asked == [0, 0.5]
    assert not (folder / "lumbricus.lock").exists()

    again = Silent()
    again.let_go.set()
    with serving(again) as address:
        run = go_on(folder, [f"Muscles/biceps/server/Address={address}"], ranks)
    assert again.asked == [0.5]
    assert [row["t"] for row in run.segments()] == [0, 0.5, 1]
