# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solve that cannot go on ends with exit code 2, the last good state on disk
and a message with time, segment and what to try."""
import pathlib
import re
import xml.etree.ElementTree

import pytest

from lumbricus_run import run

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = HERE / "block.prm"
CHAIN = HERE / "chain.prm"

FORMULA = "Muscles/biceps/expression/Formula"
PRESSURE = "Boundary conditions/push/follower pressure/Pressure"

# What fails at which time after which last good state; settings; words.
FAILURES = {
    "muscle that shortens to 5%": (
        BLOCK, 0.5, [FORMULA + "=1 - 0.95*t", "Time/Smallest step=0.3"],
        ["No solution beyond time 0.5", "segment 1", "'Time/Smallest step'",
         "Try", "smaller active stretch"]),
    "absurd pressure at once": (
        BLOCK, 0, [PRESSURE + "=1000*t", "Time/Smallest step=0.3"],
        ["No solution beyond time 0 ", "segment 1", "'Time/Smallest step'",
         "Try", "load"]),
    "absurd pressure from a time on": (
        BLOCK, 0.5, [PRESSURE + "=0.1*t + if(t > 0.5, 1000*(t - 0.5), 0)",
                     "Time/Smallest step=0.3"],
        ["No solution beyond time 0.5", "segment 1", "Try"]),
    "displacement that turns the cell inside out": (
        BLOCK, 0, ["Boundary conditions/wall/displacement/Displacement"
                   "=0; -4*t*y; 0", "Time/Smallest step=0.4"],
        ["No solution beyond time 0 ", "segment 1 has an inverted element",
         "Try"]),
    "reset limit": (
        CHAIN, 0, ["Reset/Limit=1", "Reset/Tolerance=1e-9",
                   "Time/Smallest step=1"],
        ["No solution beyond time 0 ", "not hydrostatic after 1 resets",
         "segment 1 (divergence", "segment 2 (divergence",
         "raise 'Reset/Limit' or 'Reset/Tolerance'"]),
    "active stretch that is NaN between the times tried": (
        BLOCK, 0, [FORMULA + "=if(abs(t - 0.505) < 0.001, sqrt(-1), 1)",
                   "Time/First step=0.505", "Time/Largest step=1"],
        ["'Muscles/biceps/expression'", "segment 1", "at time 0.505", "nan",
         "Change"]),
    "pressure that is NaN between the times tried": (
        BLOCK, 0, [PRESSURE + "=if(abs(t - 0.505) < 0.001, sqrt(-1), 0)",
                   "Time/First step=0.505", "Time/Largest step=1"],
        [f"'{PRESSURE}'", "at time 0.505", "nan", "Change"]),
    "displacement that is NaN between the times tried": (
        BLOCK, 0.5, ["Boundary conditions/wall/displacement/Displacement"
                     "=if(abs(t - 0.515) < 0.001, sqrt(-1), 0); 0; 0",
                     "Time/First step=0.5", "Time/Largest step=1",
                     "Time/Result interval=0.515"],
        ["'Boundary conditions/wall/displacement/Displacement'",
         "at time 0.515", "nan", "Change"]),
}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("name", FAILURES)
def test_last_good_state_is_left(name, ranks, tmp_path):
    base, last_good, settings, words = FAILURES[name]
    if ranks == 2 and base == BLOCK:
        settings = settings + ["Geometry/block/Cells=2, 1, 1"]
    result = run(base, tmp_path / "out", settings, ranks)
    assert result.exit_code == 2, result.log + result.message

    everything = result.log + result.message
    assert everything.count("\nlumbricus: ") == 1, everything
    for frame in ("An error occurred", "Stacktrace", "Exception",
                  "TimerOutput", "violated", "bug"):
        assert frame not in everything, everything
    message = " ".join(result.message.split())
    for word in words:
        assert word in message, message
    assert f"The last good state, at time {last_good:g}, is in " \
           f"'{tmp_path}/out'" in message

    # The tables end with it.
    assert result.last()["t"] == last_good
    assert result.table("steps.csv")[-1]["t"] == last_good

    # So does the list of pictures, and every file it names is there whole.
    series = xml.etree.ElementTree.parse(result.folder / "solution.pvd")
    sets = series.findall(".//DataSet")
    assert float(sets[-1].get("timestep")) == last_good
    for entry in sets:
        picture = result.folder / entry.get("file")
        for piece in re.findall(r'Source="(.*?)"', picture.read_text()):
            text = (picture.parent / piece).read_text()
            assert text.rstrip().endswith("</VTKFile>")
    assert not list(result.folder.rglob("*.incomplete"))


def test_pictures_of_the_end_only_are_left_too(tmp_path):
    result = run(BLOCK, tmp_path / "out",
                 [FORMULA + "=1 - 0.95*t", "Time/Smallest step=0.3",
                  "Output/Every=0"])
    assert result.exit_code == 2
    series = xml.etree.ElementTree.parse(result.folder / "solution.pvd")
    assert [float(entry.get("timestep"))
            for entry in series.findall(".//DataSet")][-1] == 0.5


def test_cut_steps_are_reported_and_tried_again(tmp_path):
    """With room for smaller steps the same run goes through."""
    settings = [FORMULA + "=1 - 0.5*t", "Newton/Most iterations=7",
                "Time/First step=1", "Time/Largest step=1"]
    result = run(BLOCK, tmp_path / "fails", settings +
                 ["Time/Smallest step=0.6"])
    assert result.exit_code == 2

    result = run(BLOCK, tmp_path / "goes on", settings)
    assert result.exit_code == 0, result.message
    assert "cut to 0.5: Newton's method does not converge" in result.log
    assert result.last()["t"] == 1
    assert result.steps()[0]["cuts"] == 1
