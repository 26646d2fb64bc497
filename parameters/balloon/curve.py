#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draw the pressure over the hoop stretch inside, of a run of beyond.prm and by the
formula of the README: FOLDER/curve.png. Needs NumPy and Matplotlib, no display.
"""

import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot import figures  # noqa: E402
from lumbricus.plot.tables import read_table  # noqa: E402

RADIUS, WALL, A = 10.0, 0.5, 0.23  # mm, mm, N/mm^2: those of case.prm
PER_TIME = 0.01426  # N/mm^2


def pressure(stretch):
    """int 2 a (l^2 - l^-4) dr/r [N/mm^2] through the wall, at hoop stretches inside,
    by the rule of Gauss and Legendre."""
    points, weights = np.polynomial.legendre.leggauss(20)
    rest = RADIUS + 0.5 * WALL * (1 + points)
    now = np.cbrt(rest**3 + RADIUS**3 * (np.atleast_1d(stretch)[:, None]**3 - 1))
    hoop = now / rest
    return 0.5 * WALL * np.sum(weights * 2 * A * (hoop**2 - hoop**-4) *
                               rest**2 / now**3, axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    table = read_table(folder / "points.csv")
    stretch = 1 + table["ux"] / RADIUS
    found = PER_TIME * table["t"]
    miss = found[1:] / pressure(stretch[1:]) - 1
    print(f"largest difference {np.max(np.abs(miss)):.1e}, at the end "
          f"{miss[-1]:.1e}; hoop stretch there {stretch[-1]:.3f}")

    figure, axes = figures.plt.subplots(figsize=(6, 3.6), layout="constrained")
    curve = np.linspace(1, stretch[-1], 300)
    axes.plot(curve, 1e3 * pressure(curve), color="#2471a3", label="formula")
    axes.plot(stretch, 1e3 * found, "o", color="#c0392b", markersize=4,
              label="steps of the run")
    axes.set_xlabel("hoop stretch inside")
    axes.set_ylabel("pressure [kPa]")
    axes.legend(frameon=False)
    figure.savefig(folder / "curve.png", dpi=150)


if __name__ == "__main__":
    main()
