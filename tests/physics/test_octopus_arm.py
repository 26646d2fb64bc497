# SPDX-License-Identifier: LGPL-2.1-or-later
"""A muscular hydrostat: a uniform cylinder of muscle against its exact equations, and
the arm of an octopus on a coarse mesh, where it bends and twists to."""
import importlib.util
import math

import pytest
from lumbricus_run import SOURCE, run_well

ARM = SOURCE / "parameters" / "octopus_arm"
CASE = ARM / "case.prm"
TISSUES = ("nerve cord", "transverse muscle", "longitudinal muscle", "oblique muscle")
A, STRENGTH, BEST = 0.01, 0.26, 1.25
ACROSS = "dorsoventral", "lateral"
MUSCLES = *ACROSS, "longitudinal", "right oblique", "left oblique"
# Of hydrostat.py, for the activations below: degrees.
BEND, TWIST = 43.763, -41.603


def mesh(path, **measures):
    """The settings for a mesh of mesh.py."""
    spec = importlib.util.spec_from_file_location("mesh", ARM / "mesh.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.write(path, **measures)
    return [f"Geometry/mesh file/File={path}", "Output/Every=0"]


def active(**formulas):
    """The settings for all muscles, of which those that are not named are at rest."""
    formulas = {name.replace("_", " "): text for name, text in formulas.items()}
    return [f"Muscles/{muscle}/expression/Formula={formulas.get(muscle, 0)}"
            for muscle in MUSCLES]


def steps_of(size, end=1):
    return [f"Time/End={end}", *(f"Time/{name}={size}" for name in (
        "First step", "Largest step", "Result interval"))]


def uniform(path):
    """A free cylinder all of whose tissue has all fibres along and across."""
    return [*mesh(path, base=3, tip=3, length=12, n_along=2),
            "Boundary conditions/Names=", "Output/Points=",
            *(f"Tissues/{tissue}/Muscles={', '.join(MUSCLES)}" for tissue in TISSUES)]


def blemker(x):
    far = abs(x - 1)
    return 1 - 4 * far**2 if far < 0.4 else 9 * max(0, 0.6 - far)**2


def hill(v, fastest=2.43, k=1.45, N=1.8):
    w = v / fastest
    if w < 0:
        return max(0, (1 + w) / (1 - w / k))
    return N - (N - 1) / (1 + (1 + 1 / k) / (N - 1) * w)


def root(function, low, high):
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return middle


def force(l, across, along, speed=lambda m: 1):
    """The axial force over the section at rest: with the tension T_a of the fibres
    along, and T_c of each family across, at m = l^(-1/2),
    a (l - l^-2) + T_a - T_c l^(-3/2)."""
    m = l**-0.5
    return A * (l - l**-2) + STRENGTH * (
        along * blemker(l / BEST) - across * blemker(m) * speed(m) * l**-1.5)


def check_volume(run, tolerance=1e-12):
    rows = run.segments()
    for row in rows:
        assert row["wall_volume"] == pytest.approx(rows[0]["wall_volume"],
                                                   rel=tolerance)


@pytest.mark.parametrize("across, along, ranks", [(0.3, 0, 1), (0.2, 0.1, 2)])
def test_uniform_cylinder(tmp_path, across, along, ranks):
    run = run_well(CASE, tmp_path / "out", [
        *uniform(tmp_path / "cylinder.msh"), *steps_of(0.5),
        *active(dorsoventral=f"{across}*t", lateral=f"{across}*t",
                longitudinal=f"{along}*t")], ranks)
    l = root(lambda l: force(l, across, along), 0.5, 3)
    assert l > 1.1
    assert run.last()["length"] == pytest.approx(12 * l, rel=1e-9)
    assert run.last()["mid_radius"] / run.segments()[0]["mid_radius"] == \
        pytest.approx(l**-0.5, rel=1e-8)
    check_volume(run)


def test_uniform_cylinder_at_speed(tmp_path):
    """With force-velocity every step is a scalar equation for its rate."""
    curves = [f"Muscles/{muscle}/active stress/{key}={value}" for muscle in ACROSS
              for key, value in (("Force-velocity", "Hill"), ("Hill/Fastest", 2.43),
                                 ("Hill/Curvature", 1.45))]
    run = run_well(CASE, tmp_path / "out", [
        *uniform(tmp_path / "cylinder.msh"), *steps_of(0.05, end=0.2), *curves,
        *active(dorsoventral=0.2, lateral=0.2)])
    lengths = [row["length"] / 12 for row in run.segments()]
    assert len(lengths) == 5
    for before, l in zip(lengths, lengths[1:]):
        expected = root(lambda l: force(
            l, 0.2, 0, lambda m: hill((m - before**-0.5) / 0.05)), 0.5, 3)
        assert l == pytest.approx(expected, rel=1e-8)
    # At no speed it would be 1.83 times as long.
    assert lengths[1] < lengths[-1] < root(lambda l: force(l, 0.2, 0), 0.5, 3) - 0.1


class Arm:
    """The end of a run on a coarse mesh: where the points are, and the axis at the
    tip as the points across it turn."""

    def __init__(self, folder, **formulas):
        self.run = run_well(CASE, folder, [
            *mesh(folder.with_suffix(".msh"), n_along=8), *steps_of(0.5),
            *active(**formulas)])
        check_volume(self.run)
        self.points = [[row[c] + row["u" + c] for c in "xyz"] for row in
                       self.run.table("points.csv") if row["t"] == 1]
        above, below, left, right = self.points[:4]
        up, side = ([a - b for a, b in zip(*pair)] for pair in
                    ((above, below), (left, right)))
        self.bend = math.degrees(math.atan2(-up[0], up[2]))
        self.twist = math.degrees(math.atan2(side[2], side[1]))
        self.tip = self.points[8]


def test_transverse_muscle_makes_it_long(tmp_path):
    arm = Arm(tmp_path / "arm", dorsoventral="0.4*t", lateral="0.4*t")
    # As a slender bar, but for the base, which cannot become thin.
    assert arm.run.last()["length"] / 80 == pytest.approx(1.6437, rel=0.005)
    assert arm.bend == pytest.approx(0, abs=1e-6)
    assert arm.twist == pytest.approx(0, abs=1e-6)


def test_longitudinal_muscle_of_one_side_bends_it_there(tmp_path):
    angles = []
    for side in "><":
        arm = Arm(tmp_path / f"arm{'<>'.index(side)}",
                  dorsoventral="0.01*t", lateral="0.01*t",
                  longitudinal=f"z {side} 0 ? 0.01*t : 0")
        angles.append(arm.bend)
        assert arm.tip[2] * (1 if side == ">" else -1) > 10
        assert abs(arm.tip[1]) < 1e-6 and abs(arm.twist) < 1e-6
    assert angles[0] == pytest.approx(BEND, rel=0.03)
    assert angles[1] == pytest.approx(-angles[0], rel=1e-6)


def test_one_oblique_muscle_twists_it(tmp_path):
    right, left, both = (
        Arm(tmp_path / name, **formulas) for name, formulas in (
            ("right", {"right_oblique": "0.01*t"}),
            ("left", {"left_oblique": "0.01*t"}),
            ("both", {"right_oblique": "0.01*t", "left_oblique": "0.01*t"})))
    # A right-handed screw that shortens turns its tip against it.
    assert right.twist == pytest.approx(TWIST, rel=0.03)
    assert left.twist == pytest.approx(-right.twist, rel=1e-6)
    assert both.twist == pytest.approx(0, abs=1e-6)
    assert both.run.last()["length"] > 80.1
