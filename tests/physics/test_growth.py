# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tissues that grow: a block alone, a ring in a tube that does not grow, and a
sphere around liquid, against closed forms."""
import csv
import pathlib

import pytest
from lumbricus_run import SOURCE, go_on, run_well
from test_energy import check_balance, energy, steps
from test_invariance import TO_THE_END

HERE = pathlib.Path(__file__).parent
A = 0.23


def growth(muscle, formula, kind="growth", fibres="longitudinal"):
    """Settings of a muscle that is growth."""
    section = f"Muscles/{muscle}"
    return [f"{section}/Fibres={fibres}", f"{section}/Action={kind}",
            f"{section}/Growth=expression",
            f"{section}/expression/Formula={formula}"]


def grown_bar(formula, kind="growth"):
    return ["Tissues/bar/Muscles=g", f"Tissues/bar/Neo-Hooke/a={A}",
            "Output/Points=1, 1, 1", *growth("g", formula, kind)]


@pytest.mark.parametrize("law", ["Neo-Hooke", "Mooney-Rivlin", "Yeoh"])
@pytest.mark.parametrize("theta", [0.7, 1.3])
def test_free_block(tmp_path, law, theta):
    """All lengths are theta times as large, and there is no stress."""
    run = run_well(HERE / "bar.prm", tmp_path, [
        *[setting for setting in grown_bar(f"1 + ({theta} - 1)*t")
          if "Neo-Hooke" not in setting], f"Tissues/bar/Law={law}"])
    assert run.last()["length"] == pytest.approx(theta, rel=1e-10)
    rows, point = run.segments(), run.table("points.csv")[-1]
    assert rows[-1]["wall_volume"] / rows[0]["wall_volume"] == pytest.approx(
        theta**3, rel=1e-10)
    for direction in "xyz":
        assert point["u" + direction] == pytest.approx(theta - 1, rel=1e-9)
    for stress in ("sxx", "syy", "szz", "sxy", "sxz", "syz"):
        assert abs(point[stress]) < 1e-9


def test_along_fibres(tmp_path):
    """Only the length along them changes, and the volume as it does."""
    run = run_well(HERE / "bar.prm", tmp_path,
                   grown_bar("1 + 0.5*t", "growth along fibres"))
    point = run.table("points.csv")[-1]
    assert point["ux"] == pytest.approx(0.5, rel=1e-9)
    for zero in ("uy", "uz", "sxx", "syy", "szz"):
        assert abs(point[zero]) < 1e-9


def integral(function, low, high, n=2000):
    """Simpson's rule."""
    h = (high - low) / n
    return h / 3 * sum(
        (1 if i in (0, n) else 4 if i % 2 else 2) * function(low + i * h)
        for i in range(n + 1))


# Plane strain: an inner layer that grows in one that does not.
INNER, BETWEEN, OUTER, THETA, MU, MU_OUTER = 1., 1.5, 2., 1.2, 1., 2.


def ring(a):
    """What is left of the balance across both layers with the inner radius a, and
    the radii between them and outside. With l_t = r/R, l_r = J_v/l_t:
    sigma_t - sigma_r = mu J_v^(-2/3) (l_t^2 - l_r^2), d sigma_r/dr of it over r."""
    total, inside = 0., a
    for low, high, J_v, mu in ((INNER, BETWEEN, THETA**3, MU),
                               (BETWEEN, OUTER, 1., MU_OUTER)):
        def rate(R):
            r = (inside**2 + J_v * (R**2 - low**2))**0.5
            l_t = r / R
            l_r = J_v / l_t
            return mu * J_v**(-2 / 3) * (l_t**2 - l_r**2) * l_r / r
        total += integral(rate, low, high)
        inside = (inside**2 + J_v * (high**2 - low**2))**0.5
        if low == INNER:
            between = inside
    return total, between, inside


def ring_radii():
    low, high = 0.5, 2.
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if ring(middle)[0] < 0 else (low, middle)
    return (low, *ring(low)[1:])


def ring_settings(cells):
    cylinder = "Geometry/open cylinder"
    held = [setting for end, boundary in (("front", "head"), ("rear", "tail"))
            for setting in (f"Boundary conditions/{end}/Boundary={boundary}",
                            f"Boundary conditions/{end}/Type=displacement",
                            f"Boundary conditions/{end}/displacement/Components=x")]
    return ["Geometry/Shape=open cylinder", f"{cylinder}/Radius={INNER}",
            f"{cylinder}/Length=1", f"{cylinder}/Wall layers=ring, tube",
            f"{cylinder}/Wall layer thicknesses={BETWEEN - INNER}, {OUTER - BETWEEN}",
            f"{cylinder}/Filled=false", f"{cylinder}/Cross-section=quarter",
            f"{cylinder}/Cells around a quarter={cells}",
            f"{cylinder}/Cells across each wall layer={cells}",
            f"{cylinder}/Cells along the cylinder=2",
            f"Tissues/ring/Neo-Hooke/a={MU}", f"Tissues/tube/Neo-Hooke/a={MU_OUTER}",
            "Tissues/ring/Muscles=g", *growth("g", f"1 + ({THETA} - 1)*t"),
            "Boundary conditions/Names=front, rear", *held,
            f"Output/Points=0.5, {INNER}, 0; 0.5, {BETWEEN}, 0; 0.5, {OUTER}, 0",
            "Time/First step=0.25", "Time/Largest step=0.25"]


@pytest.fixture(name="empty")
def fixture_empty(tmp_path):
    """A file whose run is all in settings."""
    file = tmp_path / "ring.prm"
    file.write_text("subsection Linear solver\n  set Method = direct\nend\n"
                    "subsection Output\n  set Every = 0\nend\n")
    return file


def radii(run):
    rows = run.table("points.csv")[-3:]
    return [R + row["uy"] for R, row in zip((INNER, BETWEEN, OUTER), rows)]


def test_ring_in_a_tube(empty, tmp_path):
    exact, errors = ring_radii(), []
    for cells in (4, 8):
        found = radii(run_well(empty, tmp_path / str(cells), ring_settings(cells)))
        errors.append(max(abs(r / e - 1) for r, e in zip(found, exact)))
    assert errors[1] < 1e-5
    assert errors[0] / errors[1] > 8


def test_ring_on_two_ranks_and_after_a_restart(empty, tmp_path):
    settings = [*ring_settings(2), *TO_THE_END]
    one = radii(run_well(empty, tmp_path / "one", settings))
    two = radii(run_well(empty, tmp_path / "two", settings, 2))
    assert two == pytest.approx(one, rel=1e-9)
    run_well(empty, tmp_path / "cut", [*settings, "Time/End=0.5"])
    go_on(tmp_path / "cut", ["Time/End=1"])
    with open(tmp_path / "cut" / "points.csv") as file:
        rows = list(csv.DictReader(file))[-3:]
    again = [R + float(row["uy"]) for R, row in zip((INNER, BETWEEN, OUTER), rows)]
    assert again == pytest.approx(one, rel=1e-12)


@pytest.mark.parametrize("theta", [1.1, 0.95])
def test_sphere_around_liquid(tmp_path, theta):
    """The liquid keeps the inner radius, and the wall that grows is under pressure:
    r^3 = 1 + theta^3 (R^3 - 1), P = int 2 (sigma_t - sigma_r) dr/r."""
    def rate(R):
        r = (1 + theta**3 * (R**3 - 1))**(1 / 3)
        l_t = r / R
        l_r = theta**3 / l_t**2
        return 2 * theta**-2 * (l_t**2 - l_r**2) * l_r / r
    run = run_well(HERE / "sphere.prm", tmp_path, [
        "Tissues/wall/Muscles=g", *growth("g", f"1 + ({theta} - 1)*t", fibres="radial")])
    assert run.segments()[-1]["fluid_pressure"] == pytest.approx(
        integral(rate, 1, 2), rel=2e-4)


def test_energy_of_growth_under_load(tmp_path):
    """What growth does stores and lifts; what is left of the balance is due to the
    length of the steps."""
    found = {}
    for n in (8, 16):
        folder = tmp_path / str(n)
        end = "Boundary conditions/end"
        run_well(HERE / "bar.prm", folder, [
            *grown_bar("1 + 0.2*t"), *steps(n), "Boundary conditions/Names=end",
            f"{end}/Boundary=x max", f"{end}/Type=dead traction",
            f"{end}/dead traction/Traction=-0.05*t; 0; 0"])
        found[n] = energy(folder)
        check_balance(found[n])
    balance = "balance", "balance"
    assert found[8][balance] / found[16][balance] == pytest.approx(4, rel=0.05)
    assert found[16]["muscle", "g"] > 0


def curl(folder, *settings):
    """The bar of parameters/curling_bar at time 1: its curvature, from its middle and
    its end, half of the gap between its ends, the largest stress at points, and the
    steps that were cut."""
    result = run_well(SOURCE / "parameters" / "curling_bar" / "case.prm", folder,
                      ["Output/Every=0", *settings])
    middle, half, end = result.table("points.csv")[-3:]
    x, z = end["x"] + end["ux"], middle["uz"] - end["uz"]
    stress = max(abs(point[s]) for point in (middle, half) for s in ("sxx", "syy", "szz"))
    cuts = sum(row["cuts"] for row in result.steps())
    return 2 * z / (x * x + z * z), abs(x), stress, cuts


def test_bar_that_curls_up_to_a_ring(tmp_path):
    """Growth along the bar that changes evenly across it leaves no stress."""
    cells = "Geometry/block/Cells"
    coarse, fine = (curl(tmp_path / str(n), f"{cells}={n}, 1, 1") for n in (12, 24))
    assert coarse[1] / fine[1] == pytest.approx(16, rel=0.2)
    assert fine[0] == pytest.approx(1, rel=5e-5)
    assert fine[2] < 2e-3 * 0.05
    assert coarse[3] == fine[3] == 0


def test_bar_that_grows_in_all_directions_bends(tmp_path):
    """At rest and where nothing pulls there are no forces that those of an increment
    could be compared with; all steps converge nevertheless."""
    curvature, *_, cuts = curl(tmp_path, "Muscles/growth/Action=growth")
    assert curvature == pytest.approx(0.99615, rel=1e-4)
    assert cuts == 0


@pytest.mark.parametrize("g, rel", [(0.02, 1e-3), (0.1, 2e-3)])
def test_bar_of_which_a_half_grows_is_a_bimetal_strip(tmp_path, g, rel):
    """Timoshenko 1925: 3 e/(2 h), with the strain e between layers of the same
    stiffness."""
    curvature, *_ = curl(tmp_path, "Geometry/block/Cells=12, 1, 2",
                         f"Muscles/growth/expression/Formula=1 + t*(z > 0.2 ? {g} : 0)")
    assert curvature == pytest.approx(1.5 * g / (1 + g / 2) / 0.4, rel=rel)
