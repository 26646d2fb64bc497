#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Put what comes out of a run of the whole worm beside what has been measured in
animals: measured.csv, measured.md and measured.png in its folder. Needs NumPy and
Matplotlib, no display.
"""

import argparse
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot.tables import (  # noqa: E402
    read_description, read_table, values_of)

KPA = 1e3              # in a N/mm^2
GRAM = 1e6             # in a t
CM_OF_WATER = 0.0981   # kPa
SEGMENTS_OF_ANIMAL = 150
# Slower than this part of its fastest a segment is taken to stand.
STANDS = 0.1

SEYMOUR = "Seymour 1969"
QUILLIN = "Quillin 1999"
FORCES = "Quillin 2000"
STRETCH = "J. Exp. Biol. 65, 39"
CIRCULAR, LONGITUDINAL = 12 * CM_OF_WATER, 7 * CM_OF_WATER


class Crawl:
    """The last period of a run, in the segments that are a fifth of the body or
    more away from its ends."""

    def __init__(self, folder):
        description = read_description(folder)
        parameters = values_of(description)
        wave = "Muscles/circular/wave/"
        self.period = float(parameters[wave + "Period"])
        self.density = float(
            parameters["Tissues/circular muscle/Density"])
        body = read_table(folder / "body.csv")
        segments = read_table(folder / "segments.csv")
        contact = read_table(folder / "contact.csv")
        self.t = body["t"]
        n = round(segments["segment"].max())
        self.per_animal = n / SEGMENTS_OF_ANIMAL

        def by_segment(column, table=segments):
            return table[column].reshape(-1, n)

        self.volume = sum(by_segment(name)[0].sum()
                          for name in ("fluid_volume", "wall_volume"))
        length = by_segment("length")
        self.rest_length = length[0].sum()
        ends = np.cumsum(length, axis=1)
        place = body["head_x"][:, None] + ends - length / 2
        middle = slice(n // 5, n - n // 5)
        self.numbers = np.arange(1, n + 1)[middle]
        begin = self.t[-1] - self.period
        if begin < float(parameters[wave + "Ramp-in"]) - 1e-9 * self.period:
            raise ValueError("the run has no whole period after its ramp")
        self.last = self.t >= begin - 1e-9 * self.period
        self.stride = body["stride"][-1] - np.interp(begin, self.t,
                                                     body["stride"])
        self.mid_length, self.rest_mid = length[:, middle], length[0, middle]
        self.stretch = (length / length[0])[:, middle]
        self.radial = (by_segment("mid_radius")
                       / by_segment("mid_radius")[0])[:, middle]
        self.pressure = KPA * by_segment("fluid_pressure")[:, middle]
        # Forwards is towards the head, against x.
        self.speed = -np.gradient(place[:, middle], self.t, axis=0)
        # Of the whole worm, and not of the part that was computed.
        images = 2 ** len(description["body"]["symmetry_planes"])
        self.friction = images * by_segment("friction_x", contact)

    def peaks(self, values, longer):
        """The largest value while a segment is longer than at rest, or shorter,
        the mean of the segments."""
        phase = (self.stretch > 1) == longer
        shown = np.where(phase, values, -np.inf)[self.last]
        return shown.max(axis=0).mean()

    def duty_factor(self):
        """Part of the period in which a segment stands, the mean."""
        speed = self.speed[self.last]
        stands = speed < STANDS * speed.max(axis=0)
        dt = np.gradient(self.t[self.last])
        return (stands * dt[:, None]).sum(axis=0).mean() / dt.sum()

    def anchoring(self):
        """The largest force with which the ground holds the worm forwards."""
        held = np.where(self.friction < 0, -self.friction, 0).sum(axis=1)
        return held[self.last].max()


def rows_of(crawl):
    """Quantity, unit, whether it was set, the worm's, and what was measured:
    lowest and highest, or twice the same, and the source."""
    mass = GRAM * crawl.density * crawl.volume
    stretch, radial = crawl.stretch[crawl.last], crawl.radial[crawl.last]
    range_of = (stretch.max(axis=0) - stretch.min(axis=0)) * crawl.rest_mid

    def scaled(at_5_g, exponent):
        return (at_5_g * (mass / 5) ** exponent,) * 2

    nothing = (np.nan, np.nan)
    return [
        ("length at rest", "mm", "set", crawl.rest_length, (110, 200),
         "Wikipedia"),
        ("mass", "g", "set", mass, (0.012, 8.5), QUILLIN),
        ("strides", "1/s", "set", 1 / crawl.period, scaled(0.22, -0.07),
         QUILLIN),
        ("stride", "mm", "came out", crawl.stride, scaled(30, 0.41), QUILLIN),
        ("speed", "mm/s", "came out", crawl.stride / crawl.period,
         scaled(6.5, 0.33), QUILLIN),
        ("stretch of a segment of the animal", "mm", "came out",
         range_of.mean() * crawl.per_animal, (0.2, 0.7), STRETCH),
        ("longest", "% of rest", "came out",
         100 * (stretch.max(axis=0).mean() - 1), nothing, ""),
        ("shortest", "% of rest", "came out",
         100 * (stretch.min(axis=0).mean() - 1), nothing, ""),
        ("widest", "% of rest", "came out",
         100 * (radial.max(axis=0).mean() - 1), nothing, ""),
        ("thinnest", "% of rest", "came out",
         100 * (radial.min(axis=0).mean() - 1), nothing, ""),
        ("duty factor", "1", "came out", crawl.duty_factor(), nothing, ""),
        ("pressure, circular muscle", "kPa", "fitted",
         crawl.peaks(crawl.pressure, True), (CIRCULAR,) * 2, SEYMOUR),
        ("pressure, longitudinal muscle", "kPa", "came out",
         crawl.peaks(crawl.pressure, False), (LONGITUDINAL,) * 2, SEYMOUR),
        ("anchoring force, along, on the ground", "N", "came out",
         crawl.anchoring(), (0.04 * mass ** 0.45,) * 2,
         FORCES + ": radial, in a burrow"),
    ]


def text_of(measured):
    low, high = measured
    if np.isnan(low):
        return ""
    return f"{low:.3g}" if low == high else f"{low:.3g} to {high:.3g}"


def write_tables(rows, folder):
    with open(folder / "measured.csv", "w", newline="",
              encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(("quantity", "unit", "how", "worm", "measured_low",
                         "measured_high", "source"))
        for name, unit, how, value, (low, high), source in rows:
            writer.writerow((name, unit, how, value, low, high, source))
    lines = ["| | | how | the worm | measured | source |", "|---" * 6 + "|"]
    lines += [f"| {name} | {unit} | {how} | {value:.3g} | {text_of(measured)} | "
              f"{source} |" for name, unit, how, value, measured, source in rows]
    (folder / "measured.md").write_text("\n".join(lines) + "\n",
                                        encoding="utf-8")
    print("\n".join(lines))


def draw(crawl, rows, folder):
    figure, (left, top, right) = plt.subplots(
        1, 3, figsize=(13, 4.2), gridspec_kw={"width_ratios": (1.2, 1, 1)},
        layout="constrained")
    shown = [row for row in rows if not np.isnan(row[4][0])]
    for place, (_, _, how, value, (low, high), _) in enumerate(shown):
        centre = np.sqrt(low * high)
        left.plot([low / centre, high / centre], [place] * 2, color="#7f8c8d",
                  linewidth=6, alpha=0.5, solid_capstyle="butt")
        left.plot(value / centre, place, "o",
                  color="#c0392b" if how == "came out" else "#bdc3c7")
    left.axvline(1, color="black", linewidth=0.8)
    left.set(xscale="log", xlim=(0.1, 10), xlabel="the worm / measured",
             yticks=range(len(shown)), yticklabels=[row[0] for row in shown])
    left.invert_yaxis()
    left.tick_params(labelsize=7)
    left.set_title("red: came out; grey: set or fitted; bars: ranges measured",
                   fontsize=9, loc="left")

    chosen = np.linspace(0, len(crawl.numbers) - 1, 3).round().astype(int)
    t = crawl.t[crawl.last]
    for k in chosen:
        name = f"segment {crawl.numbers[k]}"
        top.plot(t, crawl.pressure[crawl.last, k], label=name)
        right.plot(t, 100 * (crawl.stretch[crawl.last, k] - 1), label=name)
    for value, text in ((CIRCULAR, "circular"), (LONGITUDINAL, "longitudinal")):
        top.axhline(value, color="black", linewidth=0.8, linestyle="--")
        top.annotate(f"{text}, {SEYMOUR}", (0.5, value), ha="center",
                     xycoords=("axes fraction", "data"), va="bottom",
                     fontsize=7, bbox={"color": "white", "pad": 1})
    top.set(xlabel="time [s]", ylabel="pressure [kPa]")
    right.set(xlabel="time [s]", ylabel="longer than at rest [%]")
    top.set_ylim(0, 1.3 * max(CIRCULAR, crawl.pressure[crawl.last].max()))
    for axes in (top, right):
        axes.grid(linewidth=0.3)
    right.legend(fontsize=7)
    figure.savefig(folder / "measured.png", dpi=150)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="RUN_DIR", type=pathlib.Path,
                        help="the output folder of a run")
    folder = parser.parse_args().folder
    try:
        crawl = Crawl(folder)
    except (OSError, KeyError, ValueError) as error:
        print(f"measured.py: '{folder}' is no run of the whole worm that is "
              f"long enough: {error}", file=sys.stderr)
        return 1
    rows = rows_of(crawl)
    write_tables(rows, folder)
    draw(crawl, rows, folder)
    print(f"Wrote measured.csv, measured.md, measured.png to {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
