# SPDX-License-Identifier: LGPL-2.1-or-later
"""The main job against an independent program, over meshes: which cells do lengths,
radii and pressures of its ten segments need?

The numbers of axisymmetric.csv beside this script are those of another program; its
first lines say which. Differences are the largest over all segments and times that both
have, relative to the largest value of all; "each pressure" is relative to the pressure
itself, where that is more than a tenth of the largest.

  benchmarks/run.sh independent [--end TIME] [--set Name=value ...] [TABLE ...]

with tables among

  one         parameters/peristalsis/cavities.prm with one number of cells changed
  together    several of them
  limit       the mesh of that file, each cell cut into eight
  main_job    the whole of cavities.prm and of case.prm, the rubber fluid, on the mesh
              that they have and on the one that they had before

The first three end at t = 0.6 unless told otherwise: differences are largest at 0.45 to
0.6, where segments 3 to 5 are thinnest.
"""
import argparse
import csv
import pathlib

from lumbricus_run import SOURCE, run_well

HERE = pathlib.Path(__file__).resolve().parent
PERISTALSIS = SOURCE / "parameters" / "peristalsis"
CHAIN = "Geometry/segment chain/"
CELLS = {"around a quarter": "Cells around a quarter",
         "along a segment": "Cells along a segment",
         "across the disk": "Cells across the liquid",
         "each layer": "Cells across each wall layer",
         "cap": "Cells through a cap",
         "half a septum": "Cells through half a septum"}
VALUES = ("length", "mid_radius", "fluid_pressure")
# Pressures less than this part of the largest have no difference of their own.
PART_OF_LARGEST = 0.1
N_RANKS = 2
TIMEOUT = 7200

BEFORE = (4, 2, 1, 1, 1, 1)
NOW = (2, 4, 4, 1, 1, 1)
ONE = (BEFORE, (2, 2, 1, 1, 1, 1), (6, 2, 1, 1, 1, 1), (4, 4, 1, 1, 1, 1),
       (4, 2, 2, 1, 1, 1), (4, 2, 1, 2, 1, 1), (4, 2, 1, 1, 2, 1),
       (4, 2, 1, 1, 1, 2))
TOGETHER = ((4, 4, 2, 1, 1, 1), (4, 4, 3, 1, 1, 1), (4, 6, 2, 1, 1, 1),
            (4, 4, 3, 1, 2, 1), (2, 2, 3, 1, 1, 1), (2, 4, 2, 1, 1, 1),
            (2, 4, 3, 1, 1, 1), NOW, (2, 4, 5, 1, 1, 1), (2, 6, 4, 1, 1, 1),
            (2, 4, 3, 1, 2, 1), (2, 4, 4, 1, 2, 1), (2, 4, 3, 2, 1, 1),
            (2, 4, 3, 1, 1, 2), (2, 4, 4, 2, 2, 2))


def by_place(rows):
    """Rows of a table by time and segment, as numbers."""
    return {(round(float(row["t"]), 9), int(float(row["segment"]))):
            {name: float(row[name]) for name in VALUES} for row in rows}


def reference():
    with open(HERE / "axisymmetric.csv") as file:
        return by_place(csv.DictReader(
            line for line in file if not line.startswith("#")))


def differences(rows, expected):
    """The largest of each value, relative to the largest value, and of
    pressures relative to themselves."""
    found = by_place(rows)
    common = found.keys() & expected.keys()
    assert common
    largest = {name: max(abs(row[name]) for row in expected.values())
               for name in VALUES}
    absolute = [max(abs(found[place][name] - expected[place][name])
                    for place in common) / largest[name] for name in VALUES]
    pressures = [(found[place]["fluid_pressure"],
                  expected[place]["fluid_pressure"]) for place in common]
    relative = max(abs(ours / theirs - 1) for ours, theirs in pressures
                   if theirs > PART_OF_LARGEST * largest["fluid_pressure"])
    return [*absolute, relative]


def header():
    columns = ["liquid", *CELLS, "unknowns", "length", "radius", "pressure",
               "each pressure", "seconds", "Newton", "linear iterations"]
    print("\n| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|")


def row(mesh, options, refinements=0, name="cavities", end=None):
    settings = ["Output/Every=0", f"Mesh/Global refinements={refinements}",
                *(f"{CHAIN}{entry}={n}" for entry, n in
                  zip(CELLS.values(), mesh))]
    if end is not None:
        settings.append(f"Time/End={end}")
    result = run_well(PERISTALSIS / f"{name}.prm",
                      "-".join(map(str, (name, *mesh, refinements, end))),
                      settings + options.set, N_RANKS, timeout=TIMEOUT)
    costs = result.costs()
    found = differences(result.segments(), reference())
    cells = [str(n) for n in mesh]
    if refinements:
        cells = [f"{n}, cut" for n in cells]
    print("| " + " | ".join([
        {"cavities": "cavity", "case": "meshed"}[name], *cells,
        str(costs["unknowns"]),
        *(f"{100 * value:.{digits}f} %"
          for value, digits in zip(found, (3, 3, 2, 2))),
        f"{costs['seconds']:.0f}", str(costs["newton_iterations"]),
        str(costs["linear_iterations"])]) + " |", flush=True)


def one(options):
    for mesh in ONE:
        row(mesh, options, end=options.end or 0.6)


def together(options):
    for mesh in TOGETHER:
        row(mesh, options, end=options.end or 0.6)


def limit(options):
    row(NOW, options, refinements=1, end=options.end or 0.6)


def main_job(options):
    for name in ("cavities", "case"):
        for mesh in (BEFORE, NOW):
            row(mesh, options, name=name, end=options.end)


TABLES = {table.__name__: table for table in (one, together, limit, main_job)}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--end", type=float, metavar="TIME")
    parser.add_argument("--set", action="append", default=[],
                        metavar="Name=value")
    parser.add_argument("tables", nargs="*", metavar="TABLE",
                        help=", ".join(TABLES))
    options = parser.parse_args()
    for name in options.tables or TABLES:
        print(f"\n{name}")
        header()
        TABLES[name](options)


if __name__ == "__main__":
    main()
