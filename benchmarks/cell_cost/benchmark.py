# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cell costs to assemble, by kind: the numbers of include/lumbricus/
adaptivity/cell_cost.h. Bars of one kind of cell, then a closed segment whose liquid
is tied to the wall, and the same with slip: the difference is that of the cells at
the interface."""
import re

from lumbricus_run import SOURCE, run_well

BAR = SOURCE / "tests" / "physics" / "bar.prm"
SEGMENT = SOURCE / "tests" / "physics" / "segment.prm"
# Of the segment's 20 cells refined twice: 160 faces between liquid and wall or caps,
# each of a cell of its own there, and of 144 cells of the liquid, of which 16 have two.
N_INTERFACE_CELLS = 160 + 144
STRETCHED = ["Geometry/block/Cells=8, 8, 8", "Time/First step=0.5",
             "Time/Largest step=0.5", "Time/End=0.5",
             "Boundary conditions/Names=pull",
             "Boundary conditions/pull/Boundary=x max",
             "Boundary conditions/pull/Type=displacement",
             "Boundary conditions/pull/displacement/Components=x",
             "Boundary conditions/pull/displacement/Displacement=0.2*t; 0; 0"]
BARS = {"wall": [],
        "wall with a muscle": [
            "Tissues/bar/Muscles=m", "Muscles/m/Fibres=longitudinal",
            "Muscles/m/Active stretch=expression",
            "Muscles/m/expression/Formula=1-0.1*t"],
        "liquid": ["Geometry/block/Liquid=true", "Reset/Limit=0"]}


def assembly(name, case, settings):
    """Milliseconds per cell and assembly."""
    log = run_well(case, name, ["Output/Every=0"] + settings).log
    cells = int(re.search(r"(\d+) cells", log).group(1))
    seconds, calls = re.search(r"  assembly +([\d.]+) +\d+% +(\d+)",
                               log).groups()
    return 1000 * float(seconds) / int(calls) / cells, cells


def main():
    costs = {name: assembly(name, BAR, STRETCHED + settings)[0]
             for name, settings in BARS.items()}
    refined = ["Mesh/Global refinements=2", "Time/End=0.2"]
    tied, cells = assembly("tied", SEGMENT, refined)
    slip, _ = assembly("slip", SEGMENT, refined + ["Interface/Coupling=slip"])
    costs["segment, tied, mean of all cells"] = tied
    costs["segment, cells at the interface under slip"] = \
        tied + (slip - tied) * cells / N_INTERFACE_CELLS
    print("| cell | assembly (ms) | relative to the mean, tied |\n|---|---|---|")
    for name, cost in costs.items():
        print(f"| {name} | {cost:.3f} | {100 * cost / tied:.0f} % |")


if __name__ == "__main__":
    main()
