# SPDX-License-Identifier: LGPL-2.1-or-later
"""A muscular tube between two frictionless pistons, the liquid in it without cells,
against a closed form.

The liquid and the wall keep their volumes, so that at a length stretch l all radii
are those at rest over sqrt(l). Muscles make the wall G = diag(G_r, G_theta, G_z);
with e = 1/G^2, D = (e_theta - e_r)/l, the radii A and B of a layer and mu = a the
balance across and along the axis is

    P = sum mu D ln(B/A),
    T = sum pi (B^2 - A^2) mu (l e_z - (e_r + e_theta)/(2 l^2)),

T of the wall and the liquid together, as the pistons feel it.
"""
import csv
import math
import pathlib

import pytest
from lumbricus_run import run, run_well

HERE = pathlib.Path(__file__).parent
A = 0.23


def closed_form(layers, stretch=None):
    """l, P and T of layers (inner radius, outer radius, what is active, lambda); l
    is that without T where it is not given."""
    parts = []
    for inner, outer, what, active in layers:
        G = [active**-0.5] * 3
        G["r theta z".split().index(what)] = active
        parts.append((inner, outer, [g**-2 for g in G]))

    def area(inner, outer):
        return math.pi * (outer**2 - inner**2)
    stretch = stretch or (
        sum(area(i, o) * (e[0] + e[1]) / 2 for i, o, e in parts)
        / sum(area(i, o) * e[2] for i, o, e in parts))**(1 / 3)
    pressure = sum(A * (e[1] - e[0]) / stretch * math.log(o / i)
                   for i, o, e in parts)
    force = sum(area(i, o) * A * (stretch * e[2]
                                  - (e[0] + e[1]) / (2 * stretch**2))
                for i, o, e in parts)
    return stretch, pressure, force


def circular(active):
    return [(3, 3.3, "theta", active)]


def antagonists(longitudinal, active):
    return [(2, 2.15, "z", longitudinal), (2.15, 2.3, "theta", active)]


# Layers, the prescribed length stretch or None, and l, P or T as computed elsewhere.
CASES = {
    "0.9": (circular(0.9), None, (1.0584714697, 6.9290267895e-3)),
    "0.8": (circular(0.8), None, (1.1387208645, 1.4678770983e-2)),
    "0.7": (circular(0.7), None, (1.2509807657, 2.3495558999e-2)),
    "0.6": (circular(0.6), None, (1.4119411948, 3.3811471922e-2)),
    "0.5": (circular(0.5), None, (1.6509636244, 4.6472674265e-2)),
    "two layers": (antagonists(1, 0.8), None, (1.0685434565, 1.1068819474e-2)),
    "both": (antagonists(0.7, 0.8), None, (0.8787053330, 1.3460160279e-2)),
    "strong": (antagonists(1, 0.6), None, (1.1959334611, 2.8246210430e-2)),
    "longitudinal": (antagonists(0.8, 1), None, (0.8923646370, 0)),
    "as long": (circular(0.8), 1, (1, 1.6715022783e-2, -0.52065418698)),
    "longer": (circular(0.8), 1.2, (1.2, 1.3929185653e-2, 0.19076427999)),
    "shorter": (circular(0.8), 0.8, (0.8, 2.0893778479e-2, -1.6465688663))}


def pressure_and_force(folder, name, settings=(), ranks=1):
    """P, and T at both ends, of the whole cross-section."""
    layers, given, _ = CASES[name]
    stretch = closed_form(layers, given)[0]
    settings = [
        f"Boundary conditions/rear/displacement/Displacement="
        f"2*({stretch!r} - 1)*t; 0; 0",
        f"Muscles/circular/expression/Formula=1 - (1 - {layers[-1][3]})*t",
        *settings]
    if len(layers) > 1:
        settings += [
            "Geometry/open cylinder/Radius=2",
            "Geometry/open cylinder/Wall layers="
            "longitudinal layer, circular layer",
            "Geometry/open cylinder/Wall layer thicknesses=0.15, 0.15",
            "Tissues/longitudinal layer/Muscles=longitudinal",
            f"Tissues/longitudinal layer/Neo-Hooke/a={A}",
            "Muscles/longitudinal/Fibres=longitudinal",
            "Muscles/longitudinal/Active stretch=expression",
            f"Muscles/longitudinal/expression/Formula="
            f"1 - (1 - {layers[0][3]})*t"]
    result = run_well(HERE / "pistons.prm", folder, settings, ranks)
    rows = result.segments()
    assert rows[-1]["fluid_volume"] == pytest.approx(rows[0]["fluid_volume"],
                                                     rel=1e-10)
    with open(result.folder / "reactions.csv") as file:
        forces = {row["name"]: float(row["force_x"])
                  for row in csv.DictReader(file) if float(row["t"]) == 1}
    # The cavity pulls at nothing but its own pistons.
    assert abs(forces["cavities"]) < 1e-12 and abs(forces["sum"]) < 1e-12
    of_whole = [n for section, n in (("full", 1), ("half", 2))
                if any(setting.endswith("=" + section) for setting in settings)]
    parts = of_whole[0] if of_whole else 4
    return (rows[-1]["fluid_pressure"], parts * forces["rear"],
            -parts * forces["front"])


def errors(folder, name, refinements):
    """Of P and of T at both ends, relative to P and to what the ends of the wall
    alone would feel where T is zero."""
    layers, given, _ = CASES[name]
    _, pressure, force = closed_form(layers, given)
    P, *forces = pressure_and_force(
        folder, name, [f"Mesh/Global refinements={refinements}"])
    scale = abs(force) if given else math.pi * layers[0][0]**2 * 0.01
    return [abs(P - pressure) / (pressure or 0.01),
            *[abs(T - force) / scale for T in forces]]


@pytest.mark.parametrize("name", CASES)
def test_closed_form(tmp_path, name):
    """On a mesh of four cells: two around a quarter, whose volume is wrong by
    1e-3."""
    layers, given, numbers = CASES[name]
    for value, number in zip(closed_form(layers, given), numbers, strict=False):
        assert value == pytest.approx(number, rel=1e-9, abs=1e-12)
    of_pressure, *of_forces = errors(tmp_path, name, 0)
    assert of_pressure < 2e-6
    assert max(of_forces) < (1e-3 if given else 4e-6)


@pytest.mark.parametrize("name", ["0.8", "shorter"])
def test_order(tmp_path, name):
    parts = [errors(tmp_path / str(refinements), name, refinements)
             for refinements in range(3)]
    print(name, parts)
    for coarse, fine in zip(parts[1], parts[2], strict=True):
        assert math.log2(coarse / fine) > 3.5
    assert max(parts[2]) < 1e-5


def test_sections_and_ranks(tmp_path):
    expected = pressure_and_force(tmp_path / "quarter", "longer")
    for ranks, section in ((2, "half"), (1, "full")):
        parts = pressure_and_force(tmp_path / section, "longer", [
            f"Geometry/open cylinder/Cross-section={section}"], ranks)
        assert parts == pytest.approx(expected, rel=1e-9)


def test_the_rubber_fluid_comes_to_the_same(tmp_path):
    """It has ends of its own, whose forces belong to those of the pistons."""
    cavity = pressure_and_force(tmp_path / "cavity", "longer")
    of_liquid = [
        "Boundary conditions/Names=front, rear, front of liquid, rear of liquid"]
    for end, boundary in (("front", "head"), ("rear", "tail")):
        section = f"Boundary conditions/{end} of liquid/"
        of_liquid += [section + f"Boundary={boundary} of the liquid",
                      section + "Type=displacement",
                      section + "displacement/Components=x"]
    of_liquid.append(section + "displacement/Displacement=2*(1.2 - 1)*t; 0; 0")
    rubber = run_well(HERE / "pistons.prm", tmp_path / "rubber", [
        "Geometry/open cylinder/Liquid=meshed", *of_liquid,
        "Boundary conditions/rear/displacement/Displacement="
        "2*(1.2 - 1)*t; 0; 0", "Reset/Tolerance=1e-5"])
    assert rubber.last()["fluid_pressure"] == pytest.approx(cavity[0], rel=1e-4)
    with open(rubber.folder / "reactions.csv") as file:
        forces = {row["name"]: 4 * float(row["force_x"])
                  for row in csv.DictReader(file) if float(row["t"]) == 1}
    for sign, end, force in ((1, "rear", cavity[1]), (-1, "front", cavity[2])):
        assert sign * (forces[end] + forces[end + " of liquid"]) == \
            pytest.approx(force, rel=1e-4)


@pytest.mark.parametrize("settings, parts", [
    (["Boundary conditions/Names=front"],
     ["'tail'", "not prescribed there", "'displacement'"]),
    (["Boundary conditions/rear/displacement/Components=y"],
     ["'tail'", "not prescribed there", "'Components' have x"]),
    (["Boundary conditions/rear/displacement/Displacement=0.1*z*t; 0; 0"],
     ["'tail'", "not the same all over", "on t only"]),
    (["Geometry/open cylinder/Filled=false"],
     ["'Geometry/open cylinder/Liquid'", "'Filled' to true"]),
    (["Boundary conditions/rear/Boundary=inside"],
     ["'inside'", "'head', 'tail', 'skin'"])])
def test_mistakes(tmp_path, settings, parts):
    result = run(HERE / "pistons.prm", tmp_path, settings)
    assert result.exit_code == 1
    for part in parts:
        assert part in result.said()
