# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worm of parameters/whole_worm.

--segments: what it costs and what comes out, by the number of segments.
--sensitivity: the stride of a small worm, by setae, friction, the stiffness of
  muscle, the length of the wave, the elastic slip and the size of steps.
--mesh: the small worm on a finer mesh."""
import argparse
import pathlib

from lumbricus_run import SOURCE, run

CASE = SOURCE / "parameters" / "whole_worm" / "case.prm"
TABLE = CASE.parent / "shape.csv"
GROUND = "Boundary conditions/ground/contact/"
NUMBER = "Geometry/segment chain/Number of segments"
MUSCLES = ("circular", "longitudinal", "circular hold", "septal circular",
           "septal radial")
STIFFNESSES = {"longitudinal muscle": 0.0035, "circular muscle": 0.007,
               "septum": 0.007, "cap": 0.007}
SMALL = 15
SEGMENTS = (10, 15, 30, 75, 150)
PERIOD = 4.5
TIMEOUT = 7200


def compute(name, settings, ranks):
    # The case names its table from the top folder.
    return run(CASE, pathlib.Path.cwd() / name, [
        f"Geometry/segment chain/Table of measures={TABLE}",
        *settings, "Output/Every=0"], ranks=ranks, timeout=TIMEOUT)


def stride(result):
    """In the last period, or when the run stopped."""
    rows = result.table("body.csv")
    if result.exit_code != 0:
        return f"stops at t = {rows[-1]['t']:.2f}"
    begin = rows[-1]["t"] - PERIOD
    after = next(k for k, row in enumerate(rows) if row["t"] > begin - 1e-9)
    a, b = rows[after - 1], rows[after]
    part = (begin - a["t"]) / (b["t"] - a["t"])
    value = rows[-1]["stride"] - (1 - part) * a["stride"] - part * b["stride"]
    return f"{value:.2f}"


def highest_pressure(result):
    """In the middle segment, in kPa."""
    rows = result.segments()
    middle = max(row["segment"] for row in rows) // 2
    return 1e3 * max(row["fluid_pressure"] for row in rows
                     if row["segment"] == middle)


def per_solve(result):
    steps = result.steps()
    return sum(row["newton_iterations"] for row in steps) / \
        sum(row["solves"] for row in steps)


def cuts(result):
    return sum(row["cuts"] for row in result.steps())


def header(*names):
    print("\n| " + " | ".join(names) + " |\n" + "|---" * len(names) + "|",
          flush=True)


def by_segments(numbers, ranks):
    header("segments", "unknowns", "steps", "cuts", "Newton iterations a solve",
           "linear iterations", "factorisations", "seconds in all",
           "a segment and step [s]", "memory of the largest rank [MB]",
           "stride [mm]", "highest pressure [kPa]")
    for n in numbers:
        result = compute(f"segments-{n}-on-{ranks}", [f"{NUMBER}={n}"], ranks)
        run = result.costs()
        print(f"| {n} | {run['unknowns']} | {run['steps']} | "
              f"{cuts(result):.0f} | {per_solve(result):.1f} | "
              f"{run['linear_iterations']} | {run['factorisations']} | "
              f"{run['seconds']:.0f} | "
              f"{run['seconds'] / n / run['steps']:.4f} | {run['megabytes']} | "
              f"{stride(result)} | {highest_pressure(result):.2f} |",
              flush=True)


def softer(factor):
    return [f"Tissues/{tissue}/Neo-Hooke/a={factor * a}"
            for tissue, a in STIFFNESSES.items()]


def wave_of(length):
    """Waves, and the setae with them; the length in parts of the body."""
    return [*(f"Muscles/{muscle}/wave/Wavelength={length}*n"
              for muscle in MUSCLES), setae(5, length)]


def setae(factor, length=1):
    return (f"{GROUND}Setae=1 + {factor}*max(0, sin(2*pi*(t/{PERIOD} + 0.5 - "
            f"(s - 1)/({length}*n))))")


def steps_of(size):
    return [f"Time/Largest step={size}"]


VARIATIONS = (
    ("as it is", []),
    ("no setae", [setae(0)]),
    ("setae that double the friction", [setae(1)]),
    ("setae that make it 11 times", [setae(10)]),
    ("friction 0.15", [GROUND + "Friction=0.15, 0.15, 0.15"]),
    ("friction 0.4", [GROUND + "Friction=0.4, 0.4, 0.4"]),
    ("friction 0.6", [GROUND + "Friction=0.6, 0.6, 0.6"]),
    ("all stiffnesses halved", softer(0.5)),
    ("all stiffnesses doubled", softer(2)),
    ("wave of half the body", wave_of(0.5)),
    ("wave of three quarters of the body", wave_of(0.75)),
    ("wave of one and a half bodies", wave_of(1.5)),
    ("twice the elastic slip", [GROUND + "Elastic slip=0.155"]),
    ("steps half as long", steps_of(PERIOD / 80)),
)


def sensitivity(ranks):
    header(f"{SMALL} segments", "stride [mm]", "highest pressure [kPa]",
           "Newton iterations a solve", "cuts")
    for name, settings in VARIATIONS:
        result = compute(name.replace(" ", "-"),
                         [f"{NUMBER}={SMALL}", *settings], ranks)
        print(f"| {name} | {stride(result)} | "
              f"{highest_pressure(result):.2f} | {per_solve(result):.1f} | "
              f"{cuts(result):.0f} |", flush=True)


def finer(ranks):
    header(f"{SMALL} segments", "unknowns", "stride [mm]",
           "highest pressure [kPa]")
    for name, settings in (
            ("as it is", []),
            ("two cells along a segment", [
                "Geometry/segment chain/Cells along a segment=2"]),
            ("four cells around a quarter", [
                "Geometry/segment chain/Cells around a quarter=4"]),
            ("all cells in eight", ["Mesh/Global refinements=1"])):
        result = compute("mesh-" + name.replace(" ", "-"),
                         [f"{NUMBER}={SMALL}", *settings], ranks)
        print(f"| {name} | {result.costs()['unknowns']} | "
              f"{stride(result)} | {highest_pressure(result):.2f} |",
              flush=True)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--segments", type=int, nargs="*",
                        help="these numbers of segments, or some")
    parser.add_argument("--sensitivity", action="store_true")
    parser.add_argument("--mesh", action="store_true")
    options = parser.parse_args()
    everything = options.segments is None and not options.sensitivity and \
        not options.mesh
    if everything or options.segments is not None:
        by_segments(options.segments or SEGMENTS, options.ranks)
    if everything or options.sensitivity:
        sensitivity(options.ranks)
    if everything or options.mesh:
        finer(options.ranks)


if __name__ == "__main__":
    main()
