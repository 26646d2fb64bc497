# SPDX-License-Identifier: LGPL-2.1-or-later
"""Muscles that pull: bars and a liquid-filled tube against closed forms, and the
work that they do."""
import csv
import math
import pathlib

import pytest
from lumbricus_run import go_on, run_well
from test_energy import check_balance, energy, extrapolated, steps
from test_invariance import TO_THE_END

HERE = pathlib.Path(__file__).parent
A = 0.23
RANKS = pytest.mark.parametrize("ranks", [1, 2])


def pulls(muscle, strength, kind="nominal", activation="t", **curves):
    """Settings of a muscle of active stress."""
    section = f"Muscles/{muscle}"
    return [f"{section}/Action=active stress",
            f"{section}/Activation=expression",
            f"{section}/expression/Formula={activation}",
            f"{section}/active stress/Strength={strength}",
            f"{section}/active stress/Kind={kind}",
            *(f"{section}/active stress/{key}={value}"
              for key, value in curves.items())]


def bar(*muscles, a=A, **loads):
    """Settings of a bar along x of that stiffness, with these muscles m0, m1, ..."""
    settings = [f"Tissues/bar/Neo-Hooke/a={a}", "Tissues/bar/Muscles=" + ", ".join(
        f"m{i}" for i in range(len(muscles)))]
    for i, muscle in enumerate(muscles):
        settings += [f"Muscles/m{i}/Fibres=longitudinal", *muscle]
    for name, value in loads.items():
        key = "Displacement" if name == "displacement" else "Traction"
        kind = "displacement" if name == "displacement" else "dead traction"
        section = "Boundary conditions/end"
        settings += ["Boundary conditions/Names=end", f"{section}/Boundary=x max",
                     f"{section}/Type={kind}", f"{section}/{kind}/{key}={value}; 0; 0"]
        if name == "displacement":
            settings.append(f"{section}/displacement/Components=x")
    return settings


def root(function, low, high):
    """Where a function goes from less to more than zero."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return middle


def passive(l, a=A):
    """The nominal stress of the bar."""
    return a * (l - l**-2)


def blemker(x):
    """Of the length over the best length."""
    far = abs(x - 1)
    return 1 - 4 * far**2 if far < 0.4 else 9 * max(0, 0.6 - far)**2


BLEMKER = {"Force-length": "Blemker"}


@RANKS
@pytest.mark.parametrize("kind, strength, curves, length", [
    ("second Piola", 0.05, {}, 0.9365333953),
    ("second Piola", 0.1, {}, 0.8866209017),
    ("second Piola", 0.23, {}, 0.7937005260),
    ("second Piola", 1, {}, 0.5718396191),
    ("nominal", 0.05, {}, 0.9325347784), ("nominal", 0.1, {}, 0.8740826952),
    ("nominal", 0.23, {}, 0.7548776662),
    ("nominal", 0.1, BLEMKER, 0.8803639702),
    ("nominal", 0.23, BLEMKER, 0.7883285140),
    ("nominal", 0.5, BLEMKER, 0.6958401084)])
def test_free_bar(tmp_path, kind, strength, curves, length, ranks):
    """Lengths as computed elsewhere."""
    result = run_well(HERE / "bar.prm", tmp_path,
                      bar(pulls("m0", strength, kind, **curves)), ranks)
    assert result.last()["length"] == pytest.approx(length, rel=1e-9)


@pytest.mark.parametrize("kind", ["nominal", "second Piola"])
def test_held_bar_has_the_strength_as_its_stress(tmp_path, kind):
    result = run_well(HERE / "bar.prm", tmp_path, [
        *bar(pulls("m0", "s*0.15/n", kind), displacement=0),
        "Output/Points=0.5, 0.5, 0.5"])
    point = result.table("points.csv")[-1]
    assert point["sxx"] == pytest.approx(0.15, rel=1e-9)
    for stress in ("syy", "szz", "sxy"):
        assert abs(point[stress]) < 1e-9


def test_both_actions_in_one_tissue(tmp_path):
    """A fibre whose stress-free length is L = 0.8 and one that pulls with T:
    a (l/L^2 - L/l^2) + T f_l(l/best) = 0."""
    short, tension, best = 0.8, 0.05, 1.1
    settings = bar(
        ["Muscles/m0/Active stretch=expression",
         f"Muscles/m0/expression/Formula=1 + ({short} - 1)*t"],
        pulls("m1", tension, **BLEMKER, **{"Blemker/Best length": best}))
    result = run_well(HERE / "bar.prm", tmp_path, settings)
    expected = root(lambda l: A * (l / short**2 - short / l**2)
                    + tension * blemker(l / best), 0.5, 1)
    assert result.last()["length"] == pytest.approx(expected, rel=1e-9)


def test_curve_of_a_file(tmp_path):
    """At a row of the file the part is that of the row."""
    file = tmp_path / "curve.csv"
    file.write_text("# of a muscle\nl, f_l\n0.4, 0\n0.8, 0.9\n1, 1\n1.6, 0\n")
    strength = -passive(0.88) / 0.9
    result = run_well(HERE / "bar.prm", tmp_path / "out", bar(pulls(
        "m0", repr(strength), **{"Force-length": "file", "file/File": file,
                                 "file/Best length": 1.1})))
    assert result.last()["length"] == pytest.approx(0.88, rel=1e-9)


@pytest.mark.parametrize("liquid", ["cavity", "meshed"])
@pytest.mark.parametrize("tension, length, pressure", [
    (0.1, 1.0677675831, 8.9261166295e-3), (0.23, 1.1447142426, 1.9150055569e-2)])
def test_tube_full_of_liquid(tmp_path, tension, length, pressure, liquid):
    """A muscle around a tube with pistons as its ends, which the liquid pushes apart:
    at the length without an end force the pressure is (T/l) ln(B/A)."""
    result = run_well(HERE / "pistons.prm", tmp_path, [
        *pulls("circular", tension, "second Piola"),
        f"Boundary conditions/rear/displacement/Displacement=2*{length - 1}*t; 0; 0",
        f"Geometry/open cylinder/Liquid={liquid}", "Output/Every=0",
        *(["Tissues/liquid/Neo-Hooke/a=2.3e-6"] if liquid == "meshed" else []),
        "Geometry/open cylinder/Cells around a quarter=4"])
    assert result.segments()[-1]["fluid_pressure"] == pytest.approx(
        pressure, rel=2e-5)
    with open(result.folder / "reactions.csv") as file:
        force = [4 * float(row["force_x"]) for row in csv.DictReader(file)
                 if row["name"] == "rear"][-1]
    wall = math.pi * (3.3**2 - 3**2)
    assert abs(force) < 2e-4 * tension * wall


K, FASTEST, N = 0.25, 2., 1.8
HILL = {"Force-velocity": "Hill", "Hill/Fastest": FASTEST}


def hill(v):
    """The part of its tension that a fibre has at a rate of its stretch."""
    w = v / FASTEST
    if w < 0:
        return max(0, (1 + w) / (1 - w / K))
    return N - (N - 1) / (1 + (1 + 1 / K) / (N - 1) * w)


def isotonic(load, a, tension=0.1):
    """A bar of a soft tissue with a constant force at its end."""
    return [*bar(pulls("m0", tension, activation="1", **HILL), a=a, traction=load),
            "Time/End=0.2", "Time/First step=0.05", "Time/Largest step=0.05"]


@RANKS
@pytest.mark.parametrize("load", [0.02, 0.05, 0.09, 0.12, 0.15])
def test_isotonic_bar_goes_at_the_speed_of_hill(tmp_path, load, ranks):
    """(T + k T0)(v + k v_max) = (1 + k) T0 k v_max where it shortens; where the load
    is more than T0 it gets longer."""
    tension, a = 0.1, 1e-3
    rows = run_well(HERE / "bar.prm", tmp_path, isotonic(load, a), ranks).segments()
    lengths = [row["length"] for row in rows]
    assert len(lengths) == 5
    for before, now in zip(lengths, lengths[1:]):
        v = (now - before) / 0.05
        part = (load - passive(now, a)) / tension
        assert hill(v) == pytest.approx(part, abs=1e-8)
        if load < tension:
            assert v == pytest.approx(
                -FASTEST * (1 - part) / (1 + part / K), rel=1e-7)
        else:
            assert v > 0


def test_speed_is_that_since_the_last_step(tmp_path):
    """Whether the step was cut or not, on any number of ranks, and after a restart:
    all go through the same lengths."""
    settings = [*isotonic("0.02 + 0.1*t", 0.05), *TO_THE_END]
    whole = run_well(HERE / "bar.prm", tmp_path / "whole", settings)
    run_well(HERE / "bar.prm", tmp_path / "cut", [*settings, "Time/End=0.1"])
    go_on(tmp_path / "cut", ["Time/End=0.2"])
    one = whole.segments()
    with open(tmp_path / "cut" / "segments.csv") as file:
        other = list(csv.DictReader(file))
    assert len(one) == len(other) == 5
    for row, again in zip(one, other):
        assert float(again["length"]) == pytest.approx(row["length"], rel=1e-12)
    two = run_well(HERE / "bar.prm", tmp_path / "two", settings, 2)
    for row, again in zip(one, two.segments()):
        assert again["length"] == pytest.approx(row["length"], rel=1e-9)


def test_speed_on_a_mesh_that_changes(tmp_path):
    """The state is solved for again on the new mesh, with the speed that it had."""
    adaptive = ["Adaptivity/Every=1", "Adaptivity/Marking=fraction of cells",
                "Adaptivity/fraction of cells/Refine=0.3"]
    lengths = [[row["length"] for row in run_well(
        HERE / "bar.prm", tmp_path / name, [*isotonic(0.03, 0.05), *more]).segments()]
        for name, more in (("fixed", []), ("adaptive", adaptive))]
    assert lengths[1] == pytest.approx(lengths[0], rel=1e-8)


@pytest.mark.parametrize("kind, curves, order", [
    ("nominal", {}, 2), ("second Piola", BLEMKER, 2), ("nominal", HILL, 1)])
def test_work(tmp_path, kind, curves, order):
    """What a muscle that shortens stores in the tissue and lifts it does; what is left
    of the balance is due to the length of the steps."""
    load, found = 0.02, {}
    for n in (8, 16):
        folder = tmp_path / str(n)
        run_well(HERE / "bar.prm", folder, [
            *bar(pulls("m0", 0.1, kind, **curves), traction=f"{load}*t"), *steps(n)])
        found[n] = energy(folder)
        check_balance(found[n])
        assert found[n]["muscle", "m0"] > 0
    balance = "balance", "balance"
    assert found[8][balance] / found[16][balance] == pytest.approx(2**order, rel=0.15)
    assert abs(found[16][balance]) < 0.05 * found[16]["muscle", "m0"]
    stored, lifted = (found[16][key] for key in (
        ("stored", "tissues"), ("boundary condition", "end")))
    if order == 2:
        muscle = extrapolated(*(found[n]["muscle", "m0"] for n in (8, 16)))
        done = extrapolated(*(found[n]["boundary condition", "end"] for n in (8, 16)))
        assert muscle == pytest.approx(stored - done, rel=1e-5)
    assert lifted < 0
