#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The tentacle as a beam without ends and septa: its angle at some times. Needs NumPy.

In a section the wall's stretch along the axis is l = l0 - k q z, with the curvature k
per length at rest, the mean q of the hoop stretches q_i around the section, and
l0 = q^-2, which keeps the volume of the liquid. With the active stretch L (1 in the
passive layer) the energy per volume of wall is

    W = a/2 (l^2/L^2 + L (q_i^2 + 1/(l q_i)^2) - 3)

and k and all q_i are those of its least mean.
"""
import numpy as np

N = 16                      # points around half of the section
LENGTH = 6 * 3 + 5 * 0.2    # from cap to cap [mm]
LAYERS = [(2, 2.15, 0.25),  # radii [mm], contraction per height [1/mm]
          (2.15, 2.3, 0)]


def energy(unknowns, t):
    k, hoop = unknowns[0], unknowns[1:]
    q = hoop.mean()
    total = 0
    for inner, outer, contraction in LAYERS:
        z = (inner + outer) / 2 * np.cos(np.pi * (np.arange(N) + 0.5) / N)
        L = 1 - contraction * t * np.maximum(z, 0)
        l = q**-2 - k * q * z
        W = l**2 / L**2 + L * (hoop**2 + 1 / (l * hoop)**2)
        total += (outer**2 - inner**2) * W.mean()
    return total


def least(t, x):
    """Newton's method with differences for derivatives."""
    h = 1e-4 * np.eye(len(x))
    for _ in range(20):
        gradient = [(energy(x + a, t) - energy(x - a, t)) / 2e-4 for a in h]
        hessian = [[(energy(x + a + b, t) - energy(x + a - b, t)
                     - energy(x - a + b, t) + energy(x - a - b, t)) / 4e-8
                    for a in h] for b in h]
        step = np.linalg.solve(hessian, gradient)
        x = x - step
        if np.abs(step).max() < 1e-6:
            return x
    raise ArithmeticError("no minimum found")


x = np.append(0, np.ones(N))
for i in range(1, 11):
    x = least(i / 10, x)
    print(f"t = {i / 10:.1f}: {np.degrees(x[0] * LENGTH):.2f} degrees, "
          f"length {x[1:].mean()**-2:.4f}")
