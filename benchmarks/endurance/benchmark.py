# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wave after wave through the ten segments of parameters/peristalsis: is the last
like the second, does the mesh keep its quality, does a step cost what it did, and
does the memory stay what it was? Once with the mesh inside the liquid relaxed, and
once with --drifting, where it goes with the liquid."""
import argparse
import re

from lumbricus_run import SOURCE, run

CASE = SOURCE / "parameters" / "peristalsis" / "case.prm"
RAMP = 0.25
VALUES = ("length", "mid_radius", "fluid_pressure", "fluid_volume",
          "wall_volume")


def compute(name, n_waves, options):
    settings = [f"Time/End={n_waves + RAMP}", "Output/Every=0",
                *(f"Geometry/segment chain/Cells {what}={n}" for what, n in
                  (("around a quarter", options.cells),
                   ("along a segment", 2), ("across the liquid", 1)))]
    if options.drifting:
        settings.append("Reset/Relax below=0")
    result = run(CASE, name, settings, ranks=options.ranks, timeout=20000)
    memory = re.search(r"Peak memory of the largest rank: (\d+) MB", result.log)
    return result, int(memory.group(1)) if memory else None


def wave_of(row):
    """1 for the first after the ramp."""
    return int((row["t"] - RAMP - 1e-9) // 1) + 1


def largest_difference(rows, others, column):
    """Relative to the largest value."""
    return max(abs(a[column] - b[column]) for a, b in zip(rows, others)) / \
        max(abs(a[column]) for a in rows)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--waves", type=int, default=50)
    parser.add_argument("--cells", type=int, default=2,
                        help="around a quarter; the case has 4")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--drifting", action="store_true")
    options = parser.parse_args()

    _, memory_of_two = compute("two", 2, options)
    result, memory = compute("all", options.waves, options)
    print(f"exit code {result.exit_code} {result.message.strip()}\n")
    segments, steps = {}, {}
    for row in result.segments():
        segments.setdefault(wave_of(row), []).append(row)
    for row in result.steps():
        steps.setdefault(wave_of(row), []).append(row)

    print("| wave | least scaled Jacobian of the liquid | of the wall | "
          "difference from wave 2: length | radius | pressure | liquid's volume "
          "| wall's volume | Newton iterations | linear iterations | resets | "
          "seconds |\n" + "|---" * 12 + "|")
    shown = [w for w in (2, 3, 5, 10, 20, 30, 40, 50, 100, 200)
             if w in segments and len(segments[w]) == len(segments[2])]
    for wave in shown:
        rows = segments[wave]
        apart = [largest_difference(segments[2], rows, column)
                 for column in VALUES]
        print(f"| {wave} | {min(r['fluid_mesh_quality'] for r in rows):.4f} | "
              f"{min(r['wall_mesh_quality'] for r in rows):.4f} | " +
              " | ".join(f"{a:.1e}" for a in apart) + " | " +
              " | ".join(f"{sum(r[c] for r in steps[wave]):.0f}" for c in
                         ("newton_iterations", "linear_iterations")) +
              f" | {sum(r['resets'] for r in rows):.0f}"
              f" | {sum(r['seconds'] for r in steps[wave]):.1f} |")
    print(f"\nPeak memory of the largest rank: {memory_of_two} MB after 2 waves, "
          f"{memory} MB after {options.waves}.")


if __name__ == "__main__":
    main()
