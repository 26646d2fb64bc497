# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's experiments: run them, and set the numbers of the paper, the
closed forms and the program side by side, in rows.

report.py prints the rows of all experiments. The tests run the same rows on
coarse meshes.
"""
import os
import pathlib
import subprocess
import sys
from typing import NamedTuple

import closed_forms

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python" / "src"))

from lumbricus.plot.tables import read_table  # noqa: E402

WALL_A = 0.23                 # N/mm^2
RADIUS, THICKNESS = 10, 0.1   # mm
PRESSURE = closed_forms.LOAD * WALL_A * THICKNESS / RADIUS
FINE = ["Mesh/Global refinements=1"]
LIQUID = "Tissues/liquid/Neo-Hooke/"


class Row(NamedTuple):
    """A number of the paper. None is what it does not say. The tolerance is on
    the difference of ours and the closed form."""
    what: str
    paper: float
    closed_form: float
    ours: float
    tolerance: float

    def agrees(self):
        return abs(self.ours - self.closed_form) <= self.tolerance


class Runs:
    """Runs of the program, each in a folder of its own and made only once."""

    def __init__(self, folder, ranks=2, fine=False):
        self.folder = pathlib.Path(folder)
        self.ranks = ranks
        self.fine = fine

    def call(self, case, name, settings=()):
        """Run CASE.prm. @return its folder and whether it went through."""
        folder = self.folder / name
        command = [os.environ.get("MPIRUN", "mpirun"), "-np", str(self.ranks),
                   os.environ["LUMBRICUS"], str(HERE / f"{case}.prm"),
                   "--output", str(folder)]
        for setting in settings:
            command += ["--set", setting]
        done = (folder / "done").exists()
        if not done:
            process = subprocess.run(command, capture_output=True, text=True)
            if process.returncode not in (0, 2):
                raise RuntimeError(process.stdout + process.stderr)
            if process.returncode == 0:
                (folder / "done").touch()
                done = True
        return folder, done

    def __call__(self, case, name, settings=()):
        """The folder of a run that has to go through."""
        folder, done = self.call(case, name, settings)
        if not done:
            raise RuntimeError(f"{case} does not go through: see {folder}")
        return folder

    def points(self, *arguments):
        return read_table(self(*arguments) / "points.csv")


def largest_relative(ours, exact):
    return max(abs(o / e - 1) for o, e in zip(ours, exact))


# --- Diagram 1: tension of a bar ---------------------------------------------

LAWS = {"Neo-Hooke": ([], WALL_A, 0.),
        "Mooney-Rivlin": (["Tissues/latex/Law=Mooney-Rivlin",
                           "Tissues/latex/Mooney-Rivlin/a=0.17",
                           "Tissues/latex/Mooney-Rivlin/b=0.06"], 0.17, 0.06)}


def tension(runs, law):
    """Stretch and true stress of the bar."""
    settings, _, _ = LAWS[law]
    case = "diagram1/case" if law == "Neo-Hooke" else "diagram1/mooney_rivlin"
    points = runs.points(case, f"diagram1-{law}")
    return 1 + points["ux"], points["sxx"]


def diagram1(runs):
    for law, (_, a, b) in LAWS.items():
        stretch, stress = tension(runs, law)
        exact = [closed_forms.uniaxial_mooney_rivlin(l, a, b)[0]
                 for l in stretch]
        yield Row(f"Diagram 1, {law}: stress at stretch 2 [N/mm²]", None,
                  closed_forms.uniaxial_mooney_rivlin(2., a, b)[0],
                  stress[abs(stretch - 2) < 1e-9][0], 1e-8)
        yield Row(f"Diagram 1, {law}: largest relative difference", None, 0.,
                  largest_relative(stress[1:], exact[1:]), 1e-8)


# --- Figure 2: the stretched cube --------------------------------------------

def cube(runs, law):
    """Elongation, edge across and volume of the cube."""
    points = runs.points(f"figure2/{law}", f"figure2-{law}")
    edge = 1 + points["uy"]
    return points["ux"], edge, (1 + points["ux"]) * edge**2


def figure2(runs):
    for law, name, exact in (
            ("hooke", "Hooke", lambda u: closed_forms.hooke_cube(u, 0.3)),
            ("case", "Neo-Hooke", closed_forms.neo_hooke_cube)):
        u, edge, volume = cube(runs, law)
        for at in (1., 4.):
            k = abs(u - at).argmin()
            yield Row(f"Figure 2, {name}: edge across at u = {at:g} [mm]",
                      None, exact(at)[0], edge[k], 1e-9)
        yield Row(f"Figure 2, {name}: volume at u = 4 [mm³]",
                  None, exact(4.)[1], volume[-1], 1e-8)


# --- Figure 3: the filled cylinder -------------------------------------------

def radial_displacements(points):
    """dR/R of the inside and of the middle of the membrane."""
    return (points["uy"][-2] / RADIUS,
            points["uy"][-1] / (RADIUS + THICKNESS / 2))


def figure3(runs):
    cylinder = {
        wall: closed_forms.filled_cylinder(wall=wall)[-1].dR
        for wall in ("thin", "thick")}
    whole = closed_forms.thick_tube(closed_forms.LOAD, 0.01, "whole")
    slip = closed_forms.thick_tube(closed_forms.LOAD, 0.01, "slip")
    cases = (
        ("tied", "tied", 0.142,
         closed_forms.thin_tube_tied(closed_forms.LOAD) - 1, whole[0] - 1),
        ("slip", "slip, no volume lost", None,
         closed_forms.thin_tube_slip(closed_forms.LOAD) - 1, slip[0] - 1),
        ("case", "as in the paper, nu = 0.499, 20 full resets", 0.115,
         cylinder["thin"], cylinder["thick"]))
    for mesh, settings in (("coarse", []), ("refined", FINE)):
        if mesh == "refined" and not runs.fine:
            continue
        for case, what, paper, thin, thick in cases:
            inside, middle = radial_displacements(runs.points(
                f"figure3/{case}", f"figure3-{case}-{mesh}", settings))
            yield Row(f"Figure 3, {what}, {mesh}: dR/R, middle of the "
                      "membrane, thin", paper, thin, middle, 1e-3)
            yield Row(f"Figure 3, {what}, {mesh}: dR/R, inside, thick",
                      None, thick, inside, 2e-4)


# --- Diagrams 2 and 3: pressure and volume over the resets -------------------

def reset_history(runs, mode, nu):
    """p/P and dV/V of the filling after each solve."""
    folder = runs("figure3/case", f"diagrams-{mode}-{nu}",
                  [f"Reset/Mode={mode}", f"{LIQUID}nu={nu}"])
    table = read_table(folder / "resets.csv")
    volume = read_table(folder / "segments.csv")["fluid_volume"][0]
    return table["fluid_pressure"] / PRESSURE, table["fluid_volume"] / volume - 1


def diagrams2_and_3(runs):
    exact = closed_forms.diagram2_and_3(wall="thick")
    for (mode, nu), solves in exact.items():
        pressure, volume = reset_history(runs, mode, nu)
        yield Row(f"Diagram 2, {mode}, nu = {nu}: largest relative difference",
                  None, 0., largest_relative(pressure, [s.pressure for s in solves]),
                  0.01)
        yield Row(f"Diagram 3, {mode}, nu = {nu}: dV/V after 20 resets",
                  None, solves[-1].dV, volume[-1],
                  0.01 * abs(solves[-1].dV) + 1e-9)


# --- The slip interface under many resets ------------------------------------

COUPLINGS = ("reference slip", "slip", "tied")


def hundred_resets(runs, coupling):
    return runs("figure3/slip", f"hundred-{coupling.replace(' ', '-')}",
                [f"Interface/Coupling={coupling}", "Reset/Least=100",
                 "Reset/Tolerance=1"])


def slip_interface(runs):
    table = read_table(hundred_resets(runs, "slip") / "resets.csv")
    yield Row("Slip: largest divergence in resets 60 to 100", None, 0.,
              table["eta"][60:].max(), 1e-9)


# --- Without resets ----------------------------------------------------------

RATIOS = (5e-2, 1e-2, 1e-3, 1e-4, 1e-5)


def divergence(runs, ratio, limit=0):
    """Elongation and divergence of the segment, or None if it does not go
    through."""
    folder, done = runs.call("small_deformations/case",
                             f"ratio-{ratio:g}-{limit}",
                             [f"{LIQUID}a={WALL_A * ratio}",
                              f"Reset/Limit={limit}"])
    table = read_table(folder / "segments.csv")
    return (table["length"] / table["length"][0] - 1, table["eta"]) \
        if done else None


def smallest_ratio(runs, limit):
    """The smallest power of ten whose run goes through."""
    smallest = None
    for exponent in range(2, 13):
        if divergence(runs, 10.**-exponent, limit) is None:
            return smallest
        smallest = 10.**-exponent
    return smallest


def small_deformations(runs):
    """Ours, to be compared with the paper's 1 %."""
    for limit, how in ((0, "without"), (40, "with")):
        smallest = smallest_ratio(runs, limit) if runs.fine else \
            (1e-5 if divergence(runs, 1e-5, limit) else 1.)
        yield Row(f"Smallest stiffness ratio {how} resets", 0.01, 1e-5,
                  smallest, 1e-5)


EXPERIMENTS = (diagram1, figure2, figure3, diagrams2_and_3,
               slip_interface, small_deformations)
