# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw the paper's diagrams and figures from the runs of experiments.py."""
import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

import closed_forms  # noqa: E402
import experiments  # noqa: E402
from lumbricus.plot.fields import (  # noqa: E402
    FACES, nodes_of_cells, read_grid, read_series)
from lumbricus.plot.tables import read_table  # noqa: E402

AROUND = [0, 4, 1, 5, 2, 6, 3, 7, 0]  # the nodes around a face
NUS = closed_forms.POISSON_RATIOS
COLOURS = dict(zip(NUS, ("#d95f02", "#1b9e77", "#7570b3", "#000000")))


def save(figure, runs, name):
    figure.tight_layout()
    figure.savefig(runs.folder / name, dpi=120)
    plt.close(figure)


def diagram1(runs):
    figure, axes = plt.subplots(figsize=(5, 3.6))
    for law, (_, a, b) in experiments.LAWS.items():
        stretch, stress = experiments.tension(runs, law)
        fine = np.linspace(1, stretch[-1], 200)
        line, = axes.plot(
            fine, closed_forms.uniaxial_mooney_rivlin(fine, a, b)[1],
            label=f"{law}, a = {a:g}, b = {b:g}")
        axes.plot(stretch, stress / stretch, "o", color=line.get_color(),
                  markersize=4)
    axes.set_xlabel("stretch")
    axes.set_ylabel("force per area at rest [N/mm²]")
    axes.set_title("Diagram 1: lines closed form, dots computed", fontsize=10)
    axes.legend()
    save(figure, runs, "diagram1.png")


def figure2(runs):
    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.4))
    for law, name in (("hooke", "Hooke, nu = 0.3"), ("case", "Neo-Hooke")):
        u, edge, volume = experiments.cube(runs, law)
        left.plot(u, edge, "o-", markersize=4, label=name)
        right.plot(u, volume, "o-", markersize=4, label=name)
    left.axhline(0, color="black", linewidth=0.8)
    left.set_ylabel("edge across [mm]")
    right.set_ylabel("volume [mm³]")
    for axes in (left, right):
        axes.set_xlabel("u [mm]")
        axes.legend()
    save(figure, runs, "figure2.png")


def diagrams2_and_3(runs):
    exact = closed_forms.diagram2_and_3(wall="thick")
    figure, panels = plt.subplots(2, 2, figsize=(9, 6.4), sharex=True,
                                  sharey="row")
    for column, mode in enumerate(("full", "isochoric")):
        for nu in NUS:
            computed = experiments.reset_history(runs, mode, nu)
            solves = exact[mode, nu]
            n = np.arange(1, len(solves) + 1)
            closed = ([s.pressure for s in solves], [s.dV for s in solves])
            for row in range(2):
                panels[row, column].plot(n, closed[row], "-",
                                         color=COLOURS[nu])
                panels[row, column].plot(n, computed[row], "o", markersize=4,
                                         color=COLOURS[nu], label=f"nu = {nu}")
        panels[0, column].set_title(f"mode {mode}")
        panels[1, column].set_xlabel("solve")
    panels[0, 0].set_ylabel("Diagram 2: pressure p/P")
    panels[1, 0].set_ylabel("Diagram 3: change of volume")
    panels[0, 0].legend()
    save(figure, runs, "diagrams2_and_3.png")


def meridian(folder):
    """The faces in the plane z = 0 at the end of a run, mirrored in x = 0:
    outlines at rest and deformed [face, point, x y], and which are liquid."""
    grid = read_grid(read_series(folder)[-1][1])
    faces = nodes_of_cells(grid)[:, FACES].reshape(-1, 9)
    faces = faces[np.abs(grid.points[faces][..., 2]).max(axis=1) < 1e-6]
    rest = grid.points[faces[:, AROUND], :2]
    moved = rest + grid["displacement"][faces[:, AROUND], :2]
    liquid = grid["tissue"][faces[:, 8]] == 0
    mirror = np.array([-1, 1])
    both = [np.concatenate([p, p * mirror, -p, -p * mirror])
            for p in (rest, moved)]
    return both[0], both[1], np.tile(liquid, 4)


def outline(polygons):
    """The edges that belong to one polygon only."""
    edges = {}
    for polygon in polygons:
        for k in range(0, 8, 2):
            edge = polygon[k:k + 3]
            edges.setdefault(tuple(np.round(edge[1], 6)), []).append(edge)
    return [found[0] for found in edges.values() if len(found) == 1]


def cylinder(runs, name, title, run, file_name):
    rest, moved, liquid = meridian(runs.folder / run)
    figure, axes = plt.subplots(figsize=(6, 6))
    axes.add_collection(PolyCollection(
        moved, facecolors=np.where(liquid, "#cfe3f5", "#c98a75"),
        edgecolors="#555555", linewidths=0.4))
    axes.add_collection(LineCollection(outline(rest), colors="black",
                                       linestyles="dashed", linewidths=1))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_title(f"{name}: {title}", fontsize=10)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
    save(figure, runs, file_name)


def divergence(runs):
    figure, axes = plt.subplots(figsize=(5.5, 3.8))
    for ratio in experiments.RATIOS:
        curve = experiments.divergence(runs, ratio)
        if curve is not None:
            axes.semilogy(100 * curve[0][1:], curve[1][1:], "o-", markersize=3,
                          label=f"{100 * ratio:g} %")
    axes.set_xlabel("elongation of the segment [%]")
    axes.set_ylabel("divergence from the hydrostatic state")
    axes.legend(title="stiffness of the rubber fluid", fontsize=8, ncol=2)
    save(figure, runs, "small_deformations.png")


def stability(runs):
    """100 resets with normals at rest and of the deformed liquid."""
    figure, axes = plt.subplots(figsize=(5.5, 3.8))
    for coupling in experiments.COUPLINGS:
        folder = experiments.hundred_resets(runs, coupling)
        table = read_table(folder / "resets.csv")
        axes.semilogy(table["reset"], table["eta"], label=coupling)
    axes.set_xlabel("resets")
    axes.set_ylabel("divergence from the hydrostatic state")
    axes.legend()
    save(figure, runs, "slip_stability.png")


def draw(runs):
    diagram1(runs)
    figure2(runs)
    diagrams2_and_3(runs)
    cylinder(runs, "Figure 3", "after 20 resets, at rest dashed",
             "figure3-case-coarse", "figure3.png")
    runs("figure4/case", "figure4")
    cylinder(runs, "Figure 4", "fine mesh, after 20 resets, at rest dashed",
             "figure4", "figure4.png")
    divergence(runs)
    stability(runs)
