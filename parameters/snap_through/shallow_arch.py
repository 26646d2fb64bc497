#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draw the load over how far the crown goes down, of a run of case.prm and by the theory
of shallow arches: FOLDER/curve.png. Needs NumPy and Matplotlib, no display.
"""

import argparse
import pathlib
import sys

import numpy as np

from arch import ANGLE, RADIUS, THICKNESS, WIDTH

YOUNG = 3 * 0.23    # N/mm^2, of case.prm
PER_TIME = 1e-6     # N/mm^2


def path(n=4000):
    """How far the crown is down [mm] and the load on the arch [N/mm^2], at points of
    the curve of a clamped shallow arch of constant curvature k0 (Schreyer and Masur,
    J. Eng. Mech. Div. ASCE 92 (1966) 1), in order of the former.

    With the thrust H = m^2 EI, half the span L and the load q on a length,

        EI v'''' + H v'' = q - H k0 = EI p,   v = v' = 0 at L,
        H/EA = -1/L int_0^L (v'^2/2 + k0 x v') dx,

    of which the second is quadratic in p where m is given. Where the arch hangs H < 0,
    and m is imaginary."""
    half = RADIUS * np.sin(ANGLE)
    k0 = 2 * RADIUS * (1 - np.cos(ANGLE)) / half**2
    stiff_long = YOUNG * WIDTH * THICKNESS
    stiff_bent = stiff_long * THICKNESS**2 / 12
    points, weights = np.polynomial.legendre.leggauss(40)
    x, weights = half * (1 + points) / 2, weights * half / 2
    curve = []
    for mu in np.concatenate([1j * np.linspace(4, 0.01, n),
                              np.linspace(0.01, 1.99 * np.pi, n)]):
        m = mu / half
        thrust = (m**2).real * stiff_bent
        if abs(np.sin(mu)) < 1e-6:
            continue
        slope = (x / m**2 - half / (m**2 * np.sin(mu)) * np.sin(m * x)).real
        crown = (-half**2 / (2 * m**2) +
                 half / (m**3 * np.sin(mu)) * (1 - np.cos(mu))).real
        a = np.sum(weights * slope**2) / 2
        b = k0 * np.sum(weights * x * slope)
        c = thrust * half / stiff_long
        if b * b < 4 * a * c:
            continue
        for sign in (1, -1):
            p = (-b + sign * np.sqrt(b * b - 4 * a * c)) / (2 * a)
            curve.append((p * crown, (stiff_bent * p + thrust * k0) / WIDTH))
    curve = np.array(sorted(curve))
    return curve[:, 0], curve[:, 1]


def limits(down, load):
    """The highest load before the crown is as far below the feet as it was above, and
    the lowest one after that."""
    rise = RADIUS * (1 - np.cos(ANGLE))
    there = (down > 0) & (down < 2 * rise)
    down, load = down[there], load[there]
    top = np.argmax(np.where(down < rise, load, -np.inf))
    bottom = top + np.argmin(load[top:])
    return load[top], load[bottom]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                           / "python" / "src"))
    from lumbricus.plot import figures
    from lumbricus.plot.tables import read_table

    table = read_table(folder / "points.csv")
    down, load = path()
    print("limit points of the theory at t = {:.5f} and {:.5f}".format(
        *(value / PER_TIME for value in limits(down, load))))
    seen = (down > 0) & (load < 1.02 * PER_TIME * np.max(table["t"]))
    figure, axes = figures.plt.subplots(figsize=(6, 3.6), layout="constrained")
    axes.plot(down[seen], 1e6 * load[seen], color="#2471a3",
              label="theory of shallow arches")
    axes.plot(-table["uy"], 1e6 * PER_TIME * table["t"], "o", color="#c0392b",
              markersize=4, label="steps of the run")
    axes.set_xlabel("way of the crown [mm]")
    axes.set_ylabel("load [Pa]")
    axes.legend(frameon=False)
    figure.savefig(folder / "curve.png", dpi=150)


if __name__ == "__main__":
    main()
