# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of second order: cells of 20 or 27 nodes, whose faces are curved. A ball
is round, its volume has an error of fourth order, and stays what it is when cells
are refined; the pressure of a balloon is that of a formula."""
import math
import pathlib
import sys

import pytest
import thick_sphere
from lumbricus_run import SOURCE, go_on, run_well

sys.path.insert(0, str(SOURCE / "parameters" / "balloon"))
import shell  # noqa: E402

HERE = pathlib.Path(__file__).parent
RADIUS, A = 10., 0.23


def balloon(folder, n, n_nodes, thickness, settings=(), ranks=1, volume=1.001,
            through=1, **more):
    """An eighth of a shell whose inside is blown up to so many times its volume."""
    folder.mkdir(parents=True, exist_ok=True)
    nodes, groups = shell.make_shell(RADIUS, thickness, n, n_nodes, through)
    groups["cavity 1"] = groups.pop("inside")
    shell.write_msh(folder / "shell.msh", nodes, groups)
    case = folder / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = {folder / "shell.msh"}
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    subsection Neo-Hooke
      set a = {A}
    end
  end
end
subsection Cavities
  set Content = volume
  subsection volume
    set Relative volume = 1 + {volume - 1!r}*t
  end
end
subsection Time
  set First step   = 0.25
  set Largest step = 0.25
end
subsection Output
  set Every = 0
end
""")
    return run_well(case, folder / "out", list(settings), ranks, **more)


def pressure(volume, thickness):
    return thick_sphere.pressure(volume, RADIUS, thickness, A)


def ball(radius):
    return 4 / 3 * math.pi * radius**3


@pytest.mark.parametrize("n_nodes, order", [(8, 2), (20, 4), (27, 4)])
def test_volume_of_a_thick_hollow_sphere(tmp_path, n_nodes, order):
    errors = []
    for n in (2, 4):
        first = balloon(tmp_path / str(n), n, n_nodes, 10,
                        ["Time/End=0.25"], through=n).segments()[0]
        errors.append([first["fluid_volume"] / ball(RADIUS) - 1,
                       first["wall_volume"] / (ball(2 * RADIUS) - ball(RADIUS)) - 1])
    print(n_nodes, errors)
    for coarse, fine in zip(*errors):
        assert math.log2(coarse / fine) == pytest.approx(order, abs=0.25)
        assert abs(fine) < (2e-4 if order == 4 else 4e-2)
        assert order == 4 or abs(fine) > 1e-2


def test_limit_pressure_of_a_balloon(tmp_path):
    """With a wall of a twentieth of the radius it is at a hoop stretch of 1.405."""
    thickness = 0.5
    at = max((1 + 1e-3 * i for i in range(1000, 2500)),
             key=lambda volume: pressure(volume, thickness))
    expected = pressure(at, thickness)
    assert expected == pytest.approx(0.013905, abs=1e-6)
    assert at**(1 / 3) == pytest.approx(1.405, abs=1e-3)
    off, before = {}, {}
    for n_nodes in (8, 20, 27):
        at_rest = balloon(tmp_path / f"{n_nodes}.rest", 4, n_nodes, thickness,
                          ["Time/End=0.25"]).segments()[0]["fluid_volume"]
        for volume, result in ((at, off), (1.3, before)):
            last = balloon(tmp_path / f"{n_nodes}.{volume}", 4, n_nodes, thickness,
                           volume=volume * ball(RADIUS) / at_rest).last()
            result[n_nodes] = last["fluid_pressure"] / pressure(volume,
                                                                thickness) - 1
    print(off, before)
    for result in (off, before):
        assert abs(result[20]) < 1e-3 and abs(result[27]) < 1e-3
    # Facets are a smaller ball.
    assert abs(before[8]) > 2e-2


def test_refinement_leaves_the_shape(tmp_path):
    """On one rank and on two, by the estimate of errors too, and over a restart."""
    settings = ["Newton/Force tolerance=1e-11", "Newton/Increment tolerance=1e-12",
                "Linear solver/Method=direct"]
    coarse = balloon(tmp_path / "coarse", 2, 27, 2, settings, volume=2)
    fine = balloon(tmp_path / "fine", 2, 27, 2,
                   settings + ["Mesh/Global refinements=1"], volume=2)
    adapted = settings + ["Adaptivity/Every=2"]
    one = balloon(tmp_path / "one", 2, 27, 2, adapted, volume=2)
    two = balloon(tmp_path / "two", 2, 27, 2,
                  adapted + ["Checkpoints/Steps=2", "Time/End=0.5"], 2, volume=2)
    two = go_on(two.folder, ["Time/End=1"], 2)
    assert one.table("mesh.csv")[-1]["cells"] > 12
    for column in ("fluid_volume", "wall_volume"):
        for result in (fine, one, two):
            assert result.segments()[0][column] == pytest.approx(
                coarse.segments()[0][column], rel=1e-12)
            assert result.last()[column] == pytest.approx(
                coarse.last()[column], rel=1e-9)
    for column in ("fluid_pressure", "fluid_volume", "wall_volume"):
        assert two.last()[column] == pytest.approx(one.last()[column], rel=1e-9)
    expected = pressure(coarse.last()["fluid_volume"] / ball(RADIUS), 2)
    assert one.last()["fluid_pressure"] == pytest.approx(expected, rel=1e-2)


@pytest.mark.parametrize("file", ["zone27.msh", "zone20.msh"])
def test_a_file_of_gmsh(file, tmp_path):
    """A fourth of a zone of a hollow ball, radii 3 and 4, from 20 to 70 degrees to
    the axis: Gmsh 4.15 wrote it, in its format 4.1 and in 2.2. Its order of nodes is
    what is read."""
    case = tmp_path / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = {HERE / "meshes" / file}
    set Liquid tissues =
  end
end
subsection Time
  set End = 0.05
end
subsection Output
  set Every = 0
end
""")
    volume = run_well(case, tmp_path / "out").segments()[0]["wall_volume"]
    a, b = math.radians(20), math.radians(70)
    exact = 2 * math.pi / 3 * (4**3 - 3**3) * (math.cos(a) - math.cos(b)) / 4
    print(volume / 2 / exact - 1)
    # A plane of symmetry doubles it.
    assert volume / 2 == pytest.approx(exact, rel=1e-3)
