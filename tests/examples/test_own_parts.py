# SPDX-License-Identifier: LGPL-2.1-or-later
"""A law, a geometry and an activation from outside the tree, in a program and in a library
that find this one with CMake: in its build folder, and where it is installed."""
# On Debian 13 neither of the two could be built: deal.II is set there to link with
# mold, which nothing installs, and CMake, told nothing, writes files for make, which
# is missing too. So deal.II asks here for a linker that does not exist, and the
# generator is that of this build.
import math
import os
import subprocess

import pytest
from lumbricus_run import SOURCE

EXAMPLE = SOURCE / "examples" / "own_parts"
ENTRY = "Additional shared libraries"

NO_LINKER = "-fuse-ld=no_such_linker"


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


def call(program, *arguments, ranks=1):
    """What the program says, which has to end well."""
    mpirun = [os.environ.get("MPIRUN", "mpirun"), "-np", str(ranks)]
    process = subprocess.run([*(mpirun if ranks > 1 else []),
                              *map(str, [program, *arguments])],
                             capture_output=True, text=True, timeout=300)
    assert process.returncode == 0, process.stdout + process.stderr
    return process.stdout


def run(program, case, folder):
    """The rows of points.csv, or of segments.csv where there are no points."""
    call(program, EXAMPLE / case, "--output", folder)
    table = folder / "points.csv"
    if not table.exists():
        table = folder / "segments.csv"
    header, *rows = [line.split(",") for line in table.read_text().splitlines()]
    return [dict(zip(header, map(float, row))) for row in rows]


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Where the package is installed, and what is built with it."""
    tmp_path = tmp_path_factory.mktemp("own_parts")
    installed = tmp_path / "installed"
    cmake("--install", os.environ["BUILD_FOLDER"], "--prefix", installed)
    package = next(installed.glob("lib*/**/LumbricusConfig.cmake")).parent
    # In the build folder it is found too; one of the two is enough to compile.
    cmake("-S", EXAMPLE, "-B", tmp_path / "beside", "-G", os.environ["GENERATOR"],
          f"-DLumbricus_DIR={os.environ['BUILD_FOLDER']}",
          f"-DCMAKE_BUILD_TYPE={os.environ['BUILD_TYPE']}")
    deal_ii = deal_ii_without_linker(tmp_path / "deal.II")
    said = cmake("-S", EXAMPLE, "-B", tmp_path / "build",
                 "-G", os.environ["GENERATOR"], f"-Ddeal.II_DIR={deal_ii}",
                 f"-DLumbricus_DIR={package}")
    assert f"a linker that is missing ({NO_LINKER})" in said
    assert said.count("a linker that is missing") == 1
    cmake("--build", tmp_path / "build")
    return installed / "bin" / "lumbricus", tmp_path / "build"


def test_parts_of_another_project(built, tmp_path):
    program, build = built
    # The law: a bar that is pulled.
    mine = build / "my_lumbricus"
    for row in run(mine, "case.prm", tmp_path / "law"):
        l = 1 + row["t"]
        exact = 0.1 * math.exp(0.5 * (l * l + 2 / l - 3)) * (l * l - 1 / l)
        assert abs(row["sxx"] - exact) < 1e-8
    assert l == 2

    # The geometry and the activation: nothing holds it, so it is as long as its
    # fibres want to be, and keeps the volume of a frustum.
    rows = run(mine, "twitch.prm", tmp_path / "twitch")
    assert len(rows) == 5
    for row in rows:
        stretch = 1 - 0.1 * math.sin(math.pi * row["t"])**2
        assert abs(row["length"] - 10 * stretch) < 1e-7
        assert abs(row["wall_volume"] - 10 / 3 * (4 + 2 + 1)) < 1e-9
    assert min(row["length"] for row in rows) < 9.01

    # The program itself runs from where it is installed, and lacks that law.
    process = subprocess.run([program, EXAMPLE / "case.prm", "--check"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert "'exponential'" in process.stderr


def rows_of(folder, name):
    """The rows of a table without its columns of seconds, the header first."""
    rows = [line.split(",") for line in (folder / name).read_text().splitlines()]
    timed = [i for i, column in enumerate(rows[0]) if "seconds" in column]
    return [[value for i, value in enumerate(row) if i not in timed] for row in rows]


def contents(folder):
    """Of all files of a run, without what says when and where it ran, and without the
    parameter that names the library."""
    tables = {path.name: rows_of(folder, path.name) for path in folder.glob("*.csv")}
    pictures = {path.name: path.read_bytes().split(b"-->", 1)[1]
                for path in (folder / "vtu").glob("*.vtu")}
    parameters = [line for line in (folder / "parameters.prm").read_text().splitlines()
                  if ENTRY not in line and "set Folder " not in line]
    assert len(tables) > 4 and pictures and parameters
    return tables, pictures, parameters


def check_near(rows, expected, tolerance):
    assert rows[0] == expected[0] and len(rows) == len(expected) > 1
    for row, other in zip(rows[1:], expected[1:]):
        assert [*map(float, row)] == \
            pytest.approx([*map(float, other)], rel=tolerance, abs=tolerance, nan_ok=True)


@pytest.mark.parametrize("case", ["case.prm", "twitch.prm"])
@pytest.mark.parametrize("ranks", [1, 2])
def test_the_library_gives_what_the_program_gives(case, ranks, built, tmp_path):
    program, build = built
    library = ["--set", f"{ENTRY}={build / 'libmy_parts.so'}"]
    assert "The input is valid" in call(program, "--check", EXAMPLE / case, *library,
                                        ranks=ranks)
    call(build / "my_lumbricus", EXAMPLE / case, "--output", tmp_path / "theirs", ranks=ranks)
    call(program, EXAMPLE / case, "--output", tmp_path / "ours", *library, ranks=ranks)
    expected = rows_of(tmp_path / "theirs", "segments.csv")
    if ranks == 1:
        assert contents(tmp_path / "ours") == contents(tmp_path / "theirs")
    else:
        # MUMPS takes messages as they come.
        check_near(rows_of(tmp_path / "ours", "segments.csv"), expected, 1e-9)

    # In two parts: the library is that of the checkpoint.
    call(program, EXAMPLE / case, "--output", tmp_path / "parts", *library,
         "--set", "Checkpoints/Steps=1", "--set", "Time/End=0.5", ranks=ranks)
    call(program, "--restart", tmp_path / "parts", "--set", "Time/End=1", ranks=ranks)
    rows = rows_of(tmp_path / "parts", "segments.csv")
    assert rows[-1][0] == "1"
    check_near([rows[0], rows[-1]], [expected[0], expected[-1]], 1e-7)


def test_parameters_of_the_library(built):
    program, build = built
    reference = call(program, "--parameters", "--set", f"{ENTRY}={build / 'libmy_parts.so'}")
    for name in ("subsection exponential", "set Width at the head", "set Period"):
        assert name in reference
    assert "subsection exponential" not in call(program, "--parameters")
