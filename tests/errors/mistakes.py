# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of wrong input share: many tiny runs, each with one mistake,
and what the message on it has to be like.

A mistake is a tuple that begins with its name and ends with the words that the
message has to contain."""
import concurrent.futures

from loaded_program import loaded_program
from lumbricus_run import run

# What no user should have to read.
JARGON = ("An error occurred", "Stacktrace", "exception", "Exception",
          "TimerOutput", "violated", " bug", "MPI_ABORT", "[Anything]",
          "[Map", "[List", "[Name]", "std::")


def on_ranks(mistakes, on_two):
    """All mistakes on one rank, and those of these names on two as well."""
    missing = set(on_two) - {mistake[0] for mistake in mistakes}
    assert not missing, missing
    return [(mistake, 1) for mistake in mistakes] + \
        [(mistake, 2) for mistake in mistakes if mistake[0] in on_two]


def names(cases):
    """What pytest calls the cases."""
    return [f"{mistake[0]}, {ranks} rank" for mistake, ranks in cases]


def run_all(start, cases, base):
    """start(mistake, ranks, folder, run) for all cases, two at a time."""
    def some(first):
        return [start(*cases[i], base / str(i), run)
                for i in range(first, len(cases), 2)]

    loaded_program() # Once, and not by both.
    results = [None] * len(cases)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results[0::2], results[1::2] = pool.map(some, (0, 1))
    return results


def check_one_message(result, words):
    """Exit code 1, one message with all the words, and nothing on disk."""
    everything = result.log + result.message
    assert result.exit_code == 1, everything
    for frame in JARGON:
        assert frame not in everything, everything
    message = result.said()
    assert message.startswith("lumbricus: "), everything
    for part in words:
        assert part in message, message
    assert everything.count("lumbricus: ") == 1, everything
    assert len(message) < 1000, message
    # Nothing was computed, and no earlier results were touched.
    assert not [path for path in result.folder.glob("**/*") if path.is_file()]
