# SPDX-License-Identifier: LGPL-2.1-or-later
"""A law, a geometry, an activation, a boundary condition that remembers, a table and
a field from outside the tree, in a program and in a library that find this one with CMake: in its build folder, and where
it is installed; and lumbricus-plot draws that geometry."""
# On Debian 13 neither of the two could be built: deal.II is set there to link with
# mold, which nothing installs, and CMake, told nothing, writes files for make, which
# is missing too. So deal.II asks here for a linker that does not exist, and the
# generator is that of this build.
import csv
import math
import os
import shutil
import subprocess

import pytest

from drawn_bar import check_pictures
from lumbricus_run import SOURCE

EXAMPLE = SOURCE / "examples" / "own_parts"
ENTRY = "Additional shared libraries"

NO_LINKER = "-fuse-ld=no_such_linker"

# The files of a target are compiled together and without debug info, in less than
# half the time: sources/test_includes sees that each has its own headers.
QUICK = ["-DCMAKE_UNITY_BUILD=ON", "-DLUMBRICUS_DEBUG_INFO=OFF"]


def cmake(*arguments):
    """What it says."""
    process = subprocess.run([os.environ["CMAKE"], *map(str, arguments)],
                             capture_output=True, text=True, timeout=600)
    assert process.returncode == 0, process.stdout + process.stderr
    return process.stdout + process.stderr


def deal_ii_without_linker(folder):
    """The configuration of deal.II, but with a linker that does not exist."""
    folder.mkdir()
    for name in ("deal.IIConfig.cmake", "deal.IIConfigVersion.cmake"):
        (folder / name).write_text(
            f'include("{os.environ["DEAL_II_CONFIG"]}/{name}")\n')
    with open(folder / "deal.IIConfig.cmake", "a") as file:
        file.write(f'string(APPEND DEAL_II_LINKER_FLAGS " {NO_LINKER}")\n')
    return folder


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Where the program is installed."""
    folder = tmp_path_factory.mktemp("installed")
    cmake("--install", os.environ["BUILD_FOLDER"], "--prefix", folder)
    return folder


def program_of(installed):
    return installed / "bin" / "lumbricus"


@pytest.fixture(scope="module")
def package(installed):
    return next(installed.glob("lib*/**/LumbricusConfig.cmake")).parent


@pytest.fixture(scope="module")
def mine(tmp_path_factory, package):
    """The program with the parts of the example."""
    base = tmp_path_factory.mktemp("example")
    # In the build folder it is found too; one of the two is enough to compile.
    cmake("-S", EXAMPLE, "-B", base / "beside", "-G", os.environ["GENERATOR"],
          f"-DLumbricus_DIR={os.environ['BUILD_FOLDER']}",
          f"-DCMAKE_BUILD_TYPE={os.environ['BUILD_TYPE']}")
    deal_ii = deal_ii_without_linker(base / "deal.II")
    said = cmake("-S", EXAMPLE, "-B", base / "build",
                 "-G", os.environ["GENERATOR"], f"-Ddeal.II_DIR={deal_ii}",
                 f"-DLumbricus_DIR={package}", *QUICK)
    assert f"a linker that is missing ({NO_LINKER})" in said
    assert said.count(f"a linker that is missing ({NO_LINKER})") == 1
    cmake("--build", base / "build")
    return base / "build" / "my_lumbricus"


@pytest.fixture(scope="module")
def whole(mine, tmp_path_factory):
    """whole(case, ranks): the folder of a run of that program which nothing happens
    to; each is made once."""
    base = tmp_path_factory.mktemp("whole")

    def folder_of(case, ranks):
        folder = base / f"{case}-{ranks}"
        if not folder.exists():
            run(mine, EXAMPLE / case, "--output", folder, ranks=ranks)
        return folder

    return folder_of


def rows_of(table):
    """The rows of a table, as dictionaries of numbers."""
    with open(table) as file:
        return [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]


def run(program, *arguments, ranks=1):
    """What it says, which has to end well."""
    mpirun = [os.environ["MPIRUN"], "-np", str(ranks)] if ranks > 1 else []
    process = subprocess.run([*mpirun, program, *map(str, arguments)],
                             capture_output=True, text=True, timeout=300)
    assert process.returncode == 0, process.stdout + process.stderr
    return process.stdout


def stress_at(l):
    """Of the bar, pulled to l times its length."""
    return 0.1 * math.exp(0.5 * (l * l + 2 / l - 3)) * (l * l - 1 / l)


def test_parts_of_another_project(mine, whole, installed, tmp_path):
    # The law: a bar that is pulled.
    for row in rows_of(whole("case.prm", 1) / "points.csv"):
        l = 1 + row["t"]
        assert abs(row["sxx"] - stress_at(l)) < 1e-8
    assert l == 2

    # The geometry and the activation: nothing holds it, so it is as long as its
    # fibres want to be, and keeps the volume of a frustum.
    shutil.copytree(whole("twitch.prm", 1), tmp_path / "twitch")
    rows = rows_of(tmp_path / "twitch" / "segments.csv")
    assert len(rows) == 5
    for row in rows:
        stretch = 1 - 0.1 * math.sin(math.pi * row["t"])**2
        assert abs(row["length"] - 10 * stretch) < 1e-7
        assert abs(row["wall_volume"] - 10 / 3 * (4 + 2 + 1)) < 1e-9
    assert min(row["length"] for row in rows) < 9.01

    # The table: what nothing pulls at has no mean stress.
    rows = rows_of(tmp_path / "twitch" / "mean_stress.csv")
    assert len(rows) == 5
    for row in rows:
        assert abs(row["volume"] - 10 / 3 * (4 + 2 + 1)) < 1e-9
        assert max(abs(row["s" + 2 * axis]) for axis in "xyz") < 1e-8

    # A quarter of it is the same.
    run(mine, EXAMPLE / "twitch.prm", "--output", tmp_path / "quarter", "--set",
        "Geometry/tapered bar/Quarter=true")
    quarter = rows_of(tmp_path / "quarter" / "segments.csv")
    whole = rows_of(tmp_path / "twitch" / "segments.csv")
    assert len(quarter) == len(whole)
    for row, expected in zip(quarter, whole):
        for name in ("length", "wall_volume"):
            assert abs(row[name] - expected[name]) < 1e-9
    check_pictures(tmp_path)

    # The program itself runs from where it is installed, and lacks that law.
    process = subprocess.run([program_of(installed), EXAMPLE / "case.prm", "--check"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert "'exponential'" in process.stderr


def check_table(folder, end):
    """The mean stress of the bar, after every step once."""
    rows = rows_of(folder / "mean_stress.csv")
    assert [row["step"] for row in rows] == list(range(len(rows)))
    assert [row["t"] for row in rows] == [
        row["t"] for row in rows_of(folder / "steps.csv")]
    assert rows[-1]["t"] == end and len(rows) > 10 * end
    for row in rows:
        assert abs(row["volume"] - 1) < 1e-9
        assert abs(row["sxx"] - stress_at(1 + row["t"])) < 1e-8
        assert abs(row["syy"]) < 1e-8 and abs(row["szz"]) < 1e-8


def check_field(folder):
    """The strain of the bar, at every node of every picture."""
    pyvista = pytest.importorskip("pyvista")
    reader = pyvista.get_reader(folder / "solution.pvd")
    assert reader.time_values[0] == 0 and reader.time_values[-1] == 1
    assert len(reader.time_values) == len(rows_of(folder / "steps.csv"))
    for t in reader.time_values:
        reader.set_active_time_value(t)
        l = 1 + t
        across = 0.5 * (1 / l - 1)
        exact = [0.5 * (l * l - 1), 0, 0, 0, across, 0, 0, 0, across]
        strain = reader.read()[0].point_data["green_strain"]
        assert strain.shape == (2 * 27, 9)
        # The files have numbers in single precision.
        assert abs(strain - exact).max() < 1e-6


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_table_and_a_field_over_a_restart(mine, tmp_path, ranks):
    run(mine, EXAMPLE / "case.prm", "--output", tmp_path,
        "--set", "Time/End=0.5", ranks=ranks)
    check_table(tmp_path, 0.5)
    run(mine, "--restart", tmp_path, "--set", "Time/End=1", ranks=ranks)
    check_table(tmp_path, 1)
    check_field(tmp_path)


def dragged(times):
    """How far the end of the bar of sticky.prm is, and the force on it, at times one
    after the other: what it does depends on where its springs were last."""
    k, d = 0.1, 0.2
    anchor = 0
    for t in times:
        pull = 0.5 * math.sin(math.pi * t / 2)

        def force(l):
            return -k * min(max(pull + l - 1 - anchor, -d), d)

        low, high = 0.5, 2
        while high - low > 1e-14:
            l = (low + high) / 2
            if stress_at(l) / l < force(l):
                low = l
            else:
                high = l
        u = pull + l - 1
        anchor = min(max(anchor, u - d), u + d)
        yield u, force(l)


def check_dragged(folder, end):
    rows = rows_of(folder / "points.csv")
    assert rows[-1]["t"] == end
    with open(folder / "reactions.csv") as file:
        forces = [float(row["force_x"]) for row in csv.DictReader(file)
                  if row["name"] == "grip"]
    expected = list(dragged([row["t"] for row in rows]))
    assert len(forces) == len(rows) - 1
    for row, force, (u, exact) in zip(rows[1:], forces, expected[1:]):
        assert abs(row["ux"] - u) < 1e-9
        assert abs(force - exact) < 1e-10
    return [u for u, _ in expected], [force for _, force in expected]


@pytest.mark.parametrize("ranks", [1, 2])
def test_a_skin_that_remembers_over_a_restart(mine, whole, tmp_path, ranks):
    case = EXAMPLE / "sticky.prm"
    u, forces = check_dragged(whole("sticky.prm", ranks), 4)
    # It sticks and slips, both ways, and comes back to where it was not before.
    assert min(forces) == pytest.approx(-0.02) and max(forces) == pytest.approx(0.02)
    assert sum(abs(force) < 0.019 for force in forces) > 10
    assert abs(u[0]) < 1e-12 and abs(u[-1]) > 0.05

    # In the middle of a slip, and right after the way back has begun.
    cut = tmp_path / "cut"
    run(mine, case, "--output", cut, "--set", "Time/End=0.8", ranks=ranks)
    for end in (1.2, 4):
        run(mine, "--restart", cut, "--set", f"Time/End={end}", ranks=3 - ranks)
        check_dragged(cut, end)
    for row, other in zip(rows_of(cut / "points.csv"),
                          rows_of(whole("sticky.prm", ranks) / "points.csv")):
        assert row["t"] == other["t"] and abs(row["ux"] - other["ux"]) < 1e-12

    # What a run remembers cannot be left out, nor asked for too late.
    for settings, words in (
            (["Boundary conditions/grip/Type=spring"], "has the history 'boundary:grip'"),
            (["Boundary conditions/Names=pull,grip,more",
              "Boundary conditions/more/Boundary=y max",
              "Boundary conditions/more/Type=sticky"],
             "does not have the history 'boundary:more'")):
        arguments = [word for setting in [*settings, "Time/End=5"]
                     for word in ("--set", setting)]
        process = subprocess.run([mine, "--restart", cut, *arguments],
                                 capture_output=True, text=True, timeout=60)
        assert process.returncode == 1
        assert words in " ".join(process.stderr.split())


def test_a_table_whose_name_is_taken(package, tmp_path):
    text = (EXAMPLE / "mean_stress.cc").read_text()
    assert text.count('"mean_stress"') == 1
    (tmp_path / "taken.cc").write_text(text.replace('"mean_stress"', '"steps"'))
    (tmp_path / "CMakeLists.txt").write_text(
        (EXAMPLE / "CMakeLists.txt").read_text().split("lumbricus_add_plugin")[0] +
        f"add_executable(taken {EXAMPLE}/main.cc taken.cc)\n"
        "lumbricus_setup_target(taken)\n"
        "set_property(TARGET taken APPEND PROPERTY\n"
        "  LINK_LIBRARIES Lumbricus::lumbricus)\n")
    cmake("-S", tmp_path, "-B", tmp_path / "build",
          "-G", os.environ["GENERATOR"], f"-DLumbricus_DIR={package}", *QUICK)
    cmake("--build", tmp_path / "build")
    process = subprocess.run([tmp_path / "build" / "taken",
                              SOURCE / "tests" / "errors" / "block.prm",
                              "--output", tmp_path / "results"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert "the name 'steps' is that of two classes of lumbricus::Table" in \
        process.stderr
    assert not (tmp_path / "results").exists()


def untimed_rows(folder, name):
    """The rows of a table without its columns of seconds, the header first."""
    rows = [line.split(",") for line in (folder / name).read_text().splitlines()]
    timed = [i for i, column in enumerate(rows[0]) if "seconds" in column]
    return [[value for i, value in enumerate(row) if i not in timed] for row in rows]


def contents(folder):
    """Of all files of a run, without what says when and where it ran, and without the
    parameter that names the library."""
    tables = {path.name: untimed_rows(folder, path.name)
              for path in folder.glob("*.csv")}
    pictures = {path.name: path.read_bytes().split(b"-->", 1)[1]
                for path in (folder / "vtu").glob("*.vtu")}
    parameters = [line for line in (folder / "parameters.prm").read_text().splitlines()
                  if ENTRY not in line and "set Folder " not in line]
    assert len(tables) > 4 and pictures and parameters
    return tables, pictures, parameters


def check_near(rows, expected, tolerance):
    assert rows[0] == expected[0] and len(rows) == len(expected) > 1
    for row, other in zip(rows[1:], expected[1:]):
        assert [*map(float, row)] == pytest.approx(
            [*map(float, other)], rel=tolerance, abs=tolerance, nan_ok=True)


@pytest.mark.parametrize("case", ["case.prm", "twitch.prm", "sticky.prm"])
@pytest.mark.parametrize("ranks", [1, 2])
def test_the_library_gives_what_the_program_gives(case, ranks, mine, whole,
                                                  installed, tmp_path):
    program = program_of(installed)
    library = ["--set", f"{ENTRY}={mine.parent / 'libmy_parts.so'}"]
    assert "The input is valid" in run(program, "--check", EXAMPLE / case, *library,
                                       ranks=ranks)
    theirs = whole(case, ranks)
    run(program, EXAMPLE / case, "--output", tmp_path / "ours", *library, ranks=ranks)
    expected = untimed_rows(theirs, "segments.csv")
    if ranks == 1:
        assert contents(tmp_path / "ours") == contents(theirs)
    else:
        # MUMPS takes messages as they come.
        check_near(untimed_rows(tmp_path / "ours", "segments.csv"), expected, 1e-9)

    # In two parts: the library is that of the checkpoint.
    run(program, EXAMPLE / case, "--output", tmp_path / "parts", *library,
        "--set", "Checkpoints/Steps=1", "--set", "Time/End=0.5", ranks=ranks)
    end = expected[-1][0]
    run(program, "--restart", tmp_path / "parts", "--set", f"Time/End={end}",
        ranks=ranks)
    rows = untimed_rows(tmp_path / "parts", "segments.csv")
    assert rows[-1][0] == end
    check_near([rows[0], rows[-1]], [expected[0], expected[-1]], 1e-7)


def test_parameters_of_the_library(mine, installed):
    program = program_of(installed)
    reference = run(program, "--parameters", "--set",
                    f"{ENTRY}={mine.parent / 'libmy_parts.so'}")
    for name in ("subsection exponential", "set Width at the head", "set Period"):
        assert name in reference
    assert "subsection exponential" not in run(program, "--parameters")
