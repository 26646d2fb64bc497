# SPDX-License-Identifier: LGPL-2.1-or-later
"""A law from outside the tree, in a program that finds this one with CMake: in
its build folder, and where it is installed."""
import math
import os
import subprocess

from lumbricus_run import SOURCE

EXAMPLE = SOURCE / "examples" / "own_law"


def cmake(*arguments):
    process = subprocess.run([os.environ["CMAKE"], *map(str, arguments)],
                             capture_output=True, text=True, timeout=300)
    assert process.returncode == 0, process.stdout + process.stderr


def test_a_bar_of_a_tissue_that_stiffens(tmp_path):
    installed = tmp_path / "installed"
    cmake("--install", os.environ["BUILD_FOLDER"], "--prefix", installed)
    package = next(installed.glob("lib*/**/LumbricusConfig.cmake")).parent
    # In the build folder it is found too; one of the two is enough to compile.
    cmake("-S", EXAMPLE, "-B", tmp_path / "beside",
          f"-DLumbricus_DIR={os.environ['BUILD_FOLDER']}",
          f"-DCMAKE_BUILD_TYPE={os.environ['BUILD_TYPE']}")
    cmake("-S", EXAMPLE, "-B", tmp_path / "build", f"-DLumbricus_DIR={package}")
    cmake("--build", tmp_path / "build")

    folder = tmp_path / "run"
    process = subprocess.run([tmp_path / "build" / "my_lumbricus",
                              EXAMPLE / "case.prm", "--output", folder],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 0, process.stdout + process.stderr
    header, *rows = [line.split(",") for line in
                     (folder / "points.csv").read_text().splitlines()]
    for row in rows:
        values = dict(zip(header, map(float, row)))
        l = 1 + values["t"]
        exact = 0.1 * math.exp(0.5 * (l * l + 2 / l - 3)) * (l * l - 1 / l)
        assert abs(values["sxx"] - exact) < 1e-8
    assert l == 2

    # The program itself runs from where it is installed, and lacks that law.
    process = subprocess.run([installed / "bin" / "lumbricus",
                              EXAMPLE / "case.prm", "--check"],
                             capture_output=True, text=True, timeout=60)
    assert process.returncode == 1
    assert "'exponential'" in process.stderr
