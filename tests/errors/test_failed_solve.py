# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solve that cannot go on ends with exit code 2, the last good state on disk
and a message with time, segment and what to try."""
import pathlib
import re
import xml.etree.ElementTree

import pytest
from lumbricus_run import run
from mistakes import names, on_ranks, run_all

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
        CHAIN, 0, ["Reset/Every=solve", "Reset/Limit=1", "Reset/Tolerance=1e-9",
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
# The tangent is singular inside of what each rank eliminates alone.
FAILURES["muscle that shortens to nothing, with kept factors"] = (
    BLOCK, 0, [FORMULA + "=1e-200", "Time/Smallest step=0.5",
               "Linear solver/Method=kept factor"],
    ["Newton's method", "The stiffness of the body at time 0.5 cannot be "
     "computed: The linear solver (factors in double precision) finds the "
     "tangent singular. Try", "smaller active stretch"])
ON_TWO_RANKS = list(FAILURES)

FAILURES.update({
    # This linear solver went on for ever.
    "linear solver that is not allowed to iterate": (
        CHAIN, 0, ["Linear solver/Method=kept factor",
                   "Linear solver/kept factor/Most iterations=1",
                   "Linear solver/kept factor/Least accuracy=1e-30",
                   "Time/Smallest step=1"],
        ["No solution beyond time 0 ", "does not reach its tolerance in 1 "
         "iterations"]),
    # The cut step ended with SIGSEGV: the solver had given up its last kind of
    # preconditioner, and took itself to have one.
    "multigrid without another solver to follow": (
        CHAIN, 0, ["Linear solver/Method=multigrid",
                   "Linear solver/multigrid/Coarsest unknowns=100",
                   "Linear solver/multigrid/Most iterations=5",
                   "Mesh/Global refinements=1", "Time/End=0.5",
                   "Time/First step=0.5", "Time/Smallest step=0.2"],
        ["No solution beyond time 0 ", "The linear solver (multigrid) does not "
         "reach its tolerance in 5 iterations, even with new factors"]),
    "Newton's method that is not allowed to iterate": (
        BLOCK, 0, ["Newton/Most iterations=1", "Time/Smallest step=0.5"],
        ["No solution beyond time 0 ", "Newton's method does not converge "
         "after 1 iterations", "The body is stable at time 0",
         "100 % of that at rest", "Try a smaller 'Time/Smallest step'"]),
    # The message ended with two full stops, and without what to try.
    "muscle that shortens to nothing": (
        BLOCK, 0, [FORMULA + "=1e-200", "Time/Smallest step=0.5"],
        ["Newton's method cannot start", "from 1 to 1e-200. Of this change 99.",
         "The stiffness of the body at time 0.5 cannot be computed: The tangent "
         "matrix is singular. Try",
         "smaller active stretch"]),
    # The message's number was '-nan %'.
    "muscle that shortens to nothing at once": (
        BLOCK, 0, [FORMULA + "=if(t > 0, 1e-200, 1)",
                   "Time/Smallest step=0.5"],
        ["Newton's method cannot start", "cannot be computed: it is not a "
         "number. Try", "smaller active stretch"]),
    "tolerance of resets below round-off": (
        CHAIN, 0, ["Reset/Every=solve", "Reset/Limit=100", "Reset/Tolerance=1e-16",
                   "Time/Smallest step=1"],
        ["The liquid moves away from the hydrostatic state after ",
         "segment 1 (divergence", "Raise 'Reset/Tolerance'",
         "'Interface/Coupling'"]),
    "body that leaps": (
        BLOCK, 0, ["Boundary conditions/Names=wall, push, more",
                   "Boundary conditions/more/Boundary=x max",
                   "Boundary conditions/more/Type=displacement",
                   "Boundary conditions/more/displacement/Displacement"
                   "=9*t; 0; 0", "Time/Smallest step=0.5"],
        ["moved by more than its own length within the step", "Try a smaller "
         "'Time/Smallest step'"]),
    "body that is sheared": (
        BLOCK, 0.5, [
            "Boundary conditions/Names=wall, push, more",
            "Boundary conditions/more/Boundary=x max",
            "Boundary conditions/more/Type=displacement",
            "Boundary conditions/more/displacement/Displacement="
            "-3*max(0, min(1, (t - 0.5002)/0.0046)); 100*t; 0",
            "Time/First step=0.01",
            "Time/Largest step=0.01", "Time/Smallest step=0.008",
            "Output/Every=0"],
        ["No solution beyond time 0.5", "cells that are badly shaped",
         "wall of segment 1 (scaled Jacobian 0.0", "Try a finer mesh or one "
         "of another shape there"]),
})


CASES = on_ranks([(name, *failure) for name, failure in FAILURES.items()],
                 on_two=ON_TWO_RANKS)


def start(failure, ranks, folder, run):
    _, base, _, settings, _ = failure
    if ranks == 2 and base == BLOCK:
        settings = settings + ["Geometry/block/Cells=2, 1, 1"]
    return run(base, folder / "out", settings, ranks)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("failures"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_last_good_state_is_left(i, results):
    (_, _, last_good, _, words), _ = CASES[i]
    result = results[i]
    assert result.exit_code == 2, result.log + result.message

    everything = result.log + result.message
    assert everything.count("\nlumbricus: ") == 1, everything
    for frame in ("An error occurred", "Stacktrace", "Exception",
                  "TimerOutput", "violated", "bug"):
        assert frame not in everything, everything
    message = result.said()
    for word in words:
        assert word in message, message
    assert f"The last good state, at time {last_good:g}, is in " \
           f"'{result.folder}'" in message

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
