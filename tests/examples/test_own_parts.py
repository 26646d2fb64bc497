# SPDX-License-Identifier: LGPL-2.1-or-later
"""A law, a geometry and an activation from outside the tree, in a program that finds
this one with CMake: in its build folder, and where it is installed; and
lumbricus-plot draws that geometry."""
# On Debian 13 neither of the two could be built: deal.II is set there to link with
# mold, which nothing installs, and CMake, told nothing, writes files for make, which
# is missing too. So deal.II asks here for a linker that does not exist, and the
# generator is that of this build.
import math
import os
import subprocess

from drawn_bar import check_pictures
from lumbricus_run import SOURCE

EXAMPLE = SOURCE / "examples" / "own_parts"


NO_LINKER = "-fuse-ld=no_such_linker"


def cmake(*arguments):
    """What it says."""
    process = subprocess.run([os.environ["CMAKE"], *map(str, arguments)],
                             capture_output=True, text=True, timeout=300)
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


def run(program, case, folder, settings=()):
    """The rows of points.csv, or of segments.csv where there are no points."""
    command = [program, EXAMPLE / case, "--output", folder]
    for setting in settings:
        command += ["--set", setting]
    process = subprocess.run(command, capture_output=True, text=True,
                             timeout=60)
    assert process.returncode == 0, process.stdout + process.stderr
    table = folder / "points.csv"
    if not table.exists():
        table = folder / "segments.csv"
    header, *rows = [line.split(",") for line in table.read_text().splitlines()]
    return [dict(zip(header, map(float, row))) for row in rows]


def test_parts_of_another_project(tmp_path):
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

    # The law: a bar that is pulled.
    mine = tmp_path / "build" / "my_lumbricus"
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

    # A quarter of it is the same.
    for row, whole in zip(run(mine, "twitch.prm", tmp_path / "quarter",
                              ["Geometry/tapered bar/Quarter=true"]), rows):
        assert abs(row["length"] - whole["length"]) < 1e-9
        assert abs(row["wall_volume"] - whole["wall_volume"]) < 1e-9
    check_pictures(tmp_path)

    # The program itself runs from where it is installed, and lacks that law.
    process = subprocess.run([installed / "bin" / "lumbricus",
                              EXAMPLE / "case.prm", "--check"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert "'exponential'" in process.stderr
