# SPDX-License-Identifier: LGPL-2.1-or-later
"""lumbricus-plot --watch beside a run that goes on: it draws more than once, nobody
sees half of a file, and it ends with the run, however that ends."""
import os
import re
import signal
import subprocess
import sys
import threading
import time

import pytest
from lumbricus_run import SOURCE, run_well

PLOT = [sys.executable, str(SOURCE / "scripts" / "lumbricus-plot")]
CASE = SOURCE / "tests" / "physics" / "chain.prm"
# More steps than the test takes.
SLOWLY = ["Time/End=1", "Time/First step=1e-4", "Time/Largest step=1e-4"]
RELOAD = '<meta http-equiv="refresh" content="0.3">'
END_OF_PNG = b"IEND\xaeB`\x82"


def begin(command):
    return subprocess.Popen([str(word) for word in command], text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE)


class Reader(threading.Thread):
    """Reads what is drawn again and again, as a browser that is in a hurry."""

    def __init__(self, folder):
        super().__init__(daemon=True)
        self.folder, self.reports, self.wrong = folder, [], []
        self.go_on = True

    def run(self):
        while self.go_on:
            for name, end in (("report.html", b"</html>\n"),
                              ("segments.png", END_OF_PNG)):
                try:
                    content = (self.folder / name).read_bytes()
                except FileNotFoundError:
                    continue
                if not content.endswith(end):
                    self.wrong.append((name, len(content)))
                if name == "report.html" and content.decode() not in self.reports[-1:]:
                    self.reports.append(content.decode())
            time.sleep(0.001)

    def wait_for(self, n_reports, processes):
        until = time.monotonic() + 120
        while len(self.reports) < n_reports:
            assert time.monotonic() < until
            assert all(process.poll() is None for process in processes)
            time.sleep(0.05)


def steps_in(report):
    return int(re.search(r"<p>(\d+) load steps to time", report)[1])


@pytest.mark.parametrize("end, words", [
    (signal.SIGTERM, "The run was interrupted."),
    (signal.SIGKILL, "The run is going on.")])
def test_a_run_is_watched_to_its_end(end, words, tmp_path):
    folder, out = tmp_path / "run", tmp_path / "out"
    out.mkdir()
    watching = begin([*PLOT, folder, "--watch", 0.3, "--output", out,
                      "--only", "segments", "report"])
    assert watching.stdout.readline() == f"Waiting for a run in '{folder}'.\n"
    # As users start it: a signal to the starter of loaded_program() ends that alone.
    run = begin([os.environ["LUMBRICUS"], CASE, "--output", folder, "--quiet",
                 *(word for setting in SLOWLY for word in ("--set", setting))])
    reader = Reader(out)
    reader.start()
    try:
        reader.wait_for(3, [run, watching])
        run.send_signal(end)
        run.communicate(timeout=60)
        said, error = watching.communicate(timeout=60)
    finally:
        reader.go_on = False
        for process in (run, watching):
            process.kill()
    reader.join()
    assert (watching.returncode, error) == (0, "")
    assert reader.wrong == []
    assert all(RELOAD in report for report in reader.reports[:3])
    steps = [steps_in(report) for report in reader.reports]
    assert sorted(set(steps[:3])) == steps[:3]
    last = (out / "report.html").read_text()
    assert words in last, (re.findall(r"The run [^.]*[.]", last), said, run.returncode)
    if end == signal.SIGKILL:
        assert "was killed" in said
    assert RELOAD not in last
    rows = (folder / "segments.csv").read_text().splitlines()
    assert steps_in(last) == (len(rows) - 1) // 3 - 1
    # What was drawn for a while is not left.
    assert sorted(os.listdir(out)) == ["report.html", "segments.png"]


def test_a_run_that_is_over_is_drawn_once(tmp_path):
    run = run_well(CASE, tmp_path / "run", ["Time/End=0.1"])
    process = begin([*PLOT, run.folder, "--watch", "--only", "segments", "report"])
    said, error = process.communicate(timeout=60)
    assert (process.returncode, error) == (0, "")
    assert said.count("Wrote") == 1
    assert "refresh" not in (run.folder / "report.html").read_text()


def test_a_damaged_run_ends_the_watch(tmp_path):
    run = run_well(CASE, tmp_path / "run", ["Time/End=0.1"])
    (run.folder / "segments.csv").unlink()
    process = begin([*PLOT, run.folder, "--watch"])
    said, error = process.communicate(timeout=60)
    assert process.returncode == 1
    assert "segments.csv' is missing" in error
