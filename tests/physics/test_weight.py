# SPDX-License-Identifier: LGPL-2.1-or-later
"""The weight of a body and of the liquid in it, which is meshed or not: what its
supports hold, how the pressure grows downwards, and that it leaves the liquid's
mesh alone."""
import csv
import pathlib
import sys

import numpy as np
import pytest
from cube_mesh import boxes
from lumbricus_run import SOURCE, run_well

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.fields import read_grid, read_series  # noqa: E402

HERE = pathlib.Path(__file__).parent
CHAIN = HERE / "chain.prm"
CAVITY = ["Geometry/segment chain/Liquid=cavity"]
WALL = ["circular muscle", "longitudinal muscle", "septum", "cap"]
RHO_WALL = RHO_LIQUID = 1.05e-9
G = 9810
# Hanging from its head, which is held, without contractions: so heavy that it
# shows.
HEAVY = 300


def heavy(gravity, half=True):
    settings = ["Body forces/Names=weight", "Body forces/weight/Type=weight",
                f"Body forces/weight/weight/Gravity={gravity}",
                "Boundary conditions/Names=hold",
                "Boundary conditions/hold/Boundary=head",
                "Boundary conditions/hold/Type=displacement",
                "Muscles/longitudinal/expression/Formula=1",
                "Muscles/circular/wave/Amplitude=0.02"]
    if half:
        settings.append("Geometry/segment chain/Cross-section=half")
    return settings


def last_reactions(run):
    with open(run.folder / "reactions.csv") as file:
        rows = list(csv.DictReader(file))
    return {row["name"]: row for row in rows if row["t"] == rows[-1]["t"]}


@pytest.fixture(scope="module")
def sideways(tmp_path_factory):
    """Under the same weight across, with cavities and with a rubber fluid."""
    folder = tmp_path_factory.mktemp("sideways")
    settings = heavy(f"0; 0; -{HEAVY * G}*t")
    return [run_well(CHAIN, folder / name, [*settings, *more], 2)
            for name, more in (("cavity", CAVITY),
                               ("rubber", ["Reset/Tolerance=1e-5"]))]


def test_supports_hold_wall_and_liquid(sideways):
    for run in sideways:
        t = run.steps()[-1]["t"]
        rows = [row for row in run.segments() if row["t"] == t]
        at_rest = [row for row in run.segments() if row["t"] == 0]
        # Of the half that is computed; the mass of the wall is that at rest.
        mass = 0.5 * sum(RHO_WALL * rest["wall_volume"] +
                         RHO_LIQUID * row["fluid_volume"]
                         for row, rest in zip(rows, at_rest))
        forces = last_reactions(run)
        weight = mass * HEAVY * G * t
        assert float(forces["weight"]["force_z"]) == pytest.approx(
            -weight, rel=1e-6 if run is sideways[1] else 1e-12)
        assert float(forces["hold"]["force_z"]) == pytest.approx(
            weight, rel=1e-8)
        for part in ("force_x", "force_y", "force_z", "moment_y"):
            assert abs(float(forces["sum"][part])) < 1e-8 * weight


def test_cavity_and_rubber_sag_alike(sideways):
    """The weight of the liquid acts on its surface alone: the rubber fluid takes
    no shear from it, and is as hydrostatic as without."""
    cavity, rubber = sideways
    for row, expected in zip(cavity.segments(), rubber.segments()):
        for part in ("length", "mid_radius", "fluid_volume"):
            assert row[part] == pytest.approx(expected[part], rel=3e-5), part
        assert row["fluid_pressure"] == pytest.approx(
            expected["fluid_pressure"], abs=1e-6)
        assert expected["eta"] <= 1e-5
    assert max(abs(row["fluid_pressure"]) for row in rubber.segments()) > 1e-4


def test_pressure_grows_downwards(tmp_path):
    """Upright, with pores that are wide open: all chambers are one column, in
    which P_k - P_j = rho g (h_j - h_k) between the heights of their centres."""
    g = HEAVY * G
    run = run_well(CHAIN, tmp_path, [
        *heavy(f"{g}*t", half=False)[:2],
        f"Body forces/weight/weight/Gravity={g}*t; 0; 0",
        *heavy("", half=False)[3:], *CAVITY, "Cavities/Pores=1e10"])
    t = run.steps()[-1]["t"]
    rows = [row for row in run.segments() if row["t"] == t]
    P = [row["fluid_pressure"] for row in rows]
    # From the middle of the first chamber to that of the last one: a segment at an
    # end of the chain has half of a septum on one side only, 0.1 mm.
    distance = 0.5 * (rows[0]["length"] + rows[2]["length"]) + \
        rows[1]["length"] + 0.1
    assert P[2] - P[0] == pytest.approx(RHO_LIQUID * g * t * distance, rel=0.01)
    assert P[2] - P[0] > 1e-3


@pytest.mark.parametrize("liquid", ["cavity", "meshed"])
def test_pictures_show_the_gradient(tmp_path, liquid):
    """In the liquid the pressure of the pictures grows by rho g downwards: also
    where the mesh, whose own pressure is uniform, has moved."""
    g = HEAVY * G
    run = run_well(CHAIN, tmp_path, [
        *heavy(f"0; 0; -{g}*t"), "Time/End=0.1",
        f"Geometry/segment chain/Liquid={liquid}", "Output/Every=1"])
    grid = read_grid(read_series(run.folder)[-1][1])
    inside = (grid["segment"] == 2) & \
        (grid["tissue"] == {"cavity": 4, "meshed": 0}[liquid])
    z = (grid.points + grid["displacement"])[inside, 2]
    p = grid["pressure"][inside]
    slope, at_0 = np.polyfit(z, p, 1)
    assert slope == pytest.approx(-RHO_LIQUID * g * 0.1, rel=1e-3)
    assert abs(p - at_0 - slope * z).max() < 2e-3 * (p.max() - p.min())


def test_weightless_liquid_is_that_of_before(tmp_path):
    """Without density the weight of tissues is that of a dead body force."""
    g = HEAVY * G
    weight = run_well(CHAIN, tmp_path / "weight", [
        *heavy(f"0; 0; -{g}*t"), *CAVITY, "Cavities/liquid/Density=0"])
    dead = run_well(CHAIN, tmp_path / "dead", [
        *CAVITY, *heavy("")[3:], "Body forces/Names=weight",
        "Body forces/weight/Type=dead body force",
        "Body forces/weight/dead body force/Force="
        f"0; 0; -{RHO_WALL * g:.17g}*t"])
    for row, expected in zip(weight.segments(), dead.segments()):
        for part in ("length", "fluid_volume", "fluid_pressure"):
            assert row[part] == pytest.approx(expected[part], rel=1e-9), part


def test_liquid_is_of_the_segment_of_its_cavity(tmp_path):
    """Not of that of the cells around it: nearly all of the wall around the second
    chamber, a cube of 1 mm, is of the first segment."""
    mesh = boxes("cavity 1", "cavity 2", wall=lambda cell: (
        "wall 2" if cell == (5, 2, 2) else "wall 1"))
    (tmp_path / "body.msh").write_text(str(mesh))
    case = tmp_path / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = {tmp_path / "body.msh"}
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    set Density = 0
  end
end
subsection Cavities
  set Segments with their own content = 1
  subsection Segment 1
    subsection liquid
      set Density = 0
    end
  end
end
subsection Body forces
  set Names = weight
  subsection weight
    set Type = weight
    subsection weight
      set Gravity = 0; 0; -{G}*t
    end
  end
end
subsection Boundary conditions
  set Names = hold
  subsection hold
    set Boundary = free
    set Type     = spring
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
""")
    run = run_well(case, tmp_path / "out")
    forces = last_reactions(run)
    assert float(forces["weight"]["force_z"]) == pytest.approx(
        -RHO_LIQUID * G, rel=1e-9)
    assert float(forces["hold"]["force_z"]) == pytest.approx(
        RHO_LIQUID * G, rel=1e-6)
