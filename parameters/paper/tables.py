# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of closed_forms.py, for doc/paper.md.

    python3 parameters/paper/tables.py [TABLE ...]

prints the tables named, or all of them. A table counts solves from 1: solve n
comes after n - 1 resets.
"""
import sys

import numpy as np

from closed_forms import (
    A_LATEX, LOAD, POISSON_RATIOS, bulk_modulus, contraction, diagram1,
    diagram2_and_3, filled_cylinder, hooke_cube, hooke_cube_collapse,
    lasting_divergence, neo_hooke_cube, plane_sections_tied, slip_recursion,
    squared_hoop_stretch, thick_tube, thin_tube_slip, thin_tube_tied)


def cell(entry):
    """Strings and counts as they are, numbers to five places, no -0."""
    if isinstance(entry, (str, int)):
        return f"{entry:>11}"
    return f"{round(entry, 5) + 0.0:11.5f}"


def print_table(title, heads, rows):
    print(f"\n{title}\n" + "".join(map("{:>11}".format, heads)))
    for row in rows:
        print("".join(map(cell, row)))


def table_cube():
    print_table("The cube stretched by u: edge across, volume",
                ("u", "Hooke 0.3", "volume", "Hooke 0.5", "volume",
                 "Neo-Hooke", "volume"),
                [(u, *hooke_cube(u, 0.3), *hooke_cube(u, 0.5),
                  *neo_hooke_cube(u))
                 for u in (0.0, 0.25, 0.5, 1.0, 2.0, 3.0, 4.0)])
    print_table("Hooke's edge is negative beyond u", ("nu", "u"),
                [(nu, hooke_cube_collapse(nu)) for nu in (0.3, 0.499, 0.5)])


def table_diagram1():
    print_table(f"Diagram 1: Neo-Hooke, a = {A_LATEX} N/mm^2",
                ("stretch", "true", "nominal"), diagram1())


def table_tube():
    loads = [l**0.5 - l**-2.5 for l in (1.1415, 1.142, 1.1425)]
    print_table("The thin tube: dR/R0 for P R/(a T)",
                ("load", "whole wall", "slip", "plane"),
                [(load, thin_tube_tied(load) - 1, thin_tube_slip(load) - 1,
                  plane_sections_tied(load) - 1)
                 for load in (LOAD, *loads)])
    print_table(f"The thick tube, load {LOAD}: dR/R0 of the interface",
                ("T/R0", "whole wall", "slip"),
                [(str(ratio), thick_tube(LOAD, ratio, "whole")[0] - 1,
                  thick_tube(LOAD, ratio, "slip")[0] - 1)
                 for ratio in (0.001, 0.01, 0.02, 0.05, 0.1)])


def table_cylinder():
    for mode, coupling, wall in (("full", "slip", "thin"),
                                 ("full", "slip", "thick"),
                                 ("isochoric", "slip", "thin"),
                                 ("full", "tied", "thin")):
        solves = filled_cylinder(mode=mode, coupling=coupling, wall=wall)
        print_table("The filled cylinder: T/R0 = a_f/a = 0.01, nu = 0.499, "
                    f"{mode}, {coupling}, {wall}",
                    ("solve", "resets", "dR/R0", "p/P", "dV/V0", "divergence",
                     "length"),
                    [(n, *solves[n - 1])
                     for n in (1, 2, 3, 4, 5, 10, 15, 20, 21)])


def table_recursion():
    solves = filled_cylinder(nu=0.5)
    recursion = slip_recursion(LOAD, 0.01, 0.01, len(solves))
    print_table("nu = 0.5: the recursion in one variable, Newton's method",
                ("solve", "dR/R0", "p/P", "dR/R0", "p/P"),
                [(n, *recursion[n - 1], *solves[n - 1][1:3])
                 for n in (1, 2, 5, 10, 20)])


def solves_needed(solves, tolerance=1e-3):
    """The first solve whose divergence is at most the tolerance."""
    return next(solve.resets + 1 for solve in solves
                if solve.divergence <= tolerance)


def table_rate():
    l, rows = thin_tube_slip(LOAD), []
    for fluid_ratio in (0.1, 0.01, 0.001, 0.0001):
        solves = filled_cylinder(nu=0.5, fluid_ratio=fluid_ratio, n_resets=130)
        first, second = solves[:2]
        quotient = second.divergence / first.divergence
        rows.append((str(fluid_ratio), contraction(1, 0.01, fluid_ratio),
                     contraction(l, 0.01, fluid_ratio),
                     quotient * second.pressure / first.pressure, quotient,
                     solves_needed(solves)))
    print_table("Contraction per reset, nu = 0.5, T/R0 = 0.01: by the formula "
                "at rest and at\nthe solution; |dev sigma| and divergence of "
                "solve 2 over solve 1;\nsolves until the divergence is 1e-3",
                ("a_f/a", "at rest", "solution", "|dev|", "divergence",
                 "solves"), rows)


def thick_wall_rows(ratio):
    """dR/R at the inside, middle and outside of the wall after 19 resets."""
    solve = filled_cylinder(thickness_ratio=ratio, wall="thick")[19]
    R = 1 + ratio * np.array([0.0, 0.5, 1.0])
    return np.sqrt(squared_hoop_stretch(1 + solve.dR, solve.wall_length,
                                        R)) - 1


def table_walls():
    rows = []
    for ratio in (0.0025, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1):
        thin = filled_cylinder(thickness_ratio=ratio)[19]
        rows.append((str(ratio), thin.pressure, thin.dV, thin.dR,
                     *thick_wall_rows(ratio)))
    print_table("a_f/a = 0.01, nu = 0.499, full, slip, solve 20: p/P, dV/V0 "
                "and dR/R of the thin\nwall, dR/R inside, in the middle and "
                "outside of the thick one",
                ("T/R0", "p/P", "dV/V0", "thin", "inside", "middle",
                 "outside"), rows)
    print_table("The same, T/R0 = 0.01, thin wall, by Poisson's ratio of the "
                "wall", ("nu of wall", "dR/R0"),
                [(str(nu), filled_cylinder(nu_wall=nu)[19].dR)
                 for nu in POISSON_RATIOS])


def table_diagrams():
    data = diagram2_and_3()
    for title, field in (("Diagram 2: p/P of the filling", "pressure"),
                         ("Diagram 3: dV/V0 of the filling", "dV")):
        for mode in ("full", "isochoric"):
            print_table(f"{title}, {mode}, by nu",
                        ("solve", *map(str, POISSON_RATIOS)),
                        [(n, *(getattr(data[mode, nu][n - 1], field)
                               for nu in POISSON_RATIOS))
                         for n in (1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 21)])


def table_volume():
    rows = []
    for nu in POISSON_RATIOS:
        solves = filled_cylinder(nu=nu)
        last, J = solves[19], 1 + solves[19].dV
        q = 1.5 * last.pressure - 0.5
        rows.append((str(nu), LOAD * 0.01 / bulk_modulus(0.01, nu),
                     1 - J / (1 + solves[18].dV), J - 1,
                     thin_tube_slip(LOAD * J) - 1,
                     thin_tube_slip(LOAD * J * q) - 1, last.dR))
    print_table("Solve 20, full, slip: P/kappa, -dV/V of this solve, dV/V0; "
                "dR/R0 by\nl^2 - 1/l = load V/V0, the same times q/P, and "
                "computed", ("nu", "P/kappa", "last loss", "dV/V0", "with V",
                             "and q", "dR/R0"), rows)


def table_remains():
    l = thin_tube_slip(LOAD)
    print_table("The divergence that lasts in mode full: by the formula, "
                "solve 20, solve 41",
                ("nu", "formula", "solve 20", "solve 41"),
                [(str(nu), lasting_divergence(l, nu), solves[19].divergence,
                  solves[40].divergence) for nu, solves in
                 ((nu, filled_cylinder(nu=nu, n_resets=40))
                  for nu in POISSON_RATIOS)])


TABLES = {"cube": table_cube, "diagram1": table_diagram1, "tube": table_tube,
          "cylinder": table_cylinder, "recursion": table_recursion,
          "rate": table_rate, "walls": table_walls, "volume": table_volume,
          "remains": table_remains, "diagrams": table_diagrams}


if __name__ == "__main__":
    for name in sys.argv[1:] or TABLES:
        TABLES[name]()
