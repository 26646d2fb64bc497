# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body has the same numbers whether the program makes its mesh or reads it
from a file of Gmsh, and a muscle whether its fibres are a formula or a file."""
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest
import thick_sphere
from lumbricus_run import SOURCE, run_well

HERE = pathlib.Path(__file__).parent
LAYERS = "longitudinal muscle, circular muscle"


def with_mesh(base, version, layers, folder,
              more="    set Round surfaces = skin, inner circles\n"):
    """A case like the base, but with the mesh in a file."""
    mesh = folder / "body.msh"
    subprocess.run([os.environ["WRITE_MSH"], str(base), version, str(mesh)],
                   check=True, timeout=60)
    text = base.read_text()
    shape = re.search(r"set Shape = (.*)\n", text)[1]
    begin = text.index(f"  subsection {shape}")
    end = text.index("\nend", begin)
    case = folder / "case.prm"
    case.write_text(text[:begin].replace(shape, "mesh file") + f"""
  subsection mesh file
    set File           = {mesh}
    set Wall layers    = {layers}
{more}  end""" + text[end:])
    return case


def chain_of_equal_segments(folder, own=""):
    """chain.prm without its own measures: the file says of a face whether it is
    round, and the skin of unequal segments is a cone at a septum."""
    text = (HERE / "chain.prm").read_text()
    begin = text.index("    set Segments with their own measures")
    base = folder / "base.prm"
    text = text[:begin] + own + text[text.index("  end\nend", begin):]
    if own.endswith("Liquid = cavity\n"):
        text = re.sub("  subsection liquid\n.*?\n  end\n", "", text,
                      flags=re.DOTALL)
    base.write_text(text)
    return base


def assert_same_numbers(a, b, columns, tolerance):
    assert len(a) == len(b)
    for row, other in zip(a, b):
        for column in columns:
            assert row[column] == pytest.approx(other[column], rel=tolerance,
                                                abs=tolerance)


@pytest.mark.parametrize("base, layers, version, coupling, ranks", [
    ("segment.prm", "wall", "2.2", "tied", 1),
    ("segment.prm", "wall", "4.1", "tied", 2),
    ("segment.prm", "wall", "4.1", "slip", 1),
    ("chain.prm", LAYERS, "4.1", "tied", 1),
])
def test_same_body_from_a_mesh_file(base, layers, version, coupling, ranks,
                                    tmp_path):
    settings = ["Reset/Tolerance=1e-5", "Time/End=0.2",
                "Interface/Coupling=" + coupling]
    if coupling == "slip":
        settings += ["Reset/Tolerance=1e-3", "Time/First step=0.1",
                     "Time/Largest step=0.1"]
    base = HERE / base
    if base.name == "chain.prm":
        base = chain_of_equal_segments(tmp_path)
    case = with_mesh(base, version, layers, tmp_path)
    built_in = run_well(base, tmp_path / "a", settings)
    from_file = run_well(case, tmp_path / "b", settings, ranks)
    columns = ["t", "segment", "mid_radius", "fluid_volume", "wall_volume",
               "fluid_pressure"]
    if base.name == "segment.prm":
        # In a chain the file's segments end where their liquid does.
        columns += ["length"]
    assert_same_numbers(built_in.segments(), from_file.segments(), columns,
                        1e-9)
    # It has moved.
    assert from_file.last()["mid_radius"] < \
        0.99 * from_file.segments()[0]["mid_radius"]


@pytest.fixture(scope="module")
def meshed(tmp_path_factory):
    """A chain from a file, whose inner faces are flat: the wall around a chamber
    is one surface, round and flat, which cannot be round about the axis."""
    folder = tmp_path_factory.mktemp("meshed")
    case = with_mesh(chain_of_equal_segments(folder), "4.1", LAYERS, folder,
                     "    set Round surfaces = skin\n")
    return run_well(case, folder / "out", ["Reset/Tolerance=1e-5"])


@pytest.mark.parametrize("liquid, ranks", [("cavity", 1), ("cavity", 2),
                                           ("mixed", 2)])
def test_chambers_without_cells_from_a_mesh_file(liquid, ranks, tmp_path,
                                                 meshed):
    """The physical surfaces 'cavity 1', ... instead of the volumes inside."""
    mixed = liquid == "mixed"
    base = chain_of_equal_segments(tmp_path, """
    set Segments with their own measures = 2
    subsection Segment 2
      set Liquid = cavity
    end
""" if mixed else "    set Liquid = cavity\n")
    case = with_mesh(base, "4.1", LAYERS, tmp_path,
                     "    set Round surfaces = skin\n" +
                     ("" if mixed else "    set Liquid tissues =\n"))
    result = run_well(case, tmp_path / "out", ["Reset/Tolerance=1e-5"], ranks)
    columns = ["length", "mid_radius", "fluid_volume", "wall_volume"]
    assert_same_numbers(result.segments(), meshed.segments(), columns, 2e-5)
    largest = max(row["fluid_pressure"] for row in meshed.segments())
    for row, other in zip(result.segments(), meshed.segments(), strict=True):
        assert row["fluid_pressure"] == pytest.approx(
            other["fluid_pressure"], abs=(4e-5 if mixed else 2e-5) * largest)
        if row["segment"] == 2 or not mixed:
            assert row["eta"] == 0


def test_gas_in_a_balloon(tmp_path):
    """An eighth of a rubber sphere with gas inside, which swells when the pressure
    outside falls. The facets of the mesh make it smaller than the sphere, with
    half of the edges by a fourth of that, the wall as much as the chamber, so that
    the stretch is not that of the facets. A plane of symmetry may be anywhere."""
    radius, thickness, a = 10., 1., 0.5
    at_rest, outside = 0.101325, 0.03

    def pressure(stretch):
        return thick_sphere.pressure(stretch**3, radius, thickness, a)

    low, high = 1., 1.3
    while high - low > 1e-12:
        middle = (low + high) / 2
        if pressure(middle) < at_rest / middle**3 - outside:
            low = middle
        else:
            high = middle
    sys.path.insert(0, str(SOURCE / "parameters" / "balloon"))
    import shell
    errors, missing = [], []
    for n in (3, 6):
        nodes, groups = shell.make_shell(radius, thickness, n)
        groups["cavity 1"] = groups.pop("inside")
        runs = []
        for shift in (0, 7):
            mesh = tmp_path / f"{n}.{shift}.msh"
            shell.write_msh(mesh, {(x, y, z + shift): number for (x, y, z), number
                                   in nodes.items()}, groups)
            case = tmp_path / "case.prm"
            case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = {mesh}
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    subsection Neo-Hooke
      set a = {a}
    end
  end
end
subsection Cavities
  set Content = gas
  subsection gas
    set Absolute pressure at rest = {at_rest}
    set Absolute pressure outside = {outside}
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
subsection Output
  set Every = 0
end
""")
            runs.append(run_well(case, mesh.with_suffix(".out")))
        first, last = runs[0].segments()[0], runs[0].last()
        sphere = 4 / 3 * math.pi * radius**3
        missing.append(1 - first["fluid_volume"] / sphere)
        stretch = (last["fluid_volume"] / first["fluid_volume"]) ** (1 / 3)
        errors.append(stretch - low)
        assert last["fluid_pressure"] == pytest.approx(
            at_rest / stretch**3 - outside, rel=1e-9)
        for column in ("fluid_volume", "fluid_pressure"):
            assert runs[1].last()[column] == pytest.approx(last[column],
                                                           rel=1e-9)
    print("stretch", low, errors, missing)
    assert abs(errors[0]) < 1e-5 and abs(errors[1]) < 1e-6
    assert missing[1] < 0.02
    assert missing[0] / missing[1] == pytest.approx(4, rel=0.1)


def test_case_of_the_gallery(tmp_path):
    """Its files fit together, and its liquid and its wall keep their volume."""
    folder = SOURCE / "parameters" / "mesh_file"
    copy = tmp_path / "fibres"
    copy.mkdir()
    for name in ("body.msh", "fibres.py"):
        shutil.copy(folder / name, copy)
    subprocess.run([sys.executable, str(copy / "fibres.py")], check=True)
    assert (copy / "fibres.csv").read_text() == \
        (folder / "fibres.csv").read_text()

    result = run_well(folder / "case.prm", tmp_path / "out", [
        f"Geometry/mesh file/File={folder / 'body.msh'}",
        f"Muscles/longitudinal/file/File={folder / 'fibres.csv'}",
        "Time/End=0.2"], ranks=2)
    first, last = result.segments()[0], result.last()
    assert first["length"] == pytest.approx(6, rel=1e-12)
    assert first["fluid_volume"] == pytest.approx(107.5217, rel=1e-6)
    assert first["wall_volume"] == pytest.approx(41.04897, rel=1e-6)
    for volume in ("fluid_volume", "wall_volume"):
        assert last[volume] == pytest.approx(first[volume], rel=1e-10)
    assert last["length"] == pytest.approx(6.2368, rel=1e-3)
    assert last["mid_radius"] == pytest.approx(1.9595, rel=1e-3)
    assert last["fluid_pressure"] == pytest.approx(0.006727, rel=1e-2)


def test_mesh_without_planes_has_no_length(tmp_path):
    """One cell whose ends are askew: nan, not a crash."""
    corners = [(0, 0, 0), (2, 0, 0), (2, 1, 0.1), (0.1, 1, 0),
               (0.2, 0, 1), (2.3, 0, 1), (2.2, 1.1, 1), (0, 1.1, 1)]
    nodes = "\n".join(f"{i + 1} {x} {y} {z}"
                      for i, (x, y, z) in enumerate(corners))
    mesh = tmp_path / "cell.msh"
    mesh.write_text(f"""$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "wall"
$EndPhysicalNames
$Nodes
8
{nodes}
$EndNodes
$Elements
1
1 5 2 1 1 1 2 3 4 5 6 7 8
$EndElements
""")
    case = tmp_path / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = {mesh}
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    set Muscles = all
  end
end
subsection Muscles
  subsection all
    set Fibres         = longitudinal
    set Active stretch = expression
    subsection expression
      set Formula = 1 - 0.1*t
    end
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
subsection Output
  set Every = 0
end
""")
    result = run_well(case, tmp_path / "out")
    assert math.isnan(result.last()["length"])
    assert math.isnan(result.last()["mid_radius"])
    assert result.last()["wall_volume"] == pytest.approx(
        result.segments()[0]["wall_volume"], rel=1e-9)


def points_in_the_wall(n_around, n_along):
    """Centres of cells of the wall of segment.prm, a quarter of a tube."""
    for i in range(n_around):
        angle = (i + 0.5) / n_around * math.pi / 2
        for j in range(n_along):
            yield 0.3 + (j + 0.5) / n_along * 3, 3.15 * math.cos(angle), \
                3.15 * math.sin(angle)


def segment_with(fibres, case):
    """A case file: segment.prm with the fibres of that file."""
    case.write_text(f"""include {HERE / "segment.prm"}
subsection Muscles
  subsection circular
    set Fibres = file
    subsection file
      set File  = {fibres}
    end
  end
end
""")
    return case


@pytest.mark.parametrize("ranks", [1, 2])
def test_fibres_from_a_file_are_those_of_the_formula(ranks, tmp_path):
    """The finer the points the nearer, with the second power of their distance; the
    wall's ends and its surfaces are beyond them."""
    formula = run_well(HERE / "segment.prm", tmp_path / "formula").last()
    differences = []
    for n in (8, 32):
        fibres = tmp_path / f"fibres{n}.csv"
        with open(fibres, "w") as file:
            print("x, y, z, fx, fy, fz", file=file)
            for x, y, z in points_in_the_wall(n, n // 2):
                print(f"{x}, {y}, {z}, 0, {-z}, {y}", file=file)
        case = segment_with(fibres, tmp_path / f"case{n}.prm")
        last = run_well(case, tmp_path / f"out{n}", ranks=ranks).last()
        assert last["fluid_volume"] == pytest.approx(formula["fluid_volume"],
                                                     rel=1e-8)
        differences.append(max(
            abs(last[column] / formula[column] - 1)
            for column in ("length", "mid_radius")))
    assert differences[0] < 5e-6
    assert differences[1] < differences[0] / 16


def test_fibres_from_a_file_are_the_same_on_two_ranks(tmp_path):
    fibres = tmp_path / "fibres.csv"
    fibres.write_text("".join(f"{x} {y} {z} 0 {-z} {y}\n" for x, y, z in
                              points_in_the_wall(9, 7)))
    case = segment_with(fibres, tmp_path / "case.prm")
    one, two = (run_well(case, tmp_path / str(ranks), [
        "Newton/Force tolerance=1e-12", "Newton/Increment tolerance=1e-12"],
        ranks).segments() for ranks in (1, 2))
    assert_same_numbers(one, two, ["length", "mid_radius", "fluid_pressure"], 1e-9)
