# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick sphere of an incompressible Neo-Hookean rubber around a cavity."""


def pressure(volume, radius, thickness, a):
    """What blows the cavity, of that radius at rest, up to so many times its volume:
    p = int 2 (sigma_t - sigma_r) dr/r = int 2 a (l^2 - l^-4) dr/r, l = r/R, by
    Simpson's rule."""
    growth, n = radius**3 * (volume - 1), 400
    h = thickness / n

    def f(R):
        r = (R**3 + growth)**(1 / 3)
        return 2 * a * ((r / R)**2 - (r / R)**-4) * (R / r)**2 / r
    return h / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(radius + i * h)
                       for i in range(n + 1))
