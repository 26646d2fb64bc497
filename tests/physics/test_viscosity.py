# SPDX-License-Identifier: LGPL-2.1-or-later
"""Viscous branches of tissues: bars that are held, pulled and moved to and fro,
against closed forms and an ordinary differential equation."""
import csv
import math
import pathlib

import numpy as np
import pytest
from lumbricus_run import go_on, run, run_well
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from test_active_stress import bar, pulls
from test_energy import check_balance, energy, extrapolated
from test_invariance import TO_THE_END

HERE = pathlib.Path(__file__).parent
A = 0.23


def branches(*of_branches):
    """Settings of viscous branches of a bar, each (shear modulus, time)."""
    section = "Tissues/bar/Viscous branches"
    names = [f"b{i}" for i in range(len(of_branches))]
    return [f"{section}/Names=" + ", ".join(names),
            *(f"{section}/{name}/{key}={value}"
              for name, values in zip(names, of_branches)
              for key, value in zip(("Shear modulus", "Relaxation time"), values))]


def time(end, step, first=None):
    return [f"Time/End={end}", f"Time/First step={first or step}",
            f"Time/Largest step={step}", "Time/Growth=1000"]


def forces(folder):
    """The force along x at the end of the bar at each time, per area at rest."""
    with open(folder / "reactions.csv") as file:
        return [(float(row["t"]), float(row["force_x"]))
                for row in csv.DictReader(file) if row["name"] == "end"]


def lengths(result):
    return [(row["t"], row["length"]) for row in result.segments()]


def uniaxial(l):
    """The nominal stress of a Neo-Hookean bar whose shear modulus is 1."""
    return l - l**-2


def part_after_ramp(dt, tau):
    """Of the stress of a spring that is strained in a step of that length."""
    return -math.expm1(-dt / tau) * tau / dt


# Whatever the steps are, shorter or longer than the relaxation time.
@pytest.mark.parametrize("ramp, step, ranks", [
    (0.01, 0.01, 1), (0.01, 0.07, 1), (0.05, 1.3, 1), (0.05, 0.4, 2)])
def test_relaxation_at_a_held_stretch(tmp_path, ramp, step, ranks):
    """exp(-t/tau) of what the branch has at the end of the ramp, exactly."""
    l, mu, tau = 1.4, 0.7, 0.31
    n = 3
    run_well(HERE / "bar.prm", tmp_path, [
        *bar(displacement=f"{l - 1}*min(1, t/{ramp})"), *branches((mu, tau)),
        *time(ramp + n * step, step, ramp), *TO_THE_END], ranks)
    found = forces(tmp_path)
    assert len(found) == n + 1
    for t, force in found:
        expected = A + mu * part_after_ramp(ramp, tau) * math.exp(-(t - ramp) / tau)
        assert force == pytest.approx(expected * uniaxial(l), rel=1e-9), t


class Bar:
    """The differential equation of an incompressible bar with free sides: along its
    axis and across, db/dt = (Cbar^(-1) - b)/tau of every branch."""

    def __init__(self, *of_branches):
        self.mu, self.tau = map(np.array, zip(*of_branches))

    def stress(self, l, b):
        """Nominal, of the law and the branches."""
        along, across = b.reshape(2, -1)
        return A * uniaxial(l) + self.mu @ (along * l - across / l**2)

    def rates(self, l, b):
        along, across = b.reshape(2, -1)
        return np.concatenate([(l**-2 - along) / self.tau, (l - across) / self.tau])

    def dissipation(self, l, b):
        along, across = b.reshape(2, -1)
        x, y = l**2 * along, across / l
        return (self.mu / (2 * self.tau)) @ (x + 1 / x + 2 * y + 2 / y - 6)

    def at_rest(self):
        return np.ones(2 * len(self.mu))

    def solve(self, rates, start, end):
        return solve_ivp(rates, (0, end), start, "LSODA", rtol=1e-10, atol=1e-12)


def of_second_order(coarse, fine, exact, rel=0.15):
    assert (coarse - exact) / (fine - exact) == pytest.approx(4, rel=rel)


def test_creep(tmp_path):
    """A bar with two branches under a force that grows."""
    of_branches, load = [(0.3, 0.2), (0.1, 1.5)], 0.3
    equation = Bar(*of_branches)

    def length(t, b):
        return brentq(lambda l: equation.stress(l, b) - load * t, 0.9, 4, xtol=1e-14)
    b = equation.solve(lambda t, b: equation.rates(length(t, b), b),
                       equation.at_rest(), 1).y[:, -1]
    exact, found = length(1, b), {}
    for n in (8, 16):
        found[n] = run_well(HERE / "bar.prm", tmp_path / str(n), [
            *bar(traction=f"{load}*t"), *branches(*of_branches),
            *time(1, 1 / n)]).last()["length"]
    assert exact > 1.2
    of_second_order(found[8], found[16], exact)
    assert found[16] == pytest.approx(exact, rel=1e-4)


# The second is so quick that it is a Newtonian liquid, in steps 30 times as long.
@pytest.mark.parametrize("of_branch", [(0.5, 0.15), (25., 0.001)])
def test_loop_of_a_bar_that_moves_to_and_fro(tmp_path, of_branch):
    """What is dissipated in the second period is the area of the loop of force and
    length, and what the differential equation says; the balance is closed to second
    order in the steps."""
    equation, found, area = Bar(of_branch), {}, {}

    def stretch(t):
        return 1 + 0.3 * np.sin(2 * np.pi * t)

    def rates(t, y):
        l, b = stretch(t), y[:2]
        speed = 0.6 * np.pi * np.cos(2 * np.pi * t)
        return np.concatenate([equation.rates(l, b), [
            equation.dissipation(l, b), equation.stress(l, b) * speed]])
    start = np.concatenate([equation.at_rest(), [0, 0]])
    one, two = (equation.solve(rates, start, end).y[:, -1] for end in (1, 2))
    lost, work = (two - one)[2:]
    assert work == pytest.approx(lost, rel=1e-3 if of_branch[1] > 0.1 else 1e-7)
    for n in (32, 64):
        folder = tmp_path / str(n)
        run_well(HERE / "bar.prm", folder, [
            *bar(displacement="0.3*sin(2*pi*t)"), *branches(of_branch),
            *time(2, 1 / n), "Output/Energy=true"])
        found[n] = energy(folder, since=1)
        check_balance(found[n])
        with open(folder / "energy.csv") as file:
            assert all(float(row["work"]) > 0 for row in csv.DictReader(file)
                       if row["kind"] == "viscosity")
        loop = [(stretch(t), force) for t, force in forces(folder) if t > 1 - 1e-9]
        area[n] = sum(0.5 * (f + g) * (m - l) for (l, f), (m, g) in zip(loop, loop[1:]))
        assert found[n]["boundary condition", "end"] == pytest.approx(area[n], rel=1e-3)
    dissipated, balance = ("viscosity", "bar"), ("balance", "balance")
    of_second_order(area[32], area[64], work)
    of_second_order(found[32][balance], found[64][balance], 0)
    if of_branch[1] > 0.1:
        assert extrapolated(found[32][dissipated], found[64][dissipated]) == \
            pytest.approx(lost, rel=2e-5)
    assert found[64][dissipated] == pytest.approx(lost, rel=1e-3)
    assert abs(found[64][balance]) < 4e-3 * lost


def test_small_oscillation_has_the_loss_modulus(tmp_path):
    """pi E'' e^2 in a period, E'' = 3 sum mu w tau/(1 + (w tau)^2)."""
    of_branches, e, w = [(0.3, 0.1), (0.2, 0.5)], 1e-3, 2 * math.pi
    run_well(HERE / "bar.prm", tmp_path, [
        *bar(displacement=f"{e}*sin(2*pi*t)"), *branches(*of_branches),
        *time(3, 1 / 64), "Output/Energy=true"])
    loss = 3 * sum(mu * w * tau / (1 + (w * tau)**2) for mu, tau in of_branches)
    assert energy(tmp_path, since=2)["viscosity", "bar"] == pytest.approx(
        math.pi * loss * e**2, rel=5e-3)


def test_sphere_at_a_held_volume(tmp_path):
    """Blown up to twice the volume of its cavity in one step: the pressure that an
    integral through its wall gives, as much more as the branch has still."""
    elastic, mu, tau, ramp = 0.5645064496, 0.7, 0.4, 0.2
    branch = "Tissues/wall/Viscous branches"
    result = run_well(HERE / "sphere.prm", tmp_path, [
        f"{branch}/Names=b", f"{branch}/b/Shear modulus={mu}",
        f"{branch}/b/Relaxation time={tau}", "Cavities/Content=volume",
        f"Cavities/volume/Relative volume=1 + min(1, t/{ramp})",
        *time(0.8, 0.3, ramp)], 2)
    rows = [row for row in result.segments() if row["t"] > 0]
    assert len(rows) == 3
    parts = [1 + mu * part_after_ramp(ramp, tau) * math.exp((ramp - row["t"]) / tau)
             for row in rows]
    for row, part in zip(rows, parts):
        assert row["fluid_pressure"] == pytest.approx(elastic * part, rel=1e-4)
        assert row["fluid_pressure"] / rows[0]["fluid_pressure"] == pytest.approx(
            part / parts[0], rel=1e-7)


def test_a_load_that_jumps(tmp_path):
    """It is one that grows in the step in which it jumps; in the end nothing is left of
    the branch."""
    load, mu, tau, dt = 0.2, 0.4, 0.1, 0.1
    rows = lengths(run_well(HERE / "bar.prm", tmp_path, [
        *bar(traction=f"if(t > 0.45, {load}, 0)"), *branches((mu, tau)),
        *time(2.5, dt)]))
    assert rows[4][1] == pytest.approx(1, abs=1e-12)
    at_once, at_last = (brentq(lambda l: modulus * uniaxial(l) - load, 1, 2)
                        for modulus in (A + mu * part_after_ramp(dt, tau), A))
    assert rows[5][1] == pytest.approx(at_once, rel=1e-9)
    assert rows[-1][1] == pytest.approx(at_last, rel=1e-3)
    assert at_last - at_once > 0.15


def test_a_blow_that_is_applied_in_parts(tmp_path):
    """One that no step could take: all parts are at one time, in which nothing
    relaxes."""
    load, mu = -20, 0.4
    result = run_well(HERE / "bar.prm", tmp_path, [
        *bar(traction=f"if(t > 0.45, {load}, 0)"), *branches((mu, 0.5)),
        *time(0.5, 0.05), "Newton/Most iterations=6"])
    assert "jumps between the times 0.45 and 0.45" in result.log
    lengths_then = [l for t, l in lengths(result) if 0.45 <= t < 0.451]
    expected = brentq(lambda l: (A + mu) * uniaxial(l) - load, 0.05, 1)
    assert lengths_then[-1] == pytest.approx(expected, rel=1e-6)


def test_muscles_and_growth_do_not_strain_a_branch(tmp_path):
    """Only motion does: a muscle that is held pulls as it does without, and what grows
    freely is free of stress."""
    contracts = ["Muscles/m0/Active stretch=expression",
                 "Muscles/m0/expression/Formula=1 - 0.2*t"]
    for action, load in ((contracts, {"displacement": 0}), (pulls("m0", 0.1),
                                                              {"displacement": 0})):
        found = []
        for name, more in (("without", []), ("with", branches((0.7, 0.3)))):
            folder = tmp_path / f"{len(action)}{name}"
            run_well(HERE / "bar.prm", folder, [
                *bar(action, **load), *more, *time(1, 0.25)])
            found.append([force for _, force in forces(folder)])
        assert found[1] == pytest.approx(found[0], rel=1e-9)
        assert found[0][-1] > 0.05
    result = run_well(HERE / "bar.prm", tmp_path / "grows", [
        *bar(["Muscles/m0/Action=growth", "Muscles/m0/Growth=expression",
              "Muscles/m0/expression/Formula=1 + 0.3*t"]),
        *branches((0.7, 0.3)), *time(1, 0.25), "Output/Points=0.5, 0.5, 0.5"])
    assert result.last()["length"] == pytest.approx(1.3, rel=1e-9)
    assert abs(result.table("points.csv")[-1]["sxx"]) < 1e-9


def clamped(of_branches=((0.5, 0.2), (0.2, 1.))):
    """A bar that is drawn at an end which stays as wide as it was, and held there."""
    return [*bar(displacement="min(2*t, 1)*0.5"), *branches(*of_branches),
            "Boundary conditions/end/displacement/Components=x, y, z",
            "Output/Energy=true", *time(1, 0.125)]


def test_ranks_restart_and_prediction(tmp_path):
    settings = [*clamped(), *TO_THE_END]
    run_well(HERE / "bar.prm", tmp_path / "one", settings)
    run_well(HERE / "bar.prm", tmp_path / "two", settings, 2)
    run_well(HERE / "bar.prm", tmp_path / "predicted",
             [*settings, "Newton/Predictor order=2"])
    run_well(HERE / "bar.prm", tmp_path / "cut", [*settings, "Time/End=0.75"])
    go_on(tmp_path / "cut", ["Time/End=1"])
    one = forces(tmp_path / "one")
    assert len(one) == 8 and one[3][1] > 1.2 * one[-1][1]
    for name, tolerance in (("two", 1e-9), ("predicted", 1e-9), ("cut", 1e-12)):
        for row, other in zip(one, forces(tmp_path / name), strict=True):
            assert other == pytest.approx(row, rel=tolerance), name
    for name, tolerance in (("two", 1e-9), ("cut", 1e-12)):
        for key, value in energy(tmp_path / "one").items():
            assert energy(tmp_path / name)[key] == pytest.approx(
                value, rel=tolerance, abs=1e-13), (name, key)


def test_step_that_is_cut(tmp_path):
    """It starts anew with what was remembered when it began: closed form of every
    step, whatever its length."""
    l, mu, tau = 3., 0.7, 0.4
    result = run_well(HERE / "bar.prm", tmp_path, [
        *bar(displacement=f"{l - 1}*min(1, 2*t)"), *branches((mu, tau)), *time(1, 0.5),
        "Newton/Most iterations=3"])
    assert sum(row["cuts"] for row in result.table("steps.csv")) >= 1
    b, last = np.ones(2), 1.
    dt = np.diff([0, *(t for t, _ in forces(tmp_path))])
    for (t, force), step in zip(forces(tmp_path), dt):
        now = 1 + (l - 1) * min(1, 2 * t)
        e, m = math.exp(-step / tau), part_after_ramp(step, tau)
        b = e * b + (m - e) * np.array([last**-2, last])
        stress = A * uniaxial(now) + mu * (b[0] * now - b[1] / now**2)
        assert force == pytest.approx(stress, rel=1e-7), t
        b, last = b + (1 - m) * np.array([now**-2, now]), now


def test_on_meshes_that_change(tmp_path):
    """A bar of the same stretch everywhere is on any mesh what it was; one that is
    not forgets no more than the coarse mesh did not know."""
    adaptive = ["Adaptivity/Every=1", "Adaptivity/Marking=fraction of cells",
                "Adaptivity/fraction of cells/Refine=0.3"]
    even = [*bar(displacement="min(2*t, 1)*0.5"), *branches((0.5, 0.2)),
            *time(1, 0.25), *TO_THE_END]
    run_well(HERE / "bar.prm", tmp_path / "fixed", even)
    result = run_well(HERE / "bar.prm", tmp_path / "adaptive", [*even, *adaptive])
    assert result.table("mesh.csv")[-1]["cells"] > 20
    for row, other in zip(*(forces(tmp_path / name) for name in ("fixed", "adaptive")),
                          strict=True):
        assert other == pytest.approx(row, rel=1e-8)
    run_well(HERE / "bar.prm", tmp_path / "fine",
             [*clamped(), "Mesh/Global refinements=1", "Time/End=0.75"])
    run_well(HERE / "bar.prm", tmp_path / "later", [
        *clamped(), "Time/End=0.75", "Adaptivity/Every=5", "Adaptivity/Marking=fraction of cells",
        "Adaptivity/fraction of cells/Refine=1"])
    fine, later = (forces(tmp_path / name) for name in ("fine", "later"))
    assert later[-1][1] == pytest.approx(fine[-1][1], rel=2e-3)
    check_balance(energy(tmp_path / "later"))


def test_arc_length_refuses_it(tmp_path):
    result = run(HERE / "bar.prm", tmp_path, [
        *bar(traction="0.1*t"), *branches((0.5, 0.2)), "Path/Control=arc length"])
    assert result.exit_code != 0
    assert "a tissue has viscous branches, whose stress relaxes in time" in result.said()
