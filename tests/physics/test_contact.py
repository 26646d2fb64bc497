# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact and friction against closed forms: a patch, tubes in burrows, blocks that
are dragged or lie on a slope, a ball pressed into a block, a bar that is pulled
over what holds it, and a muscle that crawls."""
import math
import pathlib

import numpy as np
import pytest
from lumbricus_run import run, run_well
from test_contact_output import (
    condition, conditions, contacts, reactions, table)

HERE = pathlib.Path(__file__).parent
GROUND = HERE / "ground.prm"
TUBE = HERE / "tube.prm"
PISTONS = HERE / "pistons.prm"
RANKS = pytest.mark.parametrize("ranks", [1, 2])
A = 0.23


def in_one_step(n=1):
    return [f"Time/First step={1 / n}", f"Time/Largest step={1 / n}"]


@pytest.mark.parametrize("stiffness, stress", [
    (1, 0.0877015844), (10, 0.1579597522), (100, 0.1734230808)])
def test_penalty(tmp_path, stiffness, stress):
    """Pressed onto a plane by a fifth of its height it penetrates by d, where
    a (l^-2 - l) = eps d, l = 0.8 + d."""
    run_well(GROUND, tmp_path, [
        f"Boundary conditions/ground/contact/Stiffness={stiffness}",
        "Boundary conditions/ground/contact/Penetration=1"])
    force = reactions(tmp_path)[1, "ground"]
    assert force[2] == pytest.approx(stress, abs=1e-10)
    contact = contacts(tmp_path)[-1]
    assert contact["penetration"] == pytest.approx(stress / stiffness, rel=1e-8)


@RANKS
def test_augmented(tmp_path, ranks):
    run_well(GROUND, tmp_path,
             ["Boundary conditions/ground/contact/Penetration=1e-8"], ranks)
    force = reactions(tmp_path)[1, "ground"]
    assert force[2] == pytest.approx(A * (0.8**-2 - 0.8), rel=1e-7)


# A thick tube of mu = 1 in plane strain, inner and outer radius 1 and 1.5, blown
# into a smooth burrow: a quarter, so that forces are those of a quarter.
def in_burrow(radius, pressure, cells, *more):
    geometry = "Geometry/open cylinder/"
    return [f"{geometry}Radius=1", f"{geometry}Length=1",
            f"{geometry}Wall layer thicknesses=0.5",
            f"{geometry}Cells around a quarter={cells}",
            f"{geometry}Cells across each wall layer={cells}",
            "Tissues/wall/Law=Neo-Hooke", "Tissues/wall/Neo-Hooke/a=1",
            f"Boundary conditions/inflation/follower pressure/Pressure={pressure}*min(1, t)",
            "Boundary conditions/Names=inflation, front, rear, burrow",
            *condition("burrow", "contact", "skin", Obstacle="burrow",
                       Penetration=1e-7),
            f"Boundary conditions/burrow/contact/burrow/Radius={radius}",
            "Output/Points=0.5, 1, 0", *in_one_step(2), *more]


BURROWS = [(1.75, 0.6, 0.36531226), (1.6, 1, 0.87175122), (2, 1, 0.68244980)]


@pytest.mark.parametrize("radius, pressure, expected", BURROWS)
def test_tube_in_burrow(tmp_path, radius, pressure, expected):
    """The wall carries P - p_c = int (b^2 - a^2) ..., and what is left presses on
    the burrow; order 4 at least between meshes that are fine enough."""
    errors, radii = [], []
    for cells in (2, 4, 8):
        folder = tmp_path / str(cells)
        run_well(TUBE, folder, in_burrow(radius, pressure, cells))
        contact = contacts(folder)[-1]
        # Per area at rest, of the radius 1.5.
        found = contact["normal_force"] / (0.5 * math.pi * 1.5)
        errors.append(abs(found * 1.5 / radius - expected))
        radii.append(1 + table(folder, "points.csv")[-1]["uy"])
    assert errors[2] < 1e-5
    assert math.log2(errors[1] / errors[2]) > 3.5
    assert radii[2] == pytest.approx(math.sqrt(radius**2 - 1.25), abs=1e-5)


@RANKS
def test_pulled_through_burrow(tmp_path, ranks):
    """The burrow that moves along pulls with mu p_c times the area it touches: mu
    is small, since the ends of the tube, which are held, feel the shear."""
    mu = 0.03
    run_well(TUBE, tmp_path, in_burrow(
        1.75, 0.6, 4,
        f"Boundary conditions/burrow/contact/Friction={mu}, {mu}, {mu}",
        "Boundary conditions/burrow/contact/burrow/Point=max(0, t - 1); 0; 0",
        "Time/End=2"), ranks)
    force = reactions(tmp_path)[2, "burrow"]
    expected = mu * 2 * math.pi * 1.75 * 0.36531226
    assert 4 * force[0] == pytest.approx(expected, rel=1e-4)


def test_filled_tube_in_burrow(tmp_path):
    """A tube whose longitudinal muscle contracts to 0.7 is as long as (B/R_b)^2,
    its ends free of forces, when the liquid presses as the burrow does."""
    length, pressure = 0.9578995020, 2.7236106042e-2
    run_well(PISTONS, tmp_path, [
        "Geometry/open cylinder/Radius=2",
        "Geometry/open cylinder/Cells around a quarter=6",
        "Geometry/open cylinder/Wall layers=longitudinal layer, circular layer",
        "Geometry/open cylinder/Wall layer thicknesses=0.15, 0.15",
        "Tissues/longitudinal layer/Muscles=longitudinal",
        "Tissues/longitudinal layer/Neo-Hooke/a=0.23",
        "Muscles/longitudinal/Fibres=longitudinal",
        "Muscles/longitudinal/Active stretch=expression",
        "Muscles/longitudinal/expression/Formula=1 - 0.3*t",
        "Tissues/circular layer/Muscles=",
        "Cavities/Content=pressure",
        f"Cavities/pressure/Pressure={pressure}*t",
        "Boundary conditions/Names=front, rear, burrow",
        "Boundary conditions/rear/displacement/Displacement="
        f"2*({length} - 1)*t; 0; 0",
        *condition("burrow", "contact", "skin", Obstacle="burrow",
                   Penetration=1e-7),
        "Boundary conditions/burrow/contact/burrow/Radius=2.35"])
    contact = contacts(tmp_path)[-1]
    area = 0.5 * math.pi * 2.35 * 2 * length
    assert contact["normal_force"] / area == pytest.approx(pressure, rel=1e-4)
    ends = reactions(tmp_path)[1, "rear"][0]
    assert abs(ends) < 1e-4 * pressure * math.pi * 2.35**2 / 4


@pytest.mark.parametrize("depth, expected, levels, ranks", [
    (1e-3, 1.68654809e-4, 7, 1), (4e-3, 1.34923847e-3, 6, 2)])
def test_hertz(tmp_path, depth, expected, levels, ranks):
    """A ball of R 1 that is pressed into a block by d: 16/3 mu R^(1/2) d^(3/2), if
    the block is as large as this one, a quarter, is against the radius
    (R d)^(1/2) where they touch. Its corner there is cut into cells as small as
    half of that, and the rest is found by estimates of the error."""
    length = 6
    # The cell in the corner, whose centre is as far from all three faces.
    corner = (f"abs(x - y) + abs(x + z - {length}) < 1e-9 && "
              f"abs(log2(4*x/{length}) - rint(log2(4*x/{length}))) < 1e-6")
    run_well(GROUND, tmp_path, [
        f"Geometry/block/Lengths={length}, {length}, {length}",
        "Geometry/block/Symmetry=x, y", "Tissues/block/Neo-Hooke/a=1",
        f"Mesh/Local refinements={levels}", f"Mesh/Refine where={corner}",
        "Adaptivity/Every=1", "Adaptivity/Cycles=2",
        f"Adaptivity/Finest level={levels + 3}",
        "Boundary conditions/Names=ground, bottom",
        *condition("bottom", "displacement", "z min", Components="z"),
        *condition("ground", "contact", "z max", Obstacle="sphere",
                   Stiffness=1e3, Penetration=1e-6),
        "Boundary conditions/ground/contact/sphere/Centre="
        f"0; 0; {length} + 1 - {depth}*t", *in_one_step()], ranks)
    contact = contacts(tmp_path)[-1]
    assert contact["penetration"] < 0.01 * depth
    assert 4 * contact["area"] == pytest.approx(math.pi * depth, rel=0.1)
    assert 4 * contact["normal_force"] == pytest.approx(expected, rel=5e-3)


def dragged(mu, way, cells=2, load=1.):
    """A flat block that N presses onto the ground, whose top is dragged."""
    return ["Geometry/block/Lengths=4, 4, 1", f"Geometry/block/Cells={cells}, {cells}, 1",
            "Tissues/block/Neo-Hooke/a=23",
            f"Boundary conditions/ground/contact/Friction={mu}",
            *conditions(
                top=("displacement", "z max", {
                    "Components": "x, y", "Displacement": way}),
                press=("dead traction", "z max", {
                    "Traction": f"0; 0; -{load / 16}*min(1, 5*t)"})),
            *in_one_step(10)]


@pytest.mark.parametrize("mu, way, expected", [
    ("0.3, 0.6, 1.2", "0.3*max(t - 0.2, 0); 0; 0", (-0.6, 0)),
    ("0.3, 0.6, 1.2", "-0.3*max(t - 0.2, 0); 0; 0", (0.3, 0)),
    ("0.3, 0.6, 1.2", "0; max(t - 0.2, 0); 0", (0, -1.2)),
    # The ellipse.
    ("0.6, 0.6, 1.2", "max(t - 0.2, 0); max(t - 0.2, 0); 0",
     (-0.6 / math.sqrt(2), -1.2 / math.sqrt(2)))])
@RANKS
def test_dragged(tmp_path, mu, way, expected, ranks):
    run_well(GROUND, tmp_path, dragged(mu, way), ranks)
    force = reactions(tmp_path)[1, "ground"]
    assert force == pytest.approx(np.array([*expected, 1.]), abs=1e-9)


@pytest.mark.parametrize("part, rests", [(0.99, True), (1.01, False)])
def test_slope(tmp_path, part, rests):
    """It rests where the slope is less than mu, and slides away where it is
    more."""
    slope = part * 0.5
    angle = math.atan(slope)
    n = f"{math.sin(angle)}; 0; {math.cos(angle)}"
    # A block that is square to the slope, since gravity is what is tilted.
    result = run(GROUND, tmp_path, [
        "Geometry/block/Lengths=4, 4, 1", "Tissues/block/Density=1e-6",
        "Tissues/block/Neo-Hooke/a=23",
        "Boundary conditions/Names=ground",
        "Boundary conditions/ground/contact/Friction=0.5, 0.5, 0.5",
        "Body forces/Names=weight", "Body forces/weight/Type=weight",
        "Body forces/weight/weight/Gravity="
        + "; ".join(f"-9810*t*({c})" for c in n.split("; ")),
        "Time/Smallest step=0.05", *in_one_step(4)])
    assert (result.exit_code == 0) == rests, result.log + result.message
    if rests:
        force = reactions(tmp_path)[1, "ground"]
        assert force[0] / force[2] == pytest.approx(slope, rel=1e-8)
    else:
        assert "slide" in result.said() or "converge" in result.said() or \
            "diverges" in result.said() or "length" in result.said()


HELD_BY_MUCUS = [
    # A quarter, so thin that it is stretched alike from its middle to its skin.
    "Geometry/block/Lengths=20, 0.1, 0.1", "Geometry/block/Cells=80, 1, 1",
    "Geometry/block/Symmetry=y, z",
    # All around it, and never so near that it presses.
    *condition("ground", "contact", "z max", Obstacle="plane",
               Mucus_thickness=1e6),
    "Boundary conditions/ground/contact/plane/Point=0; 0; 2",
    "Boundary conditions/ground/contact/plane/Normal=0; 0; -1"]


def line_strength(forward, backward, slip):
    """Per mm of the bar and mm^2 of its section, 0.01 in this quarter, whose face is
    0.1 mm wide [N/mm^3]."""
    return [f"Boundary conditions/ground/contact/Shear strength={0.1 * forward}, "
            f"{0.1 * backward}, 0",
            f"Boundary conditions/ground/contact/Elastic slip={slip}"]


@RANKS
def test_pulled_bar(tmp_path, ranks):
    """The pull F reaches F/q far into a bar that sticks with q per length; when it
    is let go half of what slid slides back."""
    expected = {0.25: 0.0591074529, 0.625: 0.3804539649, 1.: 1.0033445215,
                2.: 0.4822098093}
    run_well(GROUND, tmp_path, [
        *HELD_BY_MUCUS, *line_strength(0.005, 0.005, 1e-4),
        "Boundary conditions/Names=ground, pull",
        *condition("pull", "dead traction", "x max",
                   Traction="0.08*(1 - abs(t - 1)); 0; 0"),
        "Output/Points=20, 0, 0", "Time/End=2",
        "Time/First step=0.125", "Time/Largest step=0.125"], ranks)
    found = {row["t"]: row["ux"] for row in table(tmp_path, "points.csv")}
    for t, u in expected.items():
        assert found[t] == pytest.approx(u, rel=1e-2)


def test_breathing_crawler(tmp_path):
    """A muscle that shortens to 0.8 and back, with a third of the friction forward:
    each time it comes forward by what its rear catches up."""
    slip = 1e-3
    run_well(GROUND, tmp_path, [
        *HELD_BY_MUCUS, *line_strength(0.002, 0.006, slip),
        "Boundary conditions/Names=ground",
        "Tissues/block/Muscles=fibres", "Muscles/fibres/Fibres=longitudinal",
        "Muscles/fibres/Active stretch=expression",
        "Muscles/fibres/expression/Formula=1 - 0.2*abs(sin(pi*t))",
        # Not 80, a quarter of which holds as much as the rest: then nothing says
        # where it lies.
        "Geometry/block/Cells=82, 1, 1", "Time/Result interval=1",
        "Time/End=2", "Time/First step=0.05", "Time/Largest step=0.05"])
    place = {row["t"]: row["stride"] for row in table(tmp_path, "body.csv")}
    assert place[2] - place[1] == pytest.approx(1.52879 - 8 / 3 * slip, rel=1e-2)


@pytest.mark.parametrize("forward, backward, expected, ranks", [
    (1, 4, 0.40653519, 1), (4, 1, -0.37955571, 2)])
def test_peristaltic_tube(tmp_path, forward, backward, expected, ranks):
    """Half a period of a tube of one wave, so thin that it is a line: what a worm of
    one dimension does on the same friction in the same steps (expected:
    benchmarks/peristaltic_tube, where a whole period and thicker ones are). Which way
    it goes is the friction's doing."""
    # 1e-3 N per mm of a tube that is ten times as thick.
    strength = 1e-4 / (2 * math.pi * 2.3)
    waves = [f"Muscles/{muscle}/wave/{entry}" for entry in (
        "Wavelength=5", "Ramp-in=0.25")
        for muscle in ("circular", "septal", "longitudinal")]
    run_well(HERE / "thin_tube.prm", tmp_path, [
        "Geometry/segment chain/Number of segments=5", *waves,
        "Boundary conditions/ground/contact/Shear strength="
        f"{forward * strength}, {backward * strength}, 0",
        "Time/End=0.75", "Time/Result interval=0.25", *in_one_step(16)], ranks)
    place = {row["t"]: row["stride"] for row in table(tmp_path, "body.csv")}
    assert place[0.75] - place[0.25] == pytest.approx(expected, rel=0.03)


def test_ranks(tmp_path):
    """A soft block, part of which slides and part of which sticks: the same on one,
    two and four ranks."""
    settings = [*dragged("0.3, 0.6, 1.2", "0.02*max(t - 0.2, 0); 0; 0", cells=4),
                "Tissues/block/Neo-Hooke/a=2.3", "Output/Points=0, 0, 0; 4, 0, 1"]
    found = []
    for ranks in (1, 2, 4):
        folder = tmp_path / str(ranks)
        run_well(GROUND, folder, settings, ranks)
        rows = contacts(folder)
        assert any(0 < row["sliding"] < 1 for row in rows)
        points = table(folder, "points.csv")
        found.append([[row[name] for row in rows
                       for name in ("normal_force", "friction_x", "sliding")],
                      [row[name] for row in points for name in ("ux", "uz")]])
    for other in found[1:]:
        for values, expected in zip(other, found[0]):
            scale = max(abs(value) for value in expected)
            assert values == pytest.approx(expected, rel=1e-9, abs=1e-9 * scale)
