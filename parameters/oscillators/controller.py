#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A chain of coupled phase oscillators, one for each segment, as a controller of
the muscles: controller.py ADDRESS

    d(theta_i)/dt = 2 pi/T + K (sin(theta_(i-1) - theta_i - phi)
                                + sin(theta_(i+1) - theta_i + phi))

All begin together. Neighbours pull each other to a lag of phi: a wave of 2 pi/phi
segments that nobody has prescribed travels towards the tail."""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))
from lumbricus.controller import Controller  # noqa: E402


class Oscillators(Controller):
    """The period is 1; the lag is that of six segments in a wave."""

    coupling = 3.0
    lag = 2 * math.pi / 6
    amplitude = 0.2
    # Of time; the phases between are taken linearly.
    small = 0.005

    def __init__(self, n):
        self.phases = [[0.0] * n]

    def rates(self, phases):
        rates = []
        for i, phase in enumerate(phases):
            rate = 2 * math.pi
            if i > 0:
                rate += self.coupling * math.sin(phases[i - 1] - phase - self.lag)
            if i + 1 < len(phases):
                rate += self.coupling * math.sin(phases[i + 1] - phase + self.lag)
            rates.append(rate)
        return rates

    def at(self, t):
        """The phases at any time: the oscillators do not feel the body."""
        i = int(t / self.small)
        while len(self.phases) < i + 2:
            # The midpoint rule.
            now = self.phases[-1]
            half = [p + 0.5 * self.small * r
                    for p, r in zip(now, self.rates(now))]
            self.phases.append([p + self.small * r
                                for p, r in zip(now, self.rates(half))])
        part = t / self.small - i
        return [(1 - part) * a + part * b
                for a, b in zip(self.phases[i], self.phases[i + 1])]

    def step(self, t, dt, segments):
        """The longitudinal muscle is the one that is at rest where the circular
        one contracts; both come in during half a period."""
        grown = min((t + dt) / 0.5, 1.0)
        active = [(1 - math.cos(phase)) / 2 for phase in self.at(t + dt)]
        circular = [1 - grown * self.amplitude * a for a in active]
        longitudinal = [1 - grown * self.amplitude * (1 - a) for a in active]
        return {"circular": circular, "septal": circular,
                "longitudinal": longitudinal}


if __name__ == "__main__":
    Oscillators(6).serve(sys.argv[1])
