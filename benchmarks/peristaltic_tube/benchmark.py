# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a tube crawls in a period of peristalsis, on friction without pressure,
against a worm of one dimension: by backward friction, and by its radius."""
import argparse
import math

import numpy as np
from lumbricus_run import SOURCE, run_well

CASE = SOURCE / "tests" / "physics" / "thin_tube.prm"
CHAIN = "Geometry/segment chain/"
STRENGTH = "Boundary conditions/ground/contact/Shear strength="
# Of the tube whose radius is 2; others are thinner in all their measures but the
# length of a segment [mm, N, N/mm^2].
RADIUS, LAYERS, SEPTUM, CAP = 2, (0.15, 0.15), 0.1, 0.3
SEGMENTS, LENGTH, WAVELENGTH = 20, 2, 10
STIFFNESS, AMPLITUDE, DUTY, SLIP = 0.23, 0.3, 0.5, 0.01
FORWARD, BACKWARD = 0.001, 0.004
STEP = 0.04


def pulses(t, segments, wavelength, ramp):
    """The active stretches of both layers, as 'wave' has them."""
    q = min(t / ramp, 1)
    phases = t - (segments - 1) / wavelength
    found = []
    for phase in (phases + 0.5, phases):
        p = phase - np.floor(phase)
        pulse = np.where(p < DUTY, 0.5 * (1 - np.cos(2 * np.pi * p / DUTY)), 0)
        found.append(1 - AMPLITUDE * (3 * q**2 - 2 * q**3) * pulse)
    return found


def axial_force(stretch, long, circ):
    """T of a filled tube whose ends are pistons, and dT/dl: with the radii R/l^(1/2)
    it is sum A mu (l e_zz - (e_rr + e_tt)/(2 l^2)) over its layers, e = G^-1 G^-T,
    whatever the pressure is."""
    radii = RADIUS + np.array([0, LAYERS[0], LAYERS[0] + LAYERS[1]])
    areas = STIFFNESS * np.pi * np.diff(radii**2)
    force, slope = 0, 0
    for area, e_zz, sides in ((areas[0], long**-2, 2 * long),
                              (areas[1], circ, circ + circ**-2)):
        force = force + area * (stretch * e_zz - 0.5 * sides / stretch**2)
        slope = slope + area * (e_zz + sides / stretch**3)
    return force, slope


def friction(forward, backward, elastic_slip, two_stiffnesses=False):
    """What holds a unit of length that has slipped, its derivative, and how far that
    is elastic, which is equally stiff both ways, unless it slips equally far. The head
    is at x = 0, so that forward is down."""
    def of(slip):
        limit = np.where(slip <= 0, forward, backward)
        stiffness = (limit if two_stiffnesses else
                     max(forward, backward)) / elastic_slip
        slides = np.abs(slip) * stiffness > limit
        return (np.where(slides, -np.sign(slip) * limit, -stiffness * slip),
                np.where(slides, 0, -stiffness), limit / stiffness)
    return of


def worm_of_one_dimension(hold, *, segments=SEGMENTS, wavelength=WAVELENGTH,
                          step=STEP, ramp=1, start=1, end=2, cells=16):
    """The stride from start to end on the friction hold, in steps like those of the
    program, with so many linear elements in a segment."""
    n = segments * cells
    h = LENGTH / cells
    of_cell = np.arange(n) // cells + 1
    width = np.full(n + 1, h)
    width[[0, -1]] /= 2
    u, anchor = np.zeros(n + 1), np.zeros(n + 1)
    strides = {}
    for k in range(1, round(end / step) + 1):
        long, circ = pulses(k * step, of_cell, wavelength, ramp)

        def residual(u):
            force, stiffness = axial_force(1 + np.diff(u) / h, long, circ)
            held, slope, _ = hold(u - anchor)
            r = held * width
            r[:-1] += force
            r[1:] -= force
            return r, stiffness / h, slope * width

        r, stiffness, slope = residual(u)
        for _ in range(200):
            if np.abs(r).max() < 1e-13:
                break
            # A little against sliding, where all of it does.
            diagonal = np.where(slope < 0, -slope,
                                -1e-5 * hold(np.zeros(1))[1] * width)
            diagonal[:-1] += stiffness
            diagonal[1:] += stiffness
            matrix = np.diag(diagonal) - np.diag(stiffness, 1) - \
                np.diag(stiffness, -1)
            du = np.linalg.solve(matrix, r)
            work, part = r @ du, 1
            while part > 1e-9:
                trial = residual(u + part * du)
                if abs(trial[0] @ du) <= 0.9 * abs(work):
                    break
                part /= 2
            u = u + part * du
            r, stiffness, slope = trial
        assert np.abs(r).max() < 1e-13, k * step
        slip = u - anchor
        most = hold(slip)[2]
        anchor = np.where(np.abs(slip) > most, u - np.sign(slip) * most, anchor)
        strides[round(k * step, 9)] = -(u @ width) / width.sum()
    return strides[end] - strides[start]


def tube(radius, forward, backward, ranks):
    """The same of the program."""
    part = radius / RADIUS
    strength = [f"{q * part / (2 * math.pi * (RADIUS + sum(LAYERS))):.10g}"
                for q in (forward, backward)]
    result = run_well(CASE, f"{radius:g}-{forward:g}-{backward:g}", [
        CHAIN + f"Radius={radius}",
        CHAIN + f"Segment length={LENGTH - SEPTUM * part}",
        CHAIN + "Wall layer thicknesses="
        + ", ".join(f"{layer * part:g}" for layer in LAYERS),
        CHAIN + f"Septum thickness={SEPTUM * part:g}",
        CHAIN + f"Cap thickness={CAP * part:g}",
        STRENGTH + ", ".join([*strength, "0"])], ranks=ranks)
    strides = {round(row["t"], 9): row["stride"]
               for row in result.table("body.csv")}
    return strides[2] - strides[1]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ranks", type=int, default=1)
    options = parser.parse_args()
    print("| backward / forward | radius [mm] | one dimension: stride [mm] | tube | "
          "difference |\n" + "|---" * 5 + "|")
    for backward, radius in ((BACKWARD, 0.2), (0.002, 0.2), (0.01, 0.2),
                             (BACKWARD, 1), (BACKWARD, 2)):
        expected = worm_of_one_dimension(friction(FORWARD, backward, SLIP))
        found = tube(radius, FORWARD, backward, options.ranks)
        print(f"| {backward / FORWARD:g} | {radius:g} | {expected:.4f} | "
              f"{found:.4f} | {100 * (found / expected - 1):+.1f} % |", flush=True)

    print("\n| elastic slip [mm] | one dimension: stride [mm] | slipping equally far "
          "both ways |\n" + "|---" * 3 + "|")
    for slip in (0.1, 0.03, SLIP):
        strides = [worm_of_one_dimension(friction(FORWARD, BACKWARD, slip, two))
                   for two in (False, True)]
        print(f"| {slip:g} | " + " | ".join(f"{s:.4f}" for s in strides) + " |")


if __name__ == "__main__":
    main()
