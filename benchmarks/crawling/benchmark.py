# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the worm of parameters/crawling gets in a period, by the ratio of
backward to forward friction, by the size of steps and by the elastic slip: with
six segments, one wave, coarse cells, and setae that are always out."""
import argparse

from lumbricus_run import SOURCE, run_well

CASE = SOURCE / "parameters" / "crawling" / "case.prm"
GROUND = "Boundary conditions/ground/contact/"
CHAIN = "Geometry/segment chain/"
SEGMENTS = 6
# The period that is measured begins half a period after the ramp.
START = 0.75
FORWARD = 0.3
RATIO, STEP, SLIP = 4, 0.05, 0.02


def compute(ratio, step, slip, ranks):
    """The run, and its stride from START on."""
    result = run_well(CASE, f"{ratio:g}-{step:g}-{slip:g}", [
        CHAIN + f"Number of segments={SEGMENTS}",
        CHAIN + "Cells across the liquid=1",
        *(f"Muscles/{muscle}/wave/Wavelength={SEGMENTS}"
          for muscle in ("circular", "septal", "longitudinal")),
        GROUND + f"Friction={FORWARD}, {FORWARD * ratio}, {2 * FORWARD}",
        GROUND + "Setae=1", GROUND + f"Elastic slip={slip}",
        f"Time/First step={min(step, 0.05)}", f"Time/Largest step={step}",
        "Time/Result interval=0.25", f"Time/End={START + 1}",
        "Output/Every=0"], ranks=ranks)
    stride = {round(row["t"], 9): row["stride"]
              for row in result.table("body.csv")}
    return result, stride[START + 1] - stride[START]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ranks", type=int, default=1)
    options = parser.parse_args()
    print("| backward / forward | step | elastic slip [mm] | stride [mm] | "
          "Newton iterations a solve | cuts |\n" + "|---" * 6 + "|")
    for ratio, step, slip in (
            *((ratio, STEP, SLIP) for ratio in (1, 2, 4, 10)),
            *((RATIO, step, SLIP) for step in (0.1, 0.025)),
            *((RATIO, STEP, slip) for slip in (0.04, 0.01))):
        result, stride = compute(ratio, step, slip, options.ranks)
        steps = result.steps()
        per_solve = sum(row["newton_iterations"] for row in steps) / \
            sum(row["solves"] for row in steps)
        cuts = sum(row["cuts"] for row in steps)
        print(f"| {ratio} | {step} | {slip} | {stride:.4f} | {per_solve:.1f} | "
              f"{cuts:.0f} |", flush=True)


if __name__ == "__main__":
    main()
