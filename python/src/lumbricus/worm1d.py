# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worm of one dimension: gaits in a second, for the runs in three that follow.

A segment is a tube of layers, filled with liquid, both incompressible, without septa:
all radii are those at rest over sqrt(l), l the stretch of its length, and with the
active stretches of its muscles, e = 1/G^2, the force along it is::

    T(l) = sum_i A_i mu_i (l e_zz - (e_rr + e_tt)/(2 l^2)),

    circular, c:       e_rr = e_zz = c,  e_tt = c^-2
    longitudinal, c:   e_rr = e_tt = c,  e_zz = c^-2.

Segments of n elements each lie in a row on ground that holds each point up to a limit,
forward k_f and backward k_b per length at rest, with the elastic slip delta as in
doc/theory.md ("Contact and friction"): with the slip s > 0 towards the head::

    f = -K s/(delta max(1, |s| K/(delta k))),   K = max(k_f, k_b),  k = k_f or k_b.

The balance dT/dX + f = 0 is solved at the nodes, step by step. What is not here: septa,
caps, bending, and that thin segments are lifted off by their neighbours. So strides on
ground that is felt by weight are estimates (stride() of a worm in the gallery: see
doc/python.md); lengths and pressures of free segments are exact for segments without
septa.
"""
from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt
from scipy.linalg import solve_banded

Vector = npt.NDArray[np.float64]
# Of time and of the segments s, which count from 1 at the head.
Activation = Callable[[float, Vector], Vector]
CIRCULAR, LONGITUDINAL = "circular", "longitudinal"
MOST_ITERATIONS = 100
TOLERANCE = 1e-11  # of forces, relative to the stiffness of a segment


def wave(amplitude: float, wavelength: float, *, period: float = 1.0, duty: float = 0.5,
         phase: float = 0.0, ramp_in: float = 1.0) -> Activation:
    """The activation 'wave' of doc/parameters.md, towards the tail.

    >>> float(wave(0.2, 4.0, ramp_in=0.0)(0.25, np.array([1.0]))[0])
    0.8
    """
    def value(t: float, s: Vector) -> Vector:
        p = np.mod(t / period - (s - 1) / wavelength + phase, 1.0)
        pulse = np.where(p < duty, 0.5 * (1 - np.cos(2 * np.pi * p / duty)), 0.0)
        q = min(max(t / ramp_in, 0.0), 1.0) if ramp_in > 0 else 1.0
        return np.asarray(1 - amplitude * (3 * q**2 - 2 * q**3) * pulse)
    return value


@dataclasses.dataclass(frozen=True)
class Layer:
    """Of a wall: its thickness [mm], stiffness mu = a of Neo-Hooke [N/mm^2], and the
    direction of its muscle, "circular", "longitudinal" or "" for none."""

    thickness: float
    stiffness: float
    muscle: str = ""


@dataclasses.dataclass(frozen=True)
class Tube:
    """A segment: the radius of its liquid [mm] and its layers from inside to outside.

    >>> tube = Tube(3.0, (Layer(0.3, 0.23, "circular"),))
    >>> c = {"circular": np.array([0.8])}
    >>> length = tube.free_stretch(c)
    >>> print(f"{length[0]:.10f} {tube.pressure(length, c)[0]:.10e}")
    1.1387208645 1.4678770983e-02
    """

    radius: float
    layers: tuple[Layer, ...]

    def _parts(self, active: dict[str, Vector]
               ) -> list[tuple[float, float, Vector, Vector, Vector]]:
        """Of each layer A mu [N], mu ln(outer/inner), e_rr, e_tt, e_zz."""
        parts, inner = [], self.radius
        size = next(iter(active.values())).shape
        for layer in self.layers:
            outer = inner + layer.thickness
            c = active.get(layer.muscle, np.ones(size))
            around = layer.muscle == CIRCULAR
            parts.append((math.pi * (outer**2 - inner**2) * layer.stiffness,
                          layer.stiffness * math.log(outer / inner),
                          c, c**-2.0 if around else c, c if around else c**-2.0))
            inner = outer
        return parts

    def force(self, stretch: Vector, active: dict[str, Vector]) -> tuple[Vector, Vector]:
        """T [N] along a segment at a stretch of its length, and dT/dl."""
        T, slope = np.zeros_like(stretch), np.zeros_like(stretch)
        for stiffness, _, e_rr, e_tt, e_zz in self._parts(active):
            T += stiffness * (stretch * e_zz - (e_rr + e_tt) / (2 * stretch**2))
            slope += stiffness * (e_zz + (e_rr + e_tt) / stretch**3)
        return T, slope

    def free_stretch(self, active: dict[str, Vector]) -> Vector:
        """The stretch of the length without a force along it."""
        parts = self._parts(active)
        above = sum((A * (e_rr + e_tt) / 2 for A, _, e_rr, e_tt, _ in parts), np.zeros(1))
        below = sum((A * e_zz for A, _, _, _, e_zz in parts), np.zeros(1))
        return np.asarray((above / below) ** (1 / 3))

    def pressure(self, stretch: Vector, active: dict[str, Vector]) -> Vector:
        """Of the liquid [N/mm^2], positive in compression."""
        return np.asarray(sum(((e_tt - e_rr) / stretch * logarithm for _, logarithm, e_rr,
                               e_tt, _ in self._parts(active)), np.zeros(1)))


@dataclasses.dataclass(frozen=True)
class Ground:
    """What holds the skin: limits of friction per length at rest [N/mm], numbers or
    functions of time and segment as activations are, and the elastic slip [mm]."""

    forward: float | Activation
    backward: float | Activation
    elastic_slip: float = 1e-3

    def limits(self, t: float, s: Vector) -> tuple[Vector, Vector]:
        """Forward and backward [N/mm] at segments s."""
        forward, backward = (limit(t, s) if callable(limit) else np.full(s.shape, limit)
                             for limit in (self.forward, self.backward))
        return forward, backward


@dataclasses.dataclass(frozen=True)
class Crawl:
    """How a worm has moved, from rest on.

    Attributes:
        t: [time], shape (n_times,).
        nodes: places x of the ends of elements [mm], the head first, towards which x
            falls; shape (n_times, n_elements + 1).
        elements: of a segment.
    """

    t: Vector
    nodes: Vector
    elements: int

    @property
    def lengths(self) -> Vector:
        """Of the segments [mm], shape (n_times, n_segments)."""
        return np.diff(self.nodes[:, ::self.elements], axis=1)

    @property
    def centre(self) -> Vector:
        """x of the centre of mass [mm], shape (n_times,)."""
        return np.asarray(0.5 * (self.nodes[:, 1:] + self.nodes[:, :-1]).mean(axis=1))

    def stride(self, start: float, end: float) -> float:
        """How far the worm comes towards the head between two times [mm]."""
        a, b = np.interp([start, end], self.t, self.centre)
        return float(a - b)


@dataclasses.dataclass(frozen=True)
class Worm:
    """Equal segments in a row::

        tube = Tube(2.0, (Layer(0.15, 0.23, "longitudinal"),
                          Layer(0.15, 0.23, "circular")))
        worm = Worm(20, 2.0, tube)
        gait = {"circular": wave(0.3, 10), "longitudinal": wave(0.3, 10, phase=0.5)}
        worm.crawl(gait, Ground(0.001, 0.004), end=2.0).stride(1.0, 2.0)

    Attributes:
        segments: how many.
        length: of a segment at rest [mm].
        tube: each of them.
        elements: in each.
    """

    segments: int
    length: float
    tube: Tube
    elements: int = 4

    def crawl(self, gait: dict[str, Activation], ground: Ground, *, end: float,
              dt: float = 0.02) -> Crawl:
        """Let the muscles do what the gait says, until a time.

        Raises ArithmeticError where a step has no solution.
        """
        n = self.segments * self.elements
        # An element is as active as its segment is, as in three dimensions.
        s = np.repeat(np.arange(1.0, self.segments + 1), self.elements)
        x = np.arange(n + 1) * self.length / self.elements
        anchors = x.copy()
        n_steps = max(1, round(end / dt))
        times, places = [0.0], [x]
        for step in range(1, n_steps + 1):
            t = end * step / n_steps
            x, anchors = self._step({name: active(t, s) for name, active in gait.items()},
                                    _at_nodes(ground.limits(t, s),
                                              self.length / self.elements),
                                    ground.elastic_slip, x, anchors)
            times.append(t)
            places.append(x)
        return Crawl(np.array(times), np.array(places), self.elements)

    def _step(self, active: dict[str, Vector], limits: tuple[Vector, Vector],
              slip: float, x: Vector, anchors: Vector) -> tuple[Vector, Vector]:
        """The places of nodes and of their anchors. Newton's method with a
        line search on work, as friction is bounded."""
        try:
            x = self._solve(active, limits, slip, x, anchors)
        except ArithmeticError:
            # On softer ground first.
            for softer in (100.0, 30.0, 10.0, 3.0, 1.0):
                x = self._solve(active, limits, softer * slip, x, anchors)
        forward, backward = limits
        reach = np.where(x < anchors, forward, backward) \
            / np.maximum(np.maximum(forward, backward), 1e-300) * slip
        # The anchor of what slides comes after it.
        return x, np.clip(anchors, x - reach, x + reach)

    def _solve(self, active: dict[str, Vector], limits: tuple[Vector, Vector],
               slip: float, x: Vector, anchors: Vector) -> Vector:
        size = self.length / self.elements
        scale = self.tube.force(np.ones(1), {"": np.ones(1)})[1][0]

        def residual(x: Vector) -> tuple[Vector, Vector, Vector]:
            T, slope = self.tube.force(np.diff(x) / size, active)
            f, stiffness = _friction(x - anchors, limits, slip)
            r = f
            r[:-1] += T
            r[1:] -= T
            return r, slope / size, stiffness

        least = 1e-5 * np.maximum(np.maximum(*limits) / slip, 1e-12 * scale / size)
        r, slope, stiffness = residual(x)
        for _ in range(MOST_ITERATIONS):
            if np.abs(r).max() <= TOLERANCE * scale:
                return x
            bands = np.zeros((3, len(x)))
            # A little against sliding, where all of it does.
            bands[1] = np.where(stiffness > 0, stiffness, least)
            bands[1, :-1] += slope
            bands[1, 1:] += slope
            bands[0, 1:] = bands[2, :-1] = -slope
            dx = solve_banded((1, 1), bands, r)
            # Not through itself, and no farther than work is done on the way.
            part = min(1.0, 0.5 / max(1e-300, float((-np.diff(dx) / np.diff(x)).max())))
            work = float(r @ dx)
            while True:
                trial = residual(x + part * dx)
                if abs(float(trial[0] @ dx)) <= 0.9 * abs(work) or part < 1e-9:
                    break
                part /= 2
            x = x + part * dx
            r, slope, stiffness = trial
        raise ArithmeticError(f"No equilibrium after {MOST_ITERATIONS} iterations.")


def _at_nodes(limits: Sequence[Vector], size: float) -> tuple[Vector, Vector]:
    """Limits of nodes [N] from those of elements [N/mm]: half of each neighbour's."""
    forward, backward = (0.5 * size * (np.append(limit, 0) + np.insert(limit, 0, 0))
                         for limit in limits)
    return forward, backward


def _friction(along: Vector, limits: tuple[Vector, Vector],
              slip: float) -> tuple[Vector, Vector]:
    """The force of the ground [N] at nodes that are so far from their anchors along x,
    which is backward, and minus its derivative."""
    forward, backward = limits
    stiffness = np.maximum(forward, backward) / slip
    limit = np.where(along < 0, forward, backward)
    sticks = stiffness * np.abs(along) <= limit
    force = np.where(sticks, -stiffness * along, -np.sign(along) * limit)
    return force, np.where(sticks, stiffness, 0.0)
