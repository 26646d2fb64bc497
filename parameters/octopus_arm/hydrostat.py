#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The arm as a slender bar of constant volume: how much it elongates, bends and twists.
Needs NumPy.

With the stretch l along the axis every fibre across is stretched by l^(-1/2). All radii
of the arm are in proportion, so that one section stands for all. Its energy, the mean
over the section of

    a/2 (l^2 + 2/l + w^2 R^2/l - 3) + sum over muscles of T int_1^m f_l(y) dy,

T activation times strength and m the stretch of the fibre, is least at equilibrium. In a
twist w per length the stretch of a fibre at the angle b, s and c its sine and cosine, is
m^2 = c^2 l^2 + (w R c + s)^2/l. In a bend by k per length
l^(3/2) = l_0^(3/2) + 3/2 k z, as dl/dz = k l^(-1/2).
"""
import numpy as np

A, STRENGTH = 0.01, 0.26               # stiffness and strength [N/mm^2]
CORD, TRANSVERSE, LONGITUDINAL = 0.2, 0.6, 0.92  # outer radii over that of the arm
BASE, TIP, LENGTH = 6.0, 2.0, 80.0     # [mm]
BEST_LONGITUDINAL = 1.25
HELIX = np.radians(60)
FASTEST, CURVATURE, LARGEST = 2.43, 1.45, 1.8  # of force-velocity [1/s, 1, 1]
# Length over radius, integrated along the arm: what a bend or a twist is multiplied by.
SLENDERNESS = LENGTH / (BASE - TIP) * np.log(BASE / TIP)


def blemker_work(x):
    """The integral of f_l up to x, from where it begins."""
    x = np.clip(x, 0.4, 1.6)
    low = 3 * (np.minimum(x, 0.6) - 0.4)**3
    middle = np.clip(x, 0.6, 1.4) - 1
    high = 3 * (0.2**3 - (1.6 - np.maximum(x, 1.4))**3)
    return low + (middle + 0.4) - 4 / 3 * (middle**3 + 0.4**3) + high


def section(n=400, m=160):
    """Points of the section, R and z over the radius of the arm, and what part of it
    each stands for."""
    edges = np.array([0, CORD, TRANSVERSE, LONGITUDINAL, 1])
    rings = np.concatenate([np.linspace(a, b, n // 4 + 1)[:-1]
                            for a, b in zip(edges, edges[1:])] + [[1]])
    R = (rings[1:] + rings[:-1]) / 2
    angles = (np.arange(m) + 0.5) * 2 * np.pi / m
    weight = (rings[1:]**2 - rings[:-1]**2)[:, None] * np.full(m, 1 / m)
    return R[:, None] + 0 * weight, R[:, None] * np.sin(angles), weight


R, Z, WEIGHT = section()
IN_TRANSVERSE = (R > CORD) & (R < TRANSVERSE)
IN_LONGITUDINAL = (R > TRANSVERSE) & (R < LONGITUDINAL)
IN_OBLIQUE = R > LONGITUDINAL


def energy(l, twist, transverse, longitudinal, oblique):
    """The mean over the section, over the strength; activations of the muscles."""
    W = A / 2 * (l**2 + (2 + (twist * R)**2) / l - 3) / STRENGTH
    W = W + IN_TRANSVERSE * transverse * 2 * blemker_work(l**-0.5)
    W = W + IN_LONGITUDINAL * longitudinal * BEST_LONGITUDINAL * blemker_work(
        l / BEST_LONGITUDINAL)
    s, c = np.sin(HELIX), np.cos(HELIX)
    W = W + IN_OBLIQUE * oblique * blemker_work(
        np.sqrt((c * l)**2 + (twist * R * c + s)**2 / l))
    return (W * WEIGHT).sum()


def least(function, x):
    """Where a function of a few numbers is least: Newton's method, with differences
    for derivatives."""
    x = np.array(x, dtype=float)
    h = 1e-4 * np.eye(len(x))
    for _ in range(50):
        gradient = np.array([(function(x + a) - function(x - a)) / 2e-4 for a in h])
        hessian = [[(function(x + a + b) - function(x + a - b) - function(x - a + b)
                     + function(x - a - b)) / 4e-8 for a in h] for b in h]
        step = np.linalg.solve(hessian, gradient)
        x -= step
        if np.abs(step).max() < 1e-7:
            return x
    raise ArithmeticError("no minimum found")


def elongation(transverse, longitudinal=0.0):
    """The stretch along the axis."""
    return least(lambda x: energy(x[0], 0, transverse, longitudinal, 0), [1])[0]


def bend(longitudinal, transverse, steps=10):
    """The angle of the tip [degrees] and the stretch on the axis, of the longitudinal
    muscle on the side z > 0."""
    x = np.array([1.0, 0.0])
    for part in np.arange(1, steps + 1) / steps:
        x = least(lambda y: energy((y[0]**1.5 - 1.5 * y[1] * Z)**(2 / 3), 0,
                                   part * transverse,
                                   part * longitudinal * (Z > 0), 0), x)
    return np.degrees(x[1] * SLENDERNESS), x[0]


def twist(oblique):
    """The angle by which the tip turns about the axis [degrees], and the stretch."""
    l, w = least(lambda x: energy(x[0], x[1], 0, 0, oblique), [1, 0])
    return np.degrees(w * SLENDERNESS), l


def hill(v):
    """The part of its tension that a fibre has whose stretch changes at this rate."""
    w = v / FASTEST
    if w < 0:
        return max(0, (1 + w) / (1 - w / CURVATURE))
    return LARGEST - (LARGEST - 1) / (1 + (1 + 1 / CURVATURE) / (LARGEST - 1) * w)


def extension(transverse, end, dt):
    """The stretch along the axis at times up to the end, where the transverse muscle is
    active from t = 0 on: a (l - l^-2) is what its fibres, as they shorten, push with,
    in steps as those of the program."""
    part = transverse * STRENGTH * (TRANSVERSE**2 - CORD**2)
    stretches = [1.0]
    for _ in range(round(end / dt)):
        before, low, high = stretches[-1]**-0.5, 0.5, 3.0
        for _ in range(60):
            l = (low + high) / 2
            m = l**-0.5
            far = abs(m - 1)
            push = part * (1 - 4 * far**2) * hill((m - before) / dt) * m**3
            low, high = (l, high) if A * (l - l**-2) < push else (low, l)
        stretches.append(l)
    return stretches


if __name__ == "__main__":
    for alpha in (0.1, 0.2, 0.3, 0.4):
        l = elongation(alpha)
        print(f"transverse {alpha}: length {l:.4f}, radius {l**-0.5:.4f}")
    for transverse in (0, 0.02):
        angle, l = bend(0.02, transverse)
        print(f"upper longitudinal 0.02, transverse {transverse}: {angle:.2f} degrees, "
              f"length on the axis {l:.4f}")
    angle, l = twist(0.02)
    print(f"right oblique 0.02: {angle:.2f} degrees, length {l:.4f}")
    for dt in (0.02, 0.001):
        stretches = extension(0.4, 0.5, dt)
        all_of_it = elongation(0.4) - 1
        half, most = (next(i for i, l in enumerate(stretches) if l - 1 >= q * all_of_it)
                      for q in (0.5, 0.9))
        print(f"at speed, steps of {dt} s: half of it after {half * dt:.3f} s, 90 % after "
              f"{most * dt:.3f} s, length at 0.1 s {stretches[round(0.1 / dt)]:.4f}")
