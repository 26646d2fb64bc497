# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a controller is not there a run does not begin, exit code 1; where it is
late, ends, or answers what cannot be, the run ends with its last good state and
exit code 2. The message says what came."""
import json
import os
import pathlib
import socket
import time

import pytest
from controlled_run import Controller, controlled, serving
from lumbricus_run import run, run_well
from mistakes import check_one_message

BLOCK = pathlib.Path(__file__).resolve().parent / "block.prm"


class Faulty(Controller):
    """Says what is right for a step, and then what a test wants it to."""

    def __init__(self, words):
        self.words = words
        self.n = 0

    def step(self, t, dt, segments):
        self.n += 1
        return {"biceps": 0.95} if self.n == 1 else self.words


class Raw(Faulty):
    """The same with a line that need not be JSON."""

    def serve(self, address):
        with socket.socket(socket.AF_UNIX) as listener:
            beside = f"{address}-"
            listener.bind(beside)
            listener.listen(1)
            os.replace(beside, address)
            connection, _ = listener.accept()
            with connection, connection.makefile("rw") as lines:
                for line in lines:
                    assert json.loads(line)["segments"][0]["segment"] == 1
                    answer = self.step(0, 0, [])
                    if answer is None:
                        return
                    if answer == "late":
                        time.sleep(2)
                        return
                    lines.write(answer if isinstance(answer, str) else
                                json.dumps(answer) + "\n")
                    lines.flush()


def faulty_run(folder, controller, settings=(), ranks=1):
    with serving(controller) as address:
        result = run(BLOCK, folder, [*controlled(["biceps"], address),
                                     *settings], ranks)
    return result, f"The controller at '{address}' "


def check_end(result, beginning, words):
    assert result.exit_code == 2, result.log + result.message
    message = result.said()
    assert message.startswith("lumbricus: " + beginning), message
    for word in [*words, "The last good state, at time 0.5, is in"]:
        assert word in message, message
    assert [row["t"] for row in result.table("steps.csv")] == [0, 0.5]
    assert (result.folder / "solution.pvd").exists()


@pytest.mark.parametrize("answer, words", [
    ({}, ["is no object with the muscles 'biceps'"]),
    ([0.9], ["'[0.9]'", "is no object with the muscles 'biceps'"]),
    ({"triceps": 0.9}, ["does not have the muscle 'biceps'"]),
    ({"biceps": 0.9, "largets_dt": 1},
     ["has 'largets_dt', which is neither 'largest_dt' nor a muscle"]),
    ({"biceps": [0.9, 0.8]},
     ["has 2 values for the muscle 'biceps', but the body has 1 segment"]),
    ({"biceps": []}, ["has 0 values for the muscle 'biceps'"]),
    ({"biceps": [None]}, ["has 'null' as the active stretch of muscle 'biceps' "
                          "in segment 1, which is no number"]),
    ({"biceps": {"1": 0.9}}, ["has an object for the muscle 'biceps'"]),
    ({"biceps": float("nan")}, ["NaN", "is no JSON"]),
    ({"biceps": -0.5}, ["has -0.5 as the active stretch of muscle 'biceps' in "
                        "segment 1, which has to be a number > 0"]),
    ({"biceps": 0.9, "largest_dt": 0},
     ["has '0' as 'largest_dt'", "'Time/Smallest step'"])])
def test_a_wrong_answer(tmp_path, answer, words):
    result, beginning = faulty_run(tmp_path, Faulty(answer))
    check_end(result, beginning + "answered '", words)


@pytest.mark.parametrize("line, words", [
    ("hello\n", ["'hello'", "is no JSON"]),
    ('{"biceps": 0.9\n', ["is no JSON"]),
    ('{"biceps": 0.9, "biceps": 0.8}\n', ["has 'biceps' twice"]),
    ("[" * 100000 + "\n", ["too many objects and arrays in each other"])])
def test_nonsense(tmp_path, line, words):
    result, beginning = faulty_run(tmp_path, Raw(line))
    check_end(result, beginning + "answered '", words)


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_controller_that_ends(tmp_path, ranks):
    result, beginning = faulty_run(tmp_path, Raw(None), ranks=ranks)
    check_end(result, beginning + "has ended, or closed the connection", [])


def test_a_controller_that_is_late(tmp_path):
    result, beginning = faulty_run(
        tmp_path, Raw("late"), ["Muscles/biceps/server/Late after=0.5"])
    check_end(result, beginning + "did not answer within 0.5 s", [])


def test_a_controller_that_talks_too_much(tmp_path):
    result, beginning = faulty_run(
        tmp_path, Raw('{"biceps": 0.9}\n{"biceps": 0.9}\n'),
        ["Time/First step=0.25", "Time/Largest step=0.25"])
    assert result.exit_code == 2
    assert beginning + "said something before it was asked" in result.said()


def test_nobody_is_there(tmp_path):
    address = tmp_path / "nobody"
    settings = controlled(["biceps"], address)
    words = ["Parameter 'Muscles/biceps/server/Address'",
             f"no controller answers at '{address}' (No such file"]
    for ranks in (1, 2):
        result = run(BLOCK, tmp_path / "out", settings, ranks)
        check_one_message(result, words)
    with socket.socket(socket.AF_UNIX) as left:
        left.bind(str(address))
    result = run(BLOCK, tmp_path / "out", settings)
    check_one_message(result, [f"no controller answers at '{address}' "
                               "(Connection refused)"])
    # Whether the rest is right can be seen without.
    run_well(BLOCK, tmp_path / "out", settings, options=["--check"])


@pytest.mark.parametrize("address, words", [
    ("", ["is not set"]),
    ("x" * 108, ["has 108 bytes", "at most 107"])])
def test_an_address_that_cannot_be_one(tmp_path, address, words):
    result = run(BLOCK, tmp_path / "out", controlled(["biceps"], address))
    check_one_message(result, ["'Muscles/biceps/server/Address'", *words])
