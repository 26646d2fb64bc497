# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast the element kernels are on one core: the time per cell, what part
that is of the speed of dgemm, and of the bandwidth of the memory for what is bound by
it. The least times count, so that other load matters little."""
import os
import pathlib
import subprocess

BUILD = pathlib.Path(os.environ["LUMBRICUS"]).parent


def main():
    subprocess.run(["cmake", "--build", str(BUILD), "--target",
                    "benchmark_kernels"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([str(BUILD / "benchmarks" / "kernels" / "benchmark_kernels")],
                   check=True)


if __name__ == "__main__":
    main()
