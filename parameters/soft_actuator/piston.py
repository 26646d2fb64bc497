#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The pressure that stretches a chamber whose outside cannot get wider: A and B are the
radii of its wall at rest. A point at R goes to r^2 = B^2 - (B^2 - R^2)/l, and the
chamber's volume per length at rest, pi (l B^2 - (B^2 - A^2)), grows by pi B^2 with the
stretch l, so that p = W'(l) / (pi B^2) with the energy W of the wall per length.
"""
from math import pi

A, B = 2.0, 3.0  # [mm]
SHEAR_MODULUS = 0.05  # [N/mm^2]
LENGTH = 16.0  # [mm]


def energy(stretch, n=400):
    total = 0
    for i in range(n):
        R = A + (B - A) * (i + 0.5) / n
        hoop = (B**2 - (B**2 - R**2) / stretch) / R**2  # squared
        total += (stretch**2 + hoop + 1 / (stretch**2 * hoop) - 3) * R
    return pi * SHEAR_MODULUS * total * (B - A) / n


def pressure(stretch, h=1e-4):
    return (energy(stretch + h) - energy(stretch - h)) / (2 * h * pi * B**2)


def stretch_at(p):
    low, high = 1.0, 3.0
    while high - low > 1e-10:
        middle = (low + high) / 2
        low, high = (middle, high) if pressure(middle) < p else (low, middle)
    return low


for i in range(1, 11):
    print(f"{0.004 * i:.3f} N/mm^2: {LENGTH * stretch_at(0.004 * i):.3f} mm")
