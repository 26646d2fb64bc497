# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimated errors (errors.csv) beside true ones: of a thick sphere and a thick tube
with a closed form, and of a closed segment and the main job with the numbers of an
independent program; that they are the same on any number of ranks, after a restart and
on adapted meshes, and change nothing else."""
import csv
import math
import pathlib
import re

import pytest
from lumbricus_run import SOURCE, restart, run, run_well
from test_invariance import TO_THE_END
from thick_sphere import pressure as pressure_of_sphere

HERE = pathlib.Path(__file__).parent
PERISTALSIS = SOURCE / "parameters" / "peristalsis"
INDEPENDENT = SOURCE / "benchmarks" / "independent"
NAMES = ("length", "mid_radius", "fluid_pressure")


def errors(result):
    """By time and segment: of each name the value and its estimated error."""
    return {(round(row["t"], 9), int(row["segment"])):
            {name: (row[name], row[f"{name}_error"]) for name in NAMES}
            for row in result.table("errors.csv")}


def independent(name):
    """The numbers of the independent program, by time and segment."""
    with open(INDEPENDENT / name) as file:
        lines = [line for line in file if not line.startswith("#")]
    return {(round(float(row["t"]), 9), int(float(row["segment"]))):
            {name: float(row[name]) for name in NAMES}
            for row in csv.DictReader(lines)}


def effectivity(found, true, name):
    """Estimated over true error, the largest of all times and segments."""
    common = found.keys() & true.keys()
    assert common
    estimated = max(abs(found[at][name][1]) for at in common)
    return estimated / max(abs(true[at][name] - found[at][name][0])
                           for at in common)


@pytest.mark.parametrize("cells, volume", [
    (2, 1.5), (4, 1.5), (6, 1.5), (4, 8), (6, 8)])
def test_sphere(tmp_path, cells, volume):
    """Between these volumes the error changes its sign."""
    result = run_well(HERE / "sphere.prm", tmp_path, [
        f"Geometry/hollow sphere/Cells around a quarter={cells}",
        f"Geometry/hollow sphere/Cells through the wall={cells}",
        "Cavities/Content=volume", "Output/Errors=4",
        f"Cavities/volume/Relative volume=1 + {volume - 1}*t",
        "Time/First step=0.25", "Time/Largest step=0.25"])
    # A sphere has no length.
    assert re.search(r"the largest of all segments: pressure [\d.e-]+%\n", result.log)
    (value, error), = [row["fluid_pressure"] for row in errors(result).values()]
    true = pressure_of_sphere(volume, 1, 1, 1) - value
    print(cells, volume, error / value, true / value, error / true)
    assert 0.5 < error / true < 2


@pytest.mark.parametrize("cells", [2, 3, 4])
def test_tube(tmp_path, cells):
    """p = int a (l^2 - l^-2) dr/r through a thick wall whose length is given."""
    volume, a, inner, thickness = 2., 0.05, 2., 2.

    def pressure():
        n = 400
        h = thickness / n

        def f(R):
            r = math.sqrt(R**2 + (volume - 1) * inner**2)
            return a * ((r / R)**2 - (R / r)**2) * R / r**2
        return h / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) *
                           f(inner + i * h) for i in range(n + 1))

    result = run_well(HERE / "crossed_fibres.prm", tmp_path, [
        "Tissues/wall/Elastic fibres/Names=", f"Tissues/wall/Neo-Hooke/a={a}",
        f"Geometry/open cylinder/Wall layer thicknesses={thickness}",
        f"Geometry/open cylinder/Cells across each wall layer={cells}",
        f"Geometry/open cylinder/Cells around a quarter={2 * ((cells + 1) // 2)}",
        f"Cavities/volume/Relative volume=1 + {volume - 1}*t",
        "Output/Every=0", "Output/Errors=4"])
    (value, error), = [row["fluid_pressure"] for row in errors(result).values()]
    true = pressure() - value
    print(cells, error / value, true / value, error / true)
    assert 0.5 < error / true < 2


SEGMENT = "Geometry/segment chain/"


@pytest.mark.parametrize("along, across, refined", [
    (1, 2, 0), (2, 4, 0), (3, 6, 0), (2, 2, "(x < 0.5) + (x > 2.5)")])
def test_closed_segment(tmp_path, along, across, refined):
    """Also with hanging nodes, where cells are smaller towards the caps."""
    result = run_well(HERE / "segment.prm", tmp_path, [
        f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment={along}",
        f"{SEGMENT}Cells across the liquid={across}",
        f"Mesh/Refine where={refined}", "Mesh/Local refinements=1",
        "Time/First step=0.1", "Time/Largest step=0.1", "Output/Errors=2"])
    found, true = errors(result), independent("closed_segment.csv")
    for name in NAMES:
        quotient = effectivity(found, true, name)
        print(along, across, name, quotient)
        assert 0.5 < quotient < 2, name


def test_places(tmp_path):
    """Beside a finer mesh; none where friction holds the body."""
    def places(name, along, across):
        return {row["t"]: row for row in run_well(HERE / "segment.prm", tmp_path / name, [
            f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment={along}",
            f"{SEGMENT}Cells across the liquid={across}", "Output/Errors=2",
            "Time/First step=0.1", "Time/Largest step=0.1"]).table("errors.csv")}

    found, finer = places("coarse", 1, 2), places("fine", 4, 8)
    quotient = (max(abs(row["middle_x_error"]) for row in found.values()) /
                max(abs(finer[t]["middle_x"] - row["middle_x"])
                    for t, row in found.items()))
    print(quotient)
    assert 0.5 < quotient < 2

    held = run_well(SOURCE / "parameters" / "burrow" / "case.prm", tmp_path / "held", [
        f"{SEGMENT}Number of segments=1", "Time/End=0.15", "Output/Every=0",
        "Output/Errors=1"]).table("errors.csv")
    assert all(math.isnan(row["middle_x_error"]) and row["length_error"] != 0
               for row in held)


def main_job(folder, name, settings=(), ranks=1):
    return run_well(PERISTALSIS / f"{name}.prm", folder,
                    ["Output/Every=0", "Output/Errors=6", "Time/End=0.6",
                     *settings], ranks)


@pytest.mark.parametrize("name, ranks", [("cavities", 1), ("case", 2)])
def test_main_job(tmp_path, name, ranks):
    """With cells of liquid and without."""
    found = errors(main_job(tmp_path, name, ranks=ranks))
    true = independent("axisymmetric.csv")
    for value in NAMES:
        quotient = effectivity(found, true, value)
        print(name, value, quotient)
        assert 0.5 < quotient < 2, value


def worst(found, other):
    """The largest difference of estimates, relative to the value itself."""
    assert found.keys() == other.keys()
    return max(abs((row[name][1] - other[at][name][1]) / row[name][0])
               for at, row in found.items() for name in NAMES)


@pytest.mark.parametrize("name", ["cavities", "case"])
def test_ranks_and_restart(tmp_path, name):
    """The same on 1, 2 and 4 ranks and after a restart; and without estimates all
    else is the same."""
    settings = ["Time/End=0.15", "Output/Errors=3", "Checkpoints/Steps=2",
                *TO_THE_END]
    one, *others = [main_job(tmp_path / str(ranks), name, settings, ranks)
                    for ranks in (1, 2, 4)]
    for other in others:
        print(worst(errors(one), errors(other)))
        assert worst(errors(one), errors(other)) < 1e-9
    without = main_job(tmp_path / "without", name,
                       [*settings, "Output/Errors=0"])
    assert not (without.folder / "errors.csv").exists()
    assert len(without.segments()) == len(one.segments())
    for row, other in zip(one.segments(), without.segments()):
        for value in NAMES:
            assert row[value] == pytest.approx(other[value], rel=1e-9)

    half = main_job(tmp_path / "half", name, [*settings, "Time/End=0.1"], 2)
    again = restart(half.folder, ["Time/End=0.15"], 1)
    assert again.exit_code == 0, again.log + again.message
    print(worst(errors(one), errors(again)))
    assert worst(errors(one), errors(again)) < 1e-9


def test_along_a_path(tmp_path):
    """Those of the load that a step has come to, as where it is reached in time."""
    def rows(name, settings):
        return run_well(HERE / "segment.prm", tmp_path / name, [
            f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment=2",
            "Output/Errors=1", *TO_THE_END, *settings]).table("errors.csv")
    row = rows("path", ["Path/Control=arc length", "Time/End=0.5"])[1]
    t = row["t"]
    assert 0.2 < t < 0.5
    other = rows("time", [f"Time/End={t!r}", f"Time/First step={t / 2!r}",
                          f"Time/Largest step={t / 2!r}"])[-1]
    assert other["t"] == pytest.approx(t, rel=1e-14)
    for name in NAMES:
        error, again = row[f"{name}_error"], other[f"{name}_error"]
        print(name, error / row[name], again / error - 1)
        assert abs(error / row[name]) > 1e-5
        assert again == pytest.approx(error, rel=1e-5)


@pytest.mark.parametrize("asked", [
    ["Output/Errors=1"],
    ["Adaptivity/Every=1", "Adaptivity/Estimator=goal"]])
def test_refused_where_liquid_slips(tmp_path, asked):
    result = run(HERE / "segment.prm", tmp_path,
                 [*asked, "Interface/Coupling=slip"])
    assert result.exit_code == 1
    assert asked[-1].partition("=")[0] in result.said()
    assert "slips along the wall" in result.said()


def test_no_estimate_where_the_smaller_cells_have_none(tmp_path):
    """A formula without a value at their points: the run goes on and says so."""
    result = run_well(HERE / "segment.prm", tmp_path, [
        f"{SEGMENT}Liquid=cavity", f"{SEGMENT}Cells along a segment=2",
        "Time/End=0.4", "Output/Errors=1", "Muscles/circular/expression/Formula="
        "if(x > 0.42, 1 - 0.2*t, sqrt(x - 0.42) + 1)"])
    assert "no estimate of errors" in result.log
    assert all(math.isnan(error) for row in errors(result).values()
               for _, error in row.values())
    assert len(result.steps()) == 2
