# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of steps in time and of resets (errors.csv) beside true ones, those of runs
with steps of an eighth and with a tolerance of 1e-4 of it; that they are the same on any
number of ranks, after a restart and on adapted meshes, and change nothing else."""
import math
import pathlib

import pytest
from lumbricus_run import SOURCE, go_on, restart, run, run_well
from test_invariance import TO_THE_END

HERE = pathlib.Path(__file__).parent
CASES = SOURCE / "parameters"
NAMES = ("length", "mid_radius", "fluid_pressure", "middle_x")
CHAIN = "Geometry/segment chain/"
COARSE = [f"{CHAIN}Cells around a quarter=2", f"{CHAIN}Cells along a segment=2"]
STEPS = ["Output/Every=0", "Output/Energy=false", "Output/Errors of steps=true"]

# The same segment with a muscle that is weaker the quicker it shortens.
HILL = ["Tissues/wall/Viscous branches/Names=", "Tissues/cap/Viscous branches/Names=",
        "Muscles/circular/Action=active stress",
        "Muscles/circular/Activation=expression",
        "Muscles/circular/expression/Formula=0.5*(1 - cos(2*pi*t))",
        "Muscles/circular/active stress/Strength=0.02",
        "Muscles/circular/active stress/Force-velocity=Hill",
        "Muscles/circular/active stress/Hill/Fastest=5"]
DRAG = [f"{CHAIN}Number of segments=2", "Boundary conditions/soil/Type=drag",
        "Boundary conditions/soil/drag/Along the surface=1e-4"]


def errors(result):
    return result.table("errors.csv")


def at(rows):
    """Rows by time and segment."""
    return {(round(row["t"], 7), int(row["segment"])): row for row in rows}


def step(size):
    return [f"Time/First step={size}", f"Time/Largest step={size}"]


def effectivity(rows, truth, name, suffix):
    """Estimated over true error, the largest of all times and segments."""
    common = [row for key, row in at(rows).items() if key in truth]
    assert common
    true = max(abs(truth[key][name] - row[name])
               for key, row in at(rows).items() if key in truth)
    return max(abs(row[f"{name}_error{suffix}"]) for row in common) / true


def same(some, others, tolerance=1e-9):
    assert len(some) == len(others) > 0
    for row, other in zip(some, others):
        for name in NAMES:
            scale = abs(row[name])
            for key in (name, f"{name}_error_of_steps"):
                assert row[key] == pytest.approx(other[key], rel=0,
                                                 abs=tolerance * scale), key


VISCOUS, PORES, BURROW = (CASES / name / "case.prm"
                          for name in ("viscous_segment", "pores", "burrow"))


@pytest.mark.parametrize("file, size, end, settings", [
    (VISCOUS, 0.025, 0.3, COARSE),
    (VISCOUS, 0.02, 0.3, [*COARSE, "Time/Result interval=0.05"]),
    (VISCOUS, 0.025, 0.3, [*COARSE, *HILL]),
    (PORES, 0.025, 0.25, COARSE),
    (BURROW, 0.15, 1.8, DRAG),
    (HERE / "segment.prm", 0.25, 0.5, ["Interface/Coupling=slip"])],
    ids=["viscosity", "steps of unequal length", "force-velocity", "pores", "drag",
         "slip"])
def test_steps(tmp_path, file, size, end, settings):
    settings = [*STEPS, f"Time/End={end}", *settings]
    result = run_well(file, tmp_path / "steps", [*settings, *step(size)])
    assert "errors of steps, the largest of all segments: length " in result.log
    truth = at(errors(run_well(file, tmp_path / "short", [
        *settings, *step(size / 8)])))
    for name in NAMES:
        quotient = effectivity(errors(result), truth, name, "_of_steps")
        print(name, quotient)
        assert 0.5 < quotient < 2, name


def test_ranks_and_restart(tmp_path):
    """Also after a restart in the middle of a long step; and without estimates all
    else is the same."""
    def pores(name, settings, ranks):
        return run_well(PORES, tmp_path / name, [
            *STEPS, *COARSE, *TO_THE_END, "Time/End=0.2", "Checkpoints/Steps=3",
            *settings], ranks)

    one, *others = [pores(str(ranks), [], ranks) for ranks in (1, 2, 4)]
    assert len(errors(one)) == 2 * 4
    for other in others:
        same(errors(one), errors(other))
    pores("half", ["Time/End=0.125"], 2)
    other = restart(tmp_path / "half", ["Time/End=0.2", "Output/Errors of steps=false"])
    assert other.exit_code == 1
    assert "Output/Errors of steps" in other.said() and "'true'" in other.said()
    same(errors(one), errors(go_on(tmp_path / "half", ["Time/End=0.2"], 1)))

    without = pores("without", ["Output/Errors of steps=false"], 1)
    assert not (without.folder / "errors.csv").exists()
    for row, other in zip(one.segments(), without.segments(), strict=True):
        for name in ("length", "mid_radius", "fluid_pressure"):
            assert row[name] == pytest.approx(other[name], rel=1e-9)


def test_adapted_meshes(tmp_path):
    """Cells of liquid too are cut and merged while the long steps go along."""
    def segment(name, settings, ranks):
        return run_well(VISCOUS, tmp_path / name, [
            *STEPS, *COARSE, *TO_THE_END, f"{CHAIN}Liquid=meshed", "Time/End=0.3",
            *settings], ranks)

    adapted = ["Adaptivity/Every=5", "Adaptivity/Marking=fraction of cells",
               "Adaptivity/fraction of cells/Refine=0.1",
               "Adaptivity/fraction of cells/Merge=0.3"]
    runs = [segment(str(ranks), adapted, ranks) for ranks in (1, 2)]
    changes = runs[0].table("mesh.csv")[1:]
    assert sum(row["refined"] for row in changes) > 0
    assert sum(row["coarsened"] for row in changes) > 0
    same(errors(runs[0]), errors(runs[1]))
    # A new mesh moves the body, which what is viscous takes for a motion of that step.
    # A memory of the long steps that is lost is tenths.
    for name in NAMES:
        largest = max(abs(row[f"{name}_error_of_steps"] / row[name])
                      for row in errors(runs[0]))
        print(name, largest)
        assert 0 < largest < 1e-3


def test_nothing_remembers(tmp_path):
    result = run_well(HERE / "segment.prm", tmp_path, STEPS)
    assert "Steps in time add no errors" in result.log
    rows = errors(result)
    assert len(rows) == len(result.segments()) - 1
    assert all(row[f"{name}_error_of_steps"] == 0 for row in rows for name in NAMES)


def test_long_steps_that_do_not_converge(tmp_path):
    """The run goes on and says so; there is no estimate from there on."""
    result = run_well(VISCOUS, tmp_path, [
        *STEPS, *COARSE, *step(0.05), "Time/End=0.05", "Newton/Most iterations=2",
        "Newton/Predictor order=0"])
    assert "no errors of steps from here on" in result.log
    rows = errors(result)
    assert all(math.isnan(rows[-1][f"{name}_error_of_steps"]) for name in NAMES)


def test_refused(tmp_path):
    result = run(HERE / "segment.prm", tmp_path, [
        *STEPS, "Path/Control=arc length", "Time/End=1"])
    assert result.exit_code == 1
    assert "Output/Errors of steps" in result.said() and "path" in result.said()


@pytest.mark.parametrize("case, tolerance", [("segment", 1e-3), ("chain", 1e-2)])
def test_resets(tmp_path, case, tolerance):
    settings = ["Reset/Every=solve", "Output/Every=0", "Output/Errors of resets=1"]
    result = run_well(HERE / f"{case}.prm", tmp_path / "run", [
        *settings, f"Reset/Tolerance={tolerance}"])
    assert "errors of resets, the largest of all segments: length " in result.log
    truth = at(errors(run_well(HERE / f"{case}.prm", tmp_path / "truth", [
        *settings, f"Reset/Tolerance={1e-4 * tolerance}", *TO_THE_END])))
    for name in NAMES:
        quotient = effectivity(errors(result), truth, name, "_of_resets")
        print(case, tolerance, name, quotient)
        assert 0.5 < quotient < 2, name


def test_liquid_that_flows_needs_no_resets(tmp_path):
    result = run_well(HERE / "segment.prm", tmp_path, ["Output/Errors of resets=2"])
    rows = errors(result)
    assert {row["t"] for row in rows} == {
        row["t"] for row in result.steps() if row["step"] % 2 == 0}
    assert all(row[f"{name}_error_of_resets"] == 0 for row in rows for name in NAMES)
