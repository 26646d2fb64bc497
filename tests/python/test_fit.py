# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters are found again in numbers of a closed form, and those that cannot be are
named."""
import dataclasses

import numpy as np
import pytest
from loaded_program import loaded_program
from lumbricus_run import SOURCE

import lumbricus
from lumbricus.fitting import Target, Unknown, step_for

PISTONS = SOURCE / "tests" / "physics" / "pistons.prm"
A = "Tissues/circular layer/Neo-Hooke/a"
# Of a tube with a = 0.23 that contracts to c = 0.8 and has free ends (DESIGN 1; the
# closed form is in tests/physics/test_pistons.py).
LENGTH, PRESSURE = 1.1387208645, 1.4678770983e-2

STIFFNESS = Unknown(A, 0.25, 0.01, 10)
CONTRACTION = Unknown("c", 0.78, 0.3, 0.99, settings=lambda c: {
    "Muscles/circular/expression/Formula": f"1 - (1 - {c!r})*t"})
OF_PRESSURE = Target("pressure", lambda run: run.segments["fluid_pressure"].iloc[-1],
                     PRESSURE)


def force_at_the_ends(run):
    """Of the whole tube at the length that was measured: none, where it was free."""
    last = run.reactions[run.reactions["name"] == "rear"].iloc[-1]
    return 4 * last["force_x"]


@pytest.fixture(scope="module")
def case():
    return lumbricus.Case(PISTONS, {
        "Time/First step": 1, "Time/Largest step": 1, "Output/Every": 0,
        "Boundary conditions/rear/displacement/Displacement":
            f"2*({LENGTH} - 1)*t; 0; 0"}, loaded_program())


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("fit")


def test_stiffness_and_contraction_are_found(case, folder):
    found = lumbricus.fit(case, [STIFFNESS, CONTRACTION], [
        OF_PRESSURE, Target("force", force_at_the_ends, 0.0, 5e-3)], folder, workers=2)
    assert found.values[A] == pytest.approx(0.23, abs=1e-6)
    assert found.values["c"] == pytest.approx(0.8, abs=1e-6)
    assert found.cannot_be_told_apart == []
    # P is proportional to a, and dP/dc that of a (c^-2 - c).
    assert found.jacobian[A]["pressure"] == pytest.approx(PRESSURE / 0.23, rel=1e-5)
    assert found.jacobian["c"]["pressure"] == pytest.approx(
        PRESSURE * (-2 * 0.8**-3 - 1) / (0.8**-2 - 0.8), rel=1e-4)
    # 5e-3 N in the force is so much in c; a follows it, and 1 % of the pressure.
    of_c = 5e-3 / found.jacobian["c"]["force"]
    assert found.uncertainty["c"] == pytest.approx(of_c, rel=1e-3)
    of_a = 0.23 * np.hypot(0.01, of_c * found.jacobian["c"]["pressure"] / PRESSURE)
    assert found.uncertainty[A] == pytest.approx(of_a, rel=1e-3)
    low, high = found.intervals().loc[A]
    assert high - low == pytest.approx(2 * 1.959964 * of_a, rel=1e-3)
    assert "95 %" in found.report() and "cannot" not in found.report()
    found.plot().savefig(folder / "fit.png")
    assert (folder / "fit.png").stat().st_size > 10000


def test_pressure_alone_does_not_tell_them_apart(case, folder):
    nearer = dataclasses.replace(STIFFNESS, start=0.235)
    found = lumbricus.fit(case, [nearer, CONTRACTION], [OF_PRESSURE], folder, workers=2)
    assert found.targets["found"].iloc[0] == pytest.approx(PRESSURE, rel=1e-6)
    assert found.cannot_be_told_apart == [[A, "c"]]
    assert np.isinf(found.uncertainty).all()
    assert f"'{A}' and 'c' cannot be told apart" in found.report()


def test_steps_suit_the_tolerance(case, folder):
    run = lumbricus.run(case, folder / "one", settings={"Newton/Force tolerance": 1e-6})
    assert step_for(run) == pytest.approx(1e-2)


def test_nonsense_is_refused(case, folder):
    with pytest.raises(ValueError, match="needs an error"):
        lumbricus.fit(case, [STIFFNESS], [Target("force", force_at_the_ends, 0.0)],
                      folder)
    with pytest.raises(ValueError, match="needs a scale"):
        lumbricus.fit(case, [Unknown(A, 0.0)], [OF_PRESSURE], folder)
    with pytest.raises(lumbricus.InputError, match="has to be"):
        lumbricus.fit(case, [Unknown(A, -1.0)], [OF_PRESSURE], folder)
