#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A long closed tube whose wall has two families of crossed helical fibres, blown up.

Its wall is incompressible, a Neo-Hookean ground of stiffness a with fibres at the
angles b and -b to the axis, so that it neither twists nor bends: with the length
stretch l, all radii are r^2 = r_i^2 + (R^2 - A^2)/l, where A is the inner radius at
rest, and the stretches at R are q = r/R around and l along. Per volume at rest

    W(q, l) = a/2 (q^2 + l^2 + 1/(q l)^2 - 3) + 2 k1/(2 k2) (exp(k2 E^2) - 1),
    E = max(0, q^2 sin(b)^2 + l^2 cos(b)^2 - 1),

and with W_q and W_l, its derivatives, the balance across the wall and that of wall
and pressure at the closed ends are

    p = int q W_q R dR/(l r^2),
    0 = T = pi int (2 l W_l - q W_q) R dR.

Where the fibres are so stiff that they keep their length, l = cos(b')/cos(b) and the
volume inside goes as sin(b')^2 cos(b') (Clark and Cowey, J. Exp. Biol. 35 (1958) 731),
where b' is the angle that the fibres have come to. Where there is none, there is no
volume beyond that at tan(b')^2 = 2, which is 54.7356 degrees.

    closed_form.py [RUN_DIR ...]     a table, beside the stretch in the middle of runs
"""
import csv
import math
import pathlib
import sys

MAGIC = math.degrees(math.atan(math.sqrt(2)))
# Of Gauss with five points on [-1, 1].
GAUSS = [(0., 128 / 225)] + [
    (sign * math.sqrt(5 + side * 2 * math.sqrt(10 / 7)) / 3,
     (322 - side * 13 * math.sqrt(70)) / 900)
    for sign in (-1, 1) for side in (-1, 1)]


def root(f, low, high):
    """Of f, which has other signs at both ends."""
    at_low = f(low)
    assert at_low * f(high) < 0
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if at_low * f(middle) > 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2


class Tube:
    """Of the inner radius and the thickness at rest, with fibres at an angle in
    degrees."""

    def __init__(self, angle, k1, k2=0., a=0.05, radius=2., thickness=0.1):
        self.sine2 = math.sin(math.radians(angle))**2
        self.k1, self.k2, self.a = k1, k2, a
        self.radius, self.outer = radius, radius + thickness

    def slopes(self, q, l):
        """q W_q and l W_l."""
        s2, c2 = self.sine2, 1 - self.sine2
        E = max(0., q * q * s2 + l * l * c2 - 1)
        tension = 4 * self.k1 * E * math.exp(min(self.k2 * E * E, 300.))
        r2 = 1 / (q * l)**2
        return (self.a * (q * q - r2) + tension * s2 * q * q,
                self.a * (l * l - r2) + tension * c2 * l * l)

    def integral(self, f, inner2, l):
        """int f(q W_q, l W_l, r^2) R dR through the wall, where r_i^2 = inner2."""
        n, total = 4, 0.
        h = (self.outer - self.radius) / n
        for k in range(n):
            for x, weight in GAUSS:
                R = self.radius + h * (k + (1 + x) / 2)
                r2 = inner2 + (R * R - self.radius**2) / l
                total += h / 2 * weight * R * f(
                    *self.slopes(math.sqrt(r2) / R, l), r2)
        return total

    def force(self, inner2, l):
        """T, of the wall and of the pressure on its ends."""
        return math.pi * self.integral(lambda q, z, r2: 2 * z - q, inner2, l)

    def pressure(self, inner2, l):
        return self.integral(lambda q, z, r2: q / (l * r2), inner2, l)

    def at_volume(self, volume):
        """l and p at the volume inside, relative to that at rest."""
        def inner2(l):
            return self.radius**2 * volume / l
        l = root(lambda l: self.force(inner2(l), l), 0.05, 5.)
        return l, self.pressure(inner2(l), l)

    def at_pressure(self, pressure, most=8.):
        """l and the volume at a pressure."""
        volume = root(lambda v: self.at_volume(v)[1] - pressure, 1 - 1e-9, most)
        return self.at_volume(volume)[0], volume

    def angle(self, l, volume):
        """Of the fibres in the middle of the wall, at this l and volume."""
        R2 = self.middle2()
        r2 = self.radius**2 * volume / l + (R2 - self.radius**2) / l
        around, along = math.sqrt(r2 / R2 * self.sine2), \
            l * math.sqrt(1 - self.sine2)
        return math.degrees(math.atan2(around, along))

    def middle2(self):
        """R^2 of the surface that halves the wall's volume."""
        return (self.radius**2 + self.outer**2) / 2

    def inextensible(self, volume):
        """l where the fibres, all in the middle of the wall, keep their length,
        and the angle that they come to; what is inside of them is the volume, and
        half of the wall."""
        inside = self.radius**2 / self.middle2()
        of_rest = self.sine2 * math.sqrt(1 - self.sine2)
        target = of_rest * (volume * inside + 1 - inside)
        start = math.acos(math.sqrt(1 - self.sine2))
        end = math.radians(MAGIC)
        if target >= 2 / math.sqrt(27):
            return math.nan, math.nan
        b = root(lambda b: math.sin(b)**2 * math.cos(b) - target, start, end)
        return math.cos(b) / math.cos(start), math.degrees(b)


def middle_of(folder):
    """Time, pressure and length stretch in the middle of a run: of the two points
    of its Output/Points."""
    with open(pathlib.Path(folder) / "segments.csv") as file:
        pressures = {float(row["t"]): float(row["fluid_pressure"])
                     for row in csv.DictReader(file)}
    places = {}
    with open(pathlib.Path(folder) / "points.csv") as file:
        for row in csv.DictReader(file):
            places.setdefault(float(row["t"]), []).append(
                (float(row["x"]), float(row["x"]) + float(row["ux"])))
    for t, (first, second) in places.items():
        yield t, pressures[t], \
            (second[1] - first[1]) / (second[0] - first[0])


def main():
    print("fibres ten times as stiff, again and again: the length at a volume")
    for start, volume in ((30, 1.4), (70, 1.2)):
        for k1 in (0.1, 1, 10, 100, 1000):
            tube = Tube(start, k1)
            l, p = tube.at_volume(volume)
            limit, b = tube.inextensible(volume)
            print(f"{start:3} {volume:4} {k1:7} l {l:.6f} p {p:.6f} "
                  f"angle {tube.angle(l, volume):.3f}; inextensible {limit:.6f} "
                  f"{b:.3f}, {l / limit - 1:+.2e}")
    for folder in sys.argv[1:]:
        start = float(pathlib.Path(folder).name.split("_")[-1])
        print(folder)
        for t, p, l in middle_of(folder):
            if p > 1e-6:
                tube = Tube(start, 5., 100.)
                expected, volume = tube.at_pressure(p)
                print(f"{t:5} p {p:.6f} l {l:.5f}, closed form {expected:.5f}, "
                      f"angle {tube.angle(expected, volume):.2f}")


if __name__ == "__main__":
    main()
