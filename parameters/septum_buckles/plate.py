#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A clamped circular plate whose edge moves inwards: when it buckles, and how far. Draws a
run in FOLDER beside it, FOLDER/curve.png. Needs SciPy and Matplotlib, no display.

With the displacement u of the middle plane and w across it, the rotation psi of the
normal and the radius r, under axial symmetry (von Karman; Mindlin's shear, factor 5/6):

    N_r = C (u' + w'^2/2 + nu u/r),   N_t = C (u/r + nu (u' + w'^2/2)),
    (r N_r)' = N_t,   D (psi'' + psi'/r - psi/r^2) = N_r w',   w' = psi/(1 + N_r/S),

C = E h/(1 - nu^2), D = C h^2/12, S = 5/6 G h, psi = 0 and u = -e a at the edge, r = a. It
buckles at N_r = -14.68 D/a^2 without shear: 14.68 is the square of the first zero of J_1.
"""

import argparse
import pathlib
import sys

import numpy as np
from scipy.integrate import solve_bvp
from scipy.special import j1, jn_zeros

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot import figures  # noqa: E402
from lumbricus.plot.tables import read_table  # noqa: E402

RADIUS, THICKNESS, NU = 2.0, 0.1, 0.5  # mm, mm, incompressible
ZERO = jn_zeros(1, 1)[0]
# In units of C, with the radius 1.
BENDING = (THICKNESS / RADIUS)**2 / 12
SHEAR = 5 / 6 * (1 - NU) / 2  # G = E/(2 (1 + nu))


def critical_strain(with_shear=True):
    """How far the edge has moved, in radii, when it buckles: N_r = -C (1 + nu) e."""
    force = ZERO**2 * BENDING
    return force / (1 + force / SHEAR if with_shear else 1) / (1 + NU)


def amplitude(strains):
    """How far the middle is aside of the edge [mm] at these strains of the edge, which
    rise and are 1.005 times the critical one at least. Each solution is the next one's
    first guess."""
    way_there = np.geomspace(1.005 * critical_strain(), max(strains), 20)
    strains = np.asarray(strains)
    all_strains = np.union1d(way_there[way_there < max(strains)], strains)
    r = np.linspace(1e-6, 1, 200)
    size = 0.02
    wave = size * j1(ZERO * r)
    y = np.array([wave, np.gradient(wave, r), -all_strains[0] * r,
                  -(1 + NU) * all_strains[0] * r])
    found = []
    for strain in all_strains:
        # Of psi, psi', u, N_r r.
        def equations(r, y):
            psi, bend, u, pull = y
            n = pull / r
            way = psi / (1 + n / SHEAR)
            stretch = n - 0.5 * way**2 - NU * u / r  # u'
            hoop = u / r + NU * (stretch + 0.5 * way**2)
            return np.array([bend, n * way / BENDING - bend / r + psi / r**2, stretch,
                             hoop])

        solution = solve_bvp(
            equations,
            lambda a, b, e=strain: np.array([a[0], a[2], b[0], b[2] + e]),
            r, y, tol=1e-6, max_nodes=20000)
        if not solution.success:
            raise ValueError(solution.message)
        y = solution.sol(r)
        psi, _, _, pull = y
        way = psi / (1 + pull / r / SHEAR)
        found.append(RADIUS * abs(np.sum(0.5 * (way[1:] + way[:-1]) * np.diff(r))))
    return np.array(found)[np.isin(all_strains, strains)]


def steps(folder):
    """Of a run, in all steps: time, strain of the edge, and how far the middle is aside
    of it [mm]."""
    table = read_table(pathlib.Path(folder) / "points.csv")
    middle, edge = ({name: table[name][table["point"] == k]
                     for name in ("t", "ux", "uy")} for k in (1, 2))
    return middle["t"], -edge["uy"] / RADIUS, np.abs(middle["ux"] - edge["ux"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    _, strain, aside = steps(folder)
    critical = critical_strain()
    print(f"critical strain {critical:.6f}, without shear {critical_strain(False):.6f}")
    beyond = strain > 1.05 * critical
    for e, w, theory in zip(strain[beyond], aside[beyond], amplitude(strain[beyond])):
        print(f"strain {e:.6f}: {w:.5f} mm, theory {theory:.5f} ({w / theory - 1:+.4f})")

    figure, axes = figures.plt.subplots(figsize=(6, 3.6), layout="constrained")
    curve = critical * np.geomspace(1.005, max(strain) / critical, 40)
    axes.plot([0, 100 * critical, *(100 * curve)],
              [0, 0, *(amplitude(curve) / THICKNESS)], color="#2471a3",
              label="clamped plate")
    axes.plot(100 * strain, aside / THICKNESS, "o", color="#c0392b", markersize=4,
              label="steps of the run")
    axes.set_xlabel("strain of the edge inwards [%]")
    axes.set_ylabel("middle aside [thicknesses]")
    axes.legend(frameon=False)
    figure.savefig(folder / "curve.png", dpi=150)


if __name__ == "__main__":
    main()
