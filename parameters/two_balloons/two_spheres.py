#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Two thick spheres of one pressure, of which one has what the other has not: the theory,
and FOLDER/curve.png with a run in FOLDER. Needs NumPy and Matplotlib, no display.
"""

import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot import figures  # noqa: E402
from lumbricus.plot.tables import read_table  # noqa: E402


def pressure(volume):
    """int 2 (l^2 - l^-4) dr/r [N/mm^2] through a wall with the radii 1 and 2 mm and
    a = 1 N/mm^2, l = r/R, at so many times the volume inside, by the rule of Gauss and
    Legendre."""
    points, weights = np.polynomial.legendre.leggauss(30)
    rest = 1.5 + 0.5 * points
    now = np.cbrt(rest**3 + np.atleast_1d(volume)[:, None] - 1)
    hoop = now / rest
    return np.sum(weights * (hoop**2 - hoop**-4) * rest**2 / now**3, axis=1)


def limit():
    """The volume at which the pressure is highest, by golden sections."""
    low, high, part = 2.0, 20.0, (5**0.5 - 1) / 2
    while high - low > 1e-9:
        a, b = high - part * (high - low), low + part * (high - low)
        low, high = (a, high) if pressure(a) < pressure(b) else (low, b)
    return 0.5 * (low + high)


def other(volume):
    """The volume below the limit of the same pressure as each of these beyond it, by
    bisection."""
    goal = pressure(volume)
    low, high = np.ones_like(goal), np.full_like(goal, limit())
    for _ in range(60):
        middle = 0.5 * (low + high)
        below = pressure(middle) < goal
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    table = read_table(folder / "segments.csv")
    volumes = [table["fluid_volume"][table["segment"] == s] for s in (1, 2)]
    volumes = [v / v[0] for v in volumes]
    both = sum(volumes)
    found = table["t"][table["segment"] == 1]
    miss = max(np.max(np.abs(found[1:] / pressure(v[1:]) - 1)) for v in volumes)
    print(f"{len(both) - 1} steps; pressure off by {miss:.1e} of the formula's at most; "
          f"volumes at the end {volumes[0][-1]:.3f}, {volumes[1][-1]:.3f}")

    figure, axes = figures.plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
    blue, red = "#2471a3", "#c0392b"
    alike = np.linspace(1, 0.5 * both[-1], 200)
    large = np.linspace(limit(), max(v[-1] for v in volumes), 200)
    small = other(large)
    for axis, on_branch in ((axes[0], (large, small)), (axes[1], (pressure(large),))):
        straight = alike if axis is axes[0] else pressure(alike)
        axis.plot(2 * alike, straight, color=blue, linewidth=0.8, linestyle="--",
                  label="both alike")
        for curve in on_branch:
            axis.plot(large + small, curve, color=blue, label="one grows")
        axis.axvline(2 * limit(), color="0.7", linewidth=0.8)
        axis.set_xlabel("both volumes together [$V_0$]")
    for v in volumes:
        axes[0].plot(both, v, "o", color=red, markersize=4)
    axes[1].plot(both, found, "o", color=red, markersize=4, label="steps of the run")
    axes[0].set_ylabel("volume of each [$V_0$]")
    axes[1].set_ylabel("pressure [N/mm²]")
    axes[1].legend(frameon=False)
    figure.savefig(folder / "curve.png", dpi=150)


if __name__ == "__main__":
    main()
