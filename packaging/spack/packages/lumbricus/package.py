# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lumbricus for Spack. In a clone:

    spack repo add packaging/spack
    spack install lumbricus                 # what is committed on main
    spack dev-build lumbricus@0.2.0         # the files as they are, also of a tarball
"""
import pathlib

from spack.package import *

try:
    from spack_repo.builtin.build_systems.cmake import CMakePackage
except ImportError:
    pass  # Before Spack 1.0 it is in spack.package.


class Lumbricus(CMakePackage):
    """Finite element computation of chains of liquid-filled, muscle-driven segments, as
    in an earthworm."""

    # Built from the clone it lies in: no tarball can have its own checksum in it.
    git = pathlib.Path(__file__).resolve().parents[4].as_uri()

    license("LGPL-2.1-or-later")

    version("main", branch="main")
    version("0.2.0", tag="v0.2.0")

    variant("native", default=True,
            description="Compile the element kernel for the processor of this machine")
    variant("python", default=False,
            description="Install what the Python package needs beside it")

    # deal.II has these two build types alone.
    variant("build_type", default="Release", description="CMake build type",
            values=("Debug", "Release"))

    depends_on("cmake@3.18:", type="build")
    depends_on("ninja", type="build")
    generator("ninja")

    depends_on("mpi")
    # zlib is in deal.II since it can write VTU files.
    depends_on("dealii@9.4:9.7+mpi+p4est+muparser+trilinos")
    depends_on("mumps@5.5:+mpi+double+float")

    with when("+python"):
        depends_on("python@3.11:", type="run")
        depends_on("py-numpy@1.26:", type="run")
        depends_on("py-pandas@2.1:", type="run")
        depends_on("py-scipy@1.11:", type="run")
        depends_on("py-matplotlib@3.8:", type="run")

    def cmake_args(self):
        return [
            self.define_from_variant("LUMBRICUS_NATIVE", "native"),
            self.define("LUMBRICUS_DEBUG_INFO", False),
            # Its tests are those of scripts/test.sh.
            self.define("CMAKE_DISABLE_FIND_PACKAGE_GTest", True),
            self.define("DEAL_II_DIR", self.spec["dealii"].prefix),
        ]

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def make_a_step(self):
        """One load step of the first case."""
        program = Executable(join_path(self.prefix.bin, "lumbricus"))
        program("parameters/antagonism/case.prm", "--output", "trial",
                "--set", "Time/End=0.05", "--set", "Output/Every=0")
