#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draw the pressure of the liquid in the middle segments of the worm over the last
period of a run: RUN_DIR/pressure.png, with the peaks that Seymour (1969)
measured, and print the peaks of the run. Needs NumPy and Matplotlib, no display.
"""

import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]
                       / "python" / "src"))

from lumbricus.plot.tables import (  # noqa: E402
    read_parameters, read_table)

KPA = 1e3  # in a N/mm^2
# The mean peaks of 12 and 7 cm of water (Seymour 1969), in kPa; 1 cm of water is
# 0.0981 kPa. Which muscle contracts in that phase, the colour.
PHASES = {"circular": (12 * 0.0981, "#c0392b"),
          "longitudinal": (7 * 0.0981, "#2471a3")}


def wave_of(parameters, muscle):
    def get(name):
        return float(parameters[f"Muscles/{muscle}/wave/{name}"])

    return {name: get(name)
            for name in ("Wavelength", "Period", "Duty", "Ramp-in")} | {
                "Phase": float(parameters.get(f"Muscles/{muscle}/wave/Phase",
                                              0))}


def pulses(wave, segment, begin, end):
    """The intervals in [begin, end] in which the muscle of a segment is
    active; the wave travels towards the tail."""
    start = wave["Period"] * ((segment - 1) / wave["Wavelength"]
                              - wave["Phase"])
    first = int(np.floor((begin - start) / wave["Period"])) - 1
    last = int(np.ceil((end - start) / wave["Period"])) + 1
    for number in range(first, last):
        a = start + number * wave["Period"]
        b = a + wave["Duty"] * wave["Period"]
        if b > begin and a < end:
            yield max(a, begin), min(b, end)


def draw(axes, segment, t, pressure, waves):
    """One segment; returns the highest pressure in each phase."""
    peaks = {}
    for muscle, (measured, colour) in PHASES.items():
        inside = np.full(len(t), False)
        for a, b in pulses(waves[muscle], segment, t[0], t[-1]):
            axes.axvspan(a, b, color=colour, alpha=0.12, linewidth=0)
            inside |= (t >= a) & (t <= b)
        peaks[muscle] = pressure[inside].max() if inside.any() else np.nan
        axes.axhline(measured, color=colour, linewidth=1, linestyle="--")
    axes.plot(t, pressure, ".-", color="black", linewidth=1.2, markersize=4)
    axes.set_title(f"segment {segment}", fontsize=9, loc="left")
    axes.grid(linewidth=0.3)
    axes.tick_params(labelsize=7)
    return peaks


def main():
    parser = argparse.ArgumentParser(
        description="Draw the pressure over the last period of a run: "
        "pressure.png in its folder.")
    parser.add_argument("folder", metavar="RUN_DIR",
                        help="the output folder of a run")
    parser.add_argument("--segments", type=int, nargs="+", default=[5, 6, 7, 8],
                        help="segments to show (default: 5 to 8)")
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.folder)
    if not (folder / "segments.csv").exists():
        print(f"pressure.py: no segments.csv in '{folder}'; give the output "
              "folder of a run.", file=sys.stderr)
        return 1

    parameters = read_parameters(folder)
    waves = {muscle: wave_of(parameters, muscle) for muscle in PHASES}
    table = read_table(folder / "segments.csv")
    times = np.unique(table["t"])
    pressure = KPA * table["fluid_pressure"].reshape(len(times), -1)
    if max(arguments.segments) > pressure.shape[1] or \
            min(arguments.segments) < 1:
        print(f"pressure.py: the run has segments 1 to {pressure.shape[1]}.",
              file=sys.stderr)
        return 1

    wave = waves["circular"]
    begin = times[-1] - wave["Period"]
    shown = times >= begin - 1e-9 * wave["Period"]
    if begin < wave["Ramp-in"] - 1e-9 * wave["Period"]:
        print("pressure.py: the run has no whole period after its ramp; what "
              "there is is drawn.", file=sys.stderr)

    n = len(arguments.segments)
    height = 0.9 + 1.35 * n
    figure, grid = plt.subplots(
        n, 1, figsize=(7.5, height), sharex=True, sharey=True, squeeze=False,
        gridspec_kw={"left": 0.09, "right": 0.98, "bottom": 0.45 / height,
                     "top": 1 - 0.55 / height, "hspace": 0.28})
    for axes, segment in zip(grid[:, 0], arguments.segments):
        peaks = draw(axes, segment, times[shown], pressure[shown, segment - 1],
                     waves)
        print(f"segment {segment}: " + ", ".join(
            f"{value:.3f} kPa in the {muscle} phase (measured "
            f"{PHASES[muscle][0]:.2f})" for muscle, value in peaks.items()))
    top = max(pressure[shown][:, [s - 1 for s in arguments.segments]].max(),
              max(measured for measured, _ in PHASES.values()))
    grid[0, 0].set(xlim=times[shown][[0, -1]], ylim=(0, 1.25 * top))
    for measured, colour in PHASES.values():
        grid[0, 0].annotate(
            "Seymour 1969", (1, measured), xycoords=("axes fraction", "data"),
            xytext=(-3, 2), textcoords="offset points", ha="right",
            fontsize=7, color=colour)
    grid[-1, 0].set_xlabel("time [s]", fontsize=8)
    figure.supylabel("pressure of the liquid [kPa]", fontsize=8, x=0.02)
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour, alpha=0.25)
               for _, colour in PHASES.values()]
    figure.legend(handles, [f"{muscle} muscle active" for muscle in PHASES],
                  loc="upper right", ncol=2, fontsize=8,
                  frameon=False)
    figure.savefig(folder / "pressure.png", dpi=150)
    print(f"Wrote pressure.png to {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
