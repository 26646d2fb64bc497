# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fine a mesh must be: pressure, length and radius over the number of cells,
of the closed segment of tests/physics/segment.prm and of the middle segment of a
short chain of the gallery's peristalsis."""
import re
import sys

from lumbricus_run import SOURCE, run_well

CHAIN = "Geometry/segment chain/"
CELLS = ("Cells around a quarter", "Cells along a segment",
         "Cells across the liquid", "Cells across each wall layer",
         "Cells through a cap", "Cells through half a septum")

CASES = {
    "segment": (
        SOURCE / "tests" / "physics" / "segment.prm",
        ["Tissues/liquid/Neo-Hooke/a=0.00023"], 1,
        [(2, 2, 1, 1, 1, 1), (4, 2, 1, 1, 1, 1), (4, 4, 1, 1, 1, 1),
         (4, 4, 2, 1, 1, 1), (4, 4, 2, 1, 2, 1), (4, 4, 2, 2, 2, 1),
         (6, 4, 2, 1, 2, 1), (8, 6, 3, 1, 2, 1), (8, 8, 4, 2, 2, 1)]),
    # Thin and long at the head, short and thick two segments behind it.
    "chain": (
        SOURCE / "parameters" / "peristalsis" / "case.prm",
        [CHAIN + "Number of segments=3", "Time/End=0.3",
         "Output/Every=0"], 2,
        [(2, 2, 1, 1, 1, 1), (4, 2, 1, 1, 1, 1), (4, 4, 1, 1, 1, 1),
         (4, 2, 1, 1, 2, 2), (4, 4, 2, 2, 2, 2), (8, 4, 2, 1, 2, 2)])}


def table(name):
    case, settings, segment, meshes = CASES[name]
    print(f"\n{name}\n\n| " + " | ".join(CELLS) + " | unknowns | "
          "pressure (N/mm²) | length (mm) | radius (mm) | time (s) |")
    print("|---" * (len(CELLS) + 5) + "|")
    for mesh in meshes:
        result = run_well(
            case, f"{name}-" + "-".join(map(str, mesh)),
            settings + [f"{CHAIN}{what}={n}" for what, n in zip(CELLS, mesh)],
            ranks=2)
        end, time = result.last(segment), result.steps()[-1]["elapsed_seconds"]
        unknowns = re.search(r"(\d+) unknowns", result.log).group(1)
        print("| " + " | ".join(map(str, mesh)) + f" | {unknowns} | "
              f"{end['fluid_pressure']:.4e} | {end['length']:.4f} | "
              f"{end['mid_radius']:.4f} | {time:.0f} |", flush=True)


if __name__ == "__main__":
    for case_name in sys.argv[1:] or CASES:
        table(case_name)
