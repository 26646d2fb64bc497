#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Twist and stretch of a long closed tube with one family of helical fibres."""
from math import cos, degrees, radians, sin

A, B = 2.0, 2.2  # radii of the wall at rest [mm]
R1 = 2 / 3 * (B**3 - A**3) / (B**2 - A**2)  # mean of R over the wall
R2 = (A**2 + B**2) / 2                      # mean of R^2


def closed_form(angle, L):
    """Twist per length at rest and axial stretch, at the active stretch L."""
    s, c = sin(radians(angle)), cos(radians(angle))
    D = L**3 * s**2 + c**2
    twist = -(1 - L**3) * s * c * R1 / (R2 * D)
    E = 2 * L**3 + (1 - L**3) * s**2 - R2 * D * twist**2
    return twist, (E / (2 * D))**(1 / 3)


for angle in (15, 30, 45, 60, 75):
    twist, stretch = closed_form(angle, 0.75)
    print(f"{angle} degrees: twist {twist:.5f} 1/mm = {degrees(twist):.3f} "
          f"degrees/mm, stretch {stretch:.4f}, radius {stretch**-0.5:.4f}")
