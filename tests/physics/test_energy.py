# SPDX-License-Identifier: LGPL-2.1-or-later
"""energy.csv: the work of muscles, loads and friction against closed forms, and
the balance, which is left by the length of steps alone."""
import csv
import math
import pathlib

import pytest
from lumbricus_run import go_on, run_well
from test_contact_output import condition, conditions

HERE = pathlib.Path(__file__).parent
GROUND = HERE / "ground.prm"
A = 0.23
N = 0.01


def steps(n):
    return ["Output/Energy=true", f"Time/First step={1 / n}",
            f"Time/Largest step={1 / n}"]


def energy(folder, since=0):
    """The sums over all steps by (kind, name)."""
    sums = {}
    with open(folder / "energy.csv") as file:
        for row in csv.DictReader(file):
            if float(row["t"]) > since + 1e-12:
                key = row["kind"], row["name"]
                sums[key] = sums.get(key, 0) + float(row["work"])
    return sums


def extrapolated(coarse, fine):
    """Of an error of second order."""
    return fine + (fine - coarse) / 3


def check_balance(found):
    works = sum(-value if kind == "viscosity" else value
                for (kind, _), value in found.items()
                if kind not in ("stored", "friction", "balance", "adaptation"))
    assert works - found["stored", "tissues"] == pytest.approx(
        found["balance", "balance"], rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("ranks", [1, 2])
def test_stretched(tmp_path, ranks):
    """A unit cube that is drawn to l takes a/2 (l^2 + 2/l - 3)."""
    found = {}
    for n in (4, 8):
        folder = tmp_path / str(n)
        run_well(GROUND, folder, [
            *steps(n), "Boundary conditions/Names=bottom, top",
            *condition("bottom", "displacement", "z min", Components="z"),
            "Boundary conditions/top/displacement/Displacement=0; 0; 0.5*t"], ranks)
        found[n] = energy(folder)
        check_balance(found[n])
        assert found[n]["boundary condition", "bottom"] == 0
    l = 1.5
    expected = 0.5 * A * (l**2 + 2 / l - 3)
    work = "boundary condition", "top"
    balance = "balance", "balance"
    for n in (4, 8):
        assert found[n]["stored", "tissues"] == pytest.approx(expected, rel=1e-9)
    # The trapezoidal rule.
    assert found[4][balance] / found[8][balance] == pytest.approx(4, rel=0.02)
    assert extrapolated(found[4][work], found[8][work]) == pytest.approx(
        expected, rel=2e-5)


def test_muscle_that_lifts(tmp_path):
    """A muscle shortens to 0.8 and lifts F meanwhile, stretched by it to l_e of
    that, where a (l_e - l_e^-2) = 0.8 F: what it stores and what it lifts it does."""
    pull, contraction = 0.02, 0.2
    found = {}
    for n in (8, 16):
        folder = tmp_path / str(n)
        run_well(GROUND, folder, [
            *steps(n), "Tissues/block/Muscles=fibres",
            "Muscles/fibres/Fibres=direction",
            "Muscles/fibres/direction/Direction=0, 0, 1",
            "Muscles/fibres/Active stretch=expression",
            f"Muscles/fibres/expression/Formula=1 - {contraction}*max(0, 2*t - 1)",
            "Boundary conditions/Names=bottom, load",
            *condition("bottom", "displacement", "z min", Components="z"),
            *condition("load", "dead traction", "z max",
                       Traction=f"0; 0; {pull}*min(1, 2*t)")])
        found[n] = energy(folder, since=0.5)
        check_balance(found[n])
    assert found[16]["muscle", "fibres"] > 0
    # Of the elastic stretch l_e of a shape that is as long as stretch.
    def length_and_energy(stretch):
        low, high = 1., 2.
        for _ in range(200):
            l_e = 0.5 * (low + high)
            if A * (l_e - l_e**-2) > stretch * pull:
                high = l_e
            else:
                low = l_e
        return stretch * l_e, 0.5 * A * (l_e**2 + 2 / l_e - 3)
    (before, stored_before), (after, stored_after) = map(
        length_and_energy, (1, 1 - contraction))
    lifted = pull * (before - after)
    for n in (8, 16):
        assert found[n]["boundary condition", "load"] == pytest.approx(
            -lifted, rel=1e-9)
        assert found[n]["stored", "tissues"] == pytest.approx(
            stored_after - stored_before, rel=1e-7)
    balance = "balance", "balance"
    assert found[8][balance] / found[16][balance] == pytest.approx(4, rel=0.02)
    muscle = extrapolated(*(found[n]["muscle", "fibres"] for n in (8, 16)))
    assert muscle == pytest.approx(lifted + stored_after - stored_before, rel=1e-6)


@pytest.mark.parametrize("moves", ["block", "ground"])
def test_dragged(tmp_path, moves):
    """What friction takes is mu N times the way, whether the block slides over the
    ground or the ground below the block."""
    mu, slip, way = 0.3, 1e-3, 0.2
    ramp = f"{way}*max(0, 2*t - 1)"
    settings = [
        *steps(20), "Geometry/block/Lengths=2, 2, 0.5", "Tissues/block/Neo-Hooke/a=23",
        f"Boundary conditions/ground/contact/Friction={mu}, {mu}, {mu}",
        f"Boundary conditions/ground/contact/Elastic slip={slip}",
        *conditions(
            top=("displacement", "z max", {
                "Components": "x, y",
                "Displacement": f"{ramp if moves == 'block' else 0}; 0; 0"}),
            press=("dead traction", "z max", {
                "Traction": f"0; 0; -{N / 4}*min(1, 2*t)"}))]
    if moves == "ground":
        settings.append("Boundary conditions/ground/contact/plane/Point="
                        f"-{ramp}; 0; 0")
    run_well(GROUND, tmp_path, settings)
    # From the end of the step on in which it begins to slide.
    found = energy(tmp_path, since=0.55)
    check_balance(found)
    taken = mu * N * 0.9 * way
    assert found["friction", "ground"] == pytest.approx(taken, rel=1e-6)
    # That of a ground that stands still is the work of that ground, and that of one
    # that moves does nothing to the block.
    on_block, held = (found["boundary condition", name] for name in ("ground", "top"))
    if moves == "block":
        assert on_block == pytest.approx(-taken, rel=1e-6)
        assert held == pytest.approx(taken, rel=1e-6)
    else:
        assert held == 0
        assert abs(on_block) < 1e-6 * taken


def test_drag(tmp_path):
    """A steady force goes into drag, all of it."""
    push, drag = 3e-3, 0.02
    run_well(GROUND, tmp_path, [
        *steps(4), "Tissues/block/Neo-Hooke/a=230",
        "Boundary conditions/Names=mud, push",
        *condition("mud", "drag", "z min", Along_the_surface=drag,
                   Against_the_surface=drag),
        *condition("push", "dead traction", "z min", Traction=f"{push}; 0; 0")])
    found = energy(tmp_path, since=0.25)
    check_balance(found)
    expected = push * push / drag * 0.75
    assert found["boundary condition", "push"] == pytest.approx(expected, rel=1e-6)
    assert found["boundary condition", "mud"] == pytest.approx(-expected, rel=1e-6)


def test_restart_and_new_meshes(tmp_path):
    """Rows are of one step each, so that a run that goes on has the same; what a new
    mesh stores less is a row of its own."""
    settings = [*steps(8), "Adaptivity/Every=2", "Time/End=0.375",
                "Boundary conditions/top/displacement/Components=x, y, z",
                "Boundary conditions/ground/contact/Friction=0.3, 0.3, 0.3"]
    run_well(GROUND, tmp_path / "whole", settings)
    run_well(GROUND, tmp_path / "cut", [*settings, "Time/End=0.25"])
    go_on(tmp_path / "cut", ["Time/End=0.375"], ranks=2)
    whole, cut = (energy(tmp_path / name) for name in ("whole", "cut"))
    assert whole.keys() == cut.keys()
    for key, value in whole.items():
        assert cut[key] == pytest.approx(value, rel=1e-7, abs=1e-12), key
    assert whole["adaptation", "mesh"] < 0
    check_balance(whole)
    assert math.isfinite(whole["balance", "balance"])


def test_not_there_unless_asked_for(tmp_path):
    run_well(GROUND, tmp_path)
    assert not (tmp_path / "energy.csv").exists()
