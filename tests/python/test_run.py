# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs from Python: what they leave, how they end and go on."""
import os
import signal
import subprocess
import sys
import threading

import pytest
from lumbricus_run import SOURCE

import lumbricus
from lumbricus.bars import with_bar
from lumbricus.program import environment

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
PISTONS = SOURCE / "tests" / "physics" / "pistons.prm"
SEGMENT = SOURCE / "tests" / "physics" / "segment.prm"
SHORT_STEPS = {"Time/First step": 1e-3, "Time/Largest step": 1e-3, "Output/Every": 0}


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    return lumbricus.Case(PISTONS).run(tmp_path_factory.mktemp("run"), ranks=2)


def test_tables_and_description(finished):
    assert {"segments", "steps", "body", "newton", "reactions"} <= set(finished.tables)
    last = finished.segments.iloc[-1]
    assert last["fluid_pressure"] == pytest.approx(1.4678770983e-2, rel=2e-6)
    assert finished.body["length"].iloc[-1] == pytest.approx(2 * 1.1387208645, rel=1e-12)
    with pytest.raises(AttributeError, match="no table 'sections', but body"):
        finished.sections  # noqa: B018
    description = finished.description
    assert description.status["state"] == "finished"
    assert description.program["ranks"] == 2
    assert description.parameters["Time/End"].value == 1
    assert "cells" in finished.log


@pytest.mark.parametrize("value, error, text", [
    (2.21571573, 0.00371022, "2.2157 ± 0.0037"), (2.2, -0.0996, "2.20 ± 0.10"),
    (-0.004644686, 0.000477218, "-0.00464 ± 0.00048"), (123.4, 56.7, "123 ± 57"),
    (1.5e-8, 2e-10, "(1.500 ± 0.020)e-08"), (3.2e9, 1.7e7, "(3.200 ± 0.017)e+09"),
    (1234.5, 560, "(1.23 ± 0.56)e+03"), (1e-6, 3e-5, "(0.1 ± 3.0)e-05"),
    (6, 0, "6 ± 0"), (2.5, 1e-17, "2.5 ± 1e-17"), (2.5, float("nan"), "2.5"),
    (float("nan"), 1.0, "nan")])
def test_a_number_with_its_bar(value, error, text):
    assert with_bar(value, error) == text


def test_error_bars(finished, tmp_path):
    assert str(finished) == finished.summary()
    assert ": finished at time 1 of 1, 2 steps" in str(finished)
    assert "±" not in str(finished)
    with pytest.raises(lumbricus.LumbricusError, match=r"no estimates.*Output/Errors"):
        finished.bars()
    run = lumbricus.Case(SEGMENT, {
        "Geometry/segment chain/Liquid": "cavity", "Time/First step": 0.1,
        "Time/Largest step": 0.1, "Time/End": 0.2, "Output/Errors": 1}).run(
            tmp_path, progress=False)
    last = run.errors.iloc[-1]
    bars = run.bars()
    assert list(bars.columns) == ["t", "segment", "length", "mid_radius",
                                  "fluid_pressure", "middle_x"]
    for name in ("length", "mid_radius", "fluid_pressure"):
        value, error = map(float, bars[name].iloc[-1].split(" ± "))
        assert value == pytest.approx(last[name], rel=1e-2)
        assert error == pytest.approx(abs(last[f"{name}_error"]), rel=0.06)
        assert bars[name].iloc[-1] in str(run)
    assert list(run.bars(0.1)["t"]) == [0.1]
    with pytest.raises(lumbricus.LumbricusError, match=r"time 0\.7, but at 0\.1, 0\.2;"):
        run.bars(0.7)


def test_a_table_that_is_new_needs_nothing(finished):
    (finished.folder / "shades.csv").write_text("t,shade\n0,0.5\n1,0.2")
    # A last line without its end is not there yet.
    assert list(finished.shades["shade"]) == [0.5]


def test_fields(finished):
    assert finished.times == [0, 0.5, 1]
    mesh = finished.mesh(1.0)
    assert mesh.n_cells >= 4
    assert mesh["displacement"][:, 0].max() == pytest.approx(2 * 0.1387208645)
    assert finished.mesh()["pressure"].max() == pytest.approx(
        mesh["pressure"].max())
    with pytest.raises(lumbricus.LumbricusError, match=r"time 0\.7, but at 0, 0\.5, 1"):
        finished.mesh(0.7)
    with pytest.raises(lumbricus.LumbricusError, match="no run"):
        lumbricus.Run(finished.folder / "vtu")


def test_progress_and_longer(tmp_path):
    seen = []
    case = lumbricus.Case(BLOCK, {"Output/Every": 0, "Time/End": 1})
    case.run(tmp_path, progress=lambda t, end: seen.append((t, end)))
    assert seen[-1] == (1, 1)
    longer = lumbricus.restart(tmp_path, {"Time/End": 1.5}, progress=False)
    assert longer.steps["t"].iloc[-1] == 1.5


def test_what_fails_says_why(tmp_path):
    case = lumbricus.Case(BLOCK)
    with pytest.raises(lumbricus.InputError) as wrong:
        lumbricus.run(case, tmp_path / "a", settings={"Time/End": "never"}, ranks=2)
    assert wrong.value.exit_code == 1 and "Time/End" in wrong.value.message
    assert "mpirun" not in wrong.value.message
    with pytest.raises(lumbricus.RunFailed) as failed:
        lumbricus.run(case, tmp_path / "b", settings={
            "Newton/Most iterations": 1, "Time/Smallest step": 0.5,
            "Time/First step": 1, "Time/Largest step": 1})
    assert failed.value.exit_code == 2 and failed.value.folder == tmp_path / "b"
    with pytest.raises(lumbricus.InputError):
        lumbricus.restart(tmp_path / "c")


@pytest.mark.parametrize("ranks", [1, 2])
def test_keyboard_interrupt_leaves_a_checkpoint(ranks, tmp_path):
    case = lumbricus.Case(BLOCK, SHORT_STEPS)

    def interrupt(t, end):
        # At rest nothing has been computed yet.
        if t > 0:
            raise KeyboardInterrupt
    with pytest.raises(KeyboardInterrupt) as interrupted:
        case.run(tmp_path, ranks=ranks, progress=interrupt)
    assert any("restart" in note for note in interrupted.value.__notes__)
    run = lumbricus.Run(tmp_path)
    assert run.description.status["state"] == "interrupted"
    assert not (tmp_path / "lumbricus.lock").exists()
    there = run.steps["t"].iloc[-1]
    assert 0 < there < 1
    again = lumbricus.restart(tmp_path, {"Time/Largest step": 1}, ranks=ranks)
    assert again.steps["t"].iloc[-1] == 1 and again.steps["t"].is_unique


def test_ctrl_c(tmp_path):
    """As the terminal sends it, while Python waits and shows nothing."""
    case = lumbricus.Case(BLOCK, SHORT_STEPS)
    threading.Timer(1.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        case.run(tmp_path, progress=False)
    assert lumbricus.Run(tmp_path).description.status["state"] == "interrupted"
    assert lumbricus.restart(tmp_path, {"Time/Largest step": 1}).steps["t"].is_unique


def test_another_thread_stops_a_run(tmp_path):
    stop = threading.Event()
    threading.Timer(1.0, stop.set).start()
    with pytest.raises(lumbricus.Interrupted) as interrupted:
        lumbricus.run(lumbricus.Case(BLOCK, SHORT_STEPS), tmp_path, stop=stop)
    assert interrupted.value.exit_code == 4


def test_a_run_ends_with_the_python_that_waits_for_it(tmp_path):
    script = (f"import lumbricus, sys; sys.stdout.write('.'); sys.stdout.flush(); "
              f"lumbricus.Case({str(BLOCK)!r}, {SHORT_STEPS!r}).run({str(tmp_path)!r})")
    process = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": str(SOURCE / "python" / "src")})
    wait = threading.Event()
    for _ in range(600):
        if (tmp_path / "steps.csv").exists() and \
                (tmp_path / "steps.csv").read_text().count("\n") > 3:
            break
        wait.wait(0.05)
    process.send_signal(signal.SIGKILL)
    process.wait()
    for _ in range(600):
        if not (tmp_path / "lumbricus.lock").exists():
            break
        wait.wait(0.05)
    assert lumbricus.Run(tmp_path).description.status["state"] == "interrupted"


def test_the_environment_is_that_of_the_scripts(monkeypatch):
    """scripts/environment.sh and the package say the same."""
    said = subprocess.run(
        ["env", "-i", "PATH=/usr/bin:/bin", "bash", "-c",
         f"source {SOURCE}/scripts/environment.sh; env"],
        capture_output=True, text=True, check=True).stdout
    theirs = dict(line.split("=", 1) for line in said.splitlines())
    for name in list(os.environ):
        monkeypatch.delenv(name)
    ours = environment()
    assert ours == {name: value for name, value in theirs.items()
                    if name.startswith(("OM", "PRTE", "OPENBLAS"))}
    assert len(ours) >= 6
