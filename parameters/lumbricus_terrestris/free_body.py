#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The wall of active_stress.prm as a long tube without septa, full of liquid: its length and
its pressure at some activations of its two muscles.

Wall and liquid keep their volumes, so that all radii are R/sqrt(l) at the length stretch
l. With the areas A_l and A_c of the layers at rest, the tensions T = activation times
strength, per area at rest, and the stiffness a of both layers, no force at the ends is

    (A_l + A_c) a (l - l^-2) + A_l T_l - A_c T_c l^(-3/2) / 2 = 0

and the pressure is what the circular layer from B to C carries, P = T_c l^(-1/2) ln(C/B):
the passive wall adds nothing, as it is stretched around as much as through.
"""
from math import log, pi

A, STRENGTH = 0.005, 0.13        # [N/mm^2]
INNER, B, C = 3.55, 4.05, 4.25   # radii: chamber, between the layers, outside [mm]
LONGITUDINAL, CIRCULAR = pi * (B**2 - INNER**2), pi * (C**2 - B**2)


def tube(longitudinal, circular):
    """Length stretch and pressure [N/mm^2] at two activations."""
    def force(l):
        return ((LONGITUDINAL + CIRCULAR) * A * (l - l**-2)
                + STRENGTH * (LONGITUDINAL * longitudinal
                              - CIRCULAR * circular / 2 * l**-1.5))

    low, high = 0.1, 5.0
    for _ in range(100):
        l = (low + high) / 2
        low, high = (l, high) if force(l) < 0 else (low, l)
    return l, STRENGTH * circular * l**-0.5 * log(C / B)


def circular_for(pressure, longitudinal):
    """The activation of the circular muscle that makes this pressure."""
    low, high = 0.0, 1.0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = ((middle, high) if tube(longitudinal, middle)[1] < pressure
                     else (low, middle))
    return middle


if __name__ == "__main__":
    print(f"longitudinal muscle at 0.019 pulls with "
          f"{1e3 * 0.019 * STRENGTH * LONGITUDINAL:.1f} mN; 0.69 kPa on the chamber's "
          f"section push with {1e3 * 0.69e-3 * pi * INNER**2:.1f} mN")
    for pair in ((0, 0.16), (0.019, 0), (0.06, 0), (0.12, 0), (0.019, 0.1),
                 (0.06, 0.1), (0.12, 0.1)):
        l, p = tube(*pair)
        print("longitudinal {}, circular {}: ".format(*pair) +
              f"length {100 * (l - 1):+.1f} %, {1e3 * p:.2f} kPa")
    for longitudinal in (0.019, 0.06, 0.12):
        circular = circular_for(0.69e-3, longitudinal)
        l, _ = tube(longitudinal, circular)
        print(f"0.69 kPa: longitudinal {longitudinal}, circular {circular:.3f}, "
              f"length {100 * (l - 1):+.1f} %")
