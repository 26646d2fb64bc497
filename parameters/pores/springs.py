#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What flows through the pore, from the pressures that a pump needs.

    springs.py PUMP RUN CONDUCTANCE

PUMP and RUN are folders of runs of case.prm, see README.md. Once the muscle is
contracted, P1 - P2 is a function D of the volume v that has gone over; PUMP, which
goes through the volumes, has it in its table. Then dv/dt = g D(v), and nothing of
the body is needed any more.
"""
import bisect
import csv
import pathlib
import sys

CONTRACTED = 0.1  # when the muscle is


def table(folder):
    """Rows of (t, volume that has gone into segment 2, P1 - P2)."""
    with open(pathlib.Path(folder) / "segments.csv") as file:
        rows = [{name: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]
    first, second = ([row for row in rows if row["segment"] == s]
                     for s in (1, 2))
    return [(b["t"], b["fluid_volume"] - second[0]["fluid_volume"],
             a["fluid_pressure"] - b["fluid_pressure"])
            for a, b in zip(first, second, strict=True)
            if b["t"] > CONTRACTED - 1e-9]


class Springs:
    """D, a line from each row of the pump to the next."""

    def __init__(self, pump):
        self.volumes = [v for _, v, _ in pump]
        self.drops = [drop for *_, drop in pump]

    def line(self, i):
        """v and D at the start of line i, and its slope."""
        return (self.volumes[i], self.drops[i],
                (self.drops[i + 1] - self.drops[i]) /
                (self.volumes[i + 1] - self.volumes[i]))

    def step(self, v, dt, g):
        """Backward Euler: w = v + dt g D(w), on the line where w is."""
        for i in range(len(self.volumes) - 1):
            start, drop, slope = self.line(i)
            w = start + (v + dt * g * drop - start) / (1 - dt * g * slope)
            if w <= self.volumes[i + 1]:
                return w
        raise ValueError("The pump does not go that far.")

    def at_rest(self):
        """v where D = 0, and the slope of D there: that of a line is the slope
        in its middle, and from there to the next middle, as far as the line is
        long, it changes evenly."""
        i = bisect.bisect(self.drops, 0, key=lambda drop: -drop) - 1
        start, drop, slope = self.line(i)
        v, length = start - drop / slope, self.volumes[i + 1] - start
        beyond = (v - start) / length - 0.5
        *_, beside = self.line(i + 1 if beyond > 0 else i - 1)
        return v, slope + abs(beyond) * (beside - slope)


def main(pump, run, g):
    springs, rows = Springs(table(pump)), table(run)
    end, slope = springs.at_rest()
    print(f"V2 ends {end:.4f} mm^3 above rest; 1 / (g |dD/dv|) there: "
          f"{-1 / (g * slope):.4f} s")
    print("     t    run  same steps  1000 steps for one")
    same = fine = rows[0][1]
    for (before, *_), (t, v, _) in zip([rows[0], *rows], rows):
        dt = t - before
        same = springs.step(same, dt, g)
        for _ in range(1000):
            fine = springs.step(fine, dt / 1000, g)
        print(f"{t:6.3f} {v:6.4f}      {same:6.4f}              {fine:6.4f}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
