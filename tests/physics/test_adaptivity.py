# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh is adapted between load steps and nothing is lost by it: volumes, the
hydrostatic state and the number of ranks do not notice."""
import pathlib

import pytest
from lumbricus_run import SOURCE, run_well
from test_invariance import TO_THE_END, equal

HERE = pathlib.Path(__file__).parent
# The main job in small, to a quarter of the wave.
PERISTALSIS = SOURCE / "tests" / "runs" / "peristalsis.prm"
TWICE = ["Adaptivity/Every=2", "Adaptivity/fraction of error/Refine=0.3"]
CELLS = "Adaptivity/fraction of cells/"


def adaptations(run):
    return [row for row in run.table("mesh.csv") if row["cycle"] > 0]


def newton_iterations(run):
    """Of each solve on an adapted mesh, to come within 1e-9 of the solution."""
    solves = [(row["step"], row["cycle"], row["solve"])
              for row in run.table("newton.csv")
              if row["cycle"] > 0 and row["increment"] > 1e-9]
    return [solves.count(solve) for solve in set(solves)]


def nothing_is_lost(run):
    rows = adaptations(run)
    for row in rows:
        assert row["converged"] == 1
        assert row["volume_change"] < 1e-8
        assert row["resets"] <= 2
    assert max(newton_iterations(run)) <= 3
    # From one end of the run to the other.
    for segment in {row["segment"] for row in run.segments()}:
        for volume in ("fluid_volume", "wall_volume"):
            values = [row[volume] for row in run.segments()
                      if row["segment"] == segment]
            assert max(values) - min(values) < 1e-8 * values[0]
    return rows


def test_two_adaptations_in_a_wave_on_one_and_two_ranks(tmp_path):
    runs = [run_well(PERISTALSIS, tmp_path / str(ranks), TWICE + TO_THE_END,
                     ranks)
            for ranks in (1, 2)]
    for run in runs:
        rows = nothing_is_lost(run)
        assert len(rows) == 2 and all(row["refined"] > 0 for row in rows)
        assert rows[-1]["cells"] > rows[0]["cells"]
    equal(runs[0].segments(), runs[1].segments(), 1e-9)
    for row, other in zip(*map(adaptations, runs)):
        assert row["unknowns"] == other["unknowns"]
        assert row["estimated_error"] == pytest.approx(
            other["estimated_error"], rel=1e-6)


def test_slip_and_hanging_nodes(tmp_path):
    # Under slip Newton's method converges linearly: what is left of eta, a small
    # difference of large stresses, has to be less than what is compared.
    settings = ["Interface/Coupling=slip", "Newton/Increment tolerance=1e-11",
                "Adaptivity/Every=1",
                "Adaptivity/Marking=fraction of cells", CELLS + "Refine=0.05",
                "Adaptivity/Finest level=1", "Time/End=0.6"]
    runs = [run_well(HERE / "segment.prm", tmp_path / str(ranks), settings,
                     ranks) for ranks in (1, 2)]
    for run in runs:
        rows = adaptations(run)
        assert len(rows) == 3 and all(row["converged"] for row in rows)
        assert max(row["volume_change"] for row in rows) < 1e-8
        assert rows[-1]["cells"] > 20
    equal(runs[0].segments(), runs[1].segments(), 1e-9)


def test_cells_are_merged_where_they_are_not_needed(tmp_path):
    run = run_well(PERISTALSIS, tmp_path, [
        "Adaptivity/Every=2",
        "Mesh/Local refinements=1", "Mesh/Refine where=x-4",
        "Adaptivity/Marking=fraction of cells", CELLS + "Refine=0",
        CELLS + "Merge=0.3", "Time/End=0.1"], ranks=2)
    rows = nothing_is_lost(run)
    before = run.table("mesh.csv")[0]["cells"]
    assert rows[0]["refined"] == 0 and rows[0]["coarsened"] > 3
    assert rows[0]["cells"] == before - 7 * rows[0]["coarsened"]
    assert rows[0]["unknowns"] < run.table("mesh.csv")[0]["unknowns"]


@pytest.mark.parametrize("target", [6000, 9000])
def test_a_number_of_unknowns(tmp_path, target):
    run = run_well(HERE / "segment.prm", tmp_path, [
        "Adaptivity/Every=1", "Adaptivity/Marking=number of unknowns",
        f"Adaptivity/number of unknowns/Target={target}",
        "Adaptivity/Finest level=2"])
    rows = adaptations(run)
    # Above it by what the balance of levels adds, then back below.
    assert 0.7 * target < rows[-1]["unknowns"] < 1.4 * target
    assert rows[-1]["estimated_error"] < 0.5 * rows[0]["estimated_error"]


def test_levels_of_tissues(tmp_path):
    run = run_well(HERE / "segment.prm", tmp_path, [
        "Adaptivity/Every=1", "Adaptivity/Cycles=2", "Adaptivity/Finest level=0",
        "Adaptivity/Levels of tissues=cap: 1 - 1", "Time/End=0.2"])
    rows = adaptations(run)
    # All ten cells of the caps, whatever their error, and no other.
    assert rows[0]["refined"] == 10 and rows[0]["cells"] == 20 + 7 * 10
    assert len(rows) == 2 and rows[1]["refined"] == 0


def test_the_mesh_stays_where_the_new_one_does_not_work(tmp_path):
    # On the cells there are the contraction is defined at all points; on finer
    # ones some lie where the root is not.
    settings = ["Muscles/circular/expression/Formula=1-0.1*t*sqrt(x-0.4)",
                "Geometry/segment chain/Cap thickness=0.3",
                "Adaptivity/Every=2", "Adaptivity/Marking=fraction of cells",
                CELLS + "Refine=1", "Time/End=0.8"]
    runs = [run_well(HERE / "segment.prm", tmp_path / str(ranks), settings,
                     ranks) for ranks in (1, 2)]
    plain = run_well(HERE / "segment.prm", tmp_path / "plain", settings + [
        "Adaptivity/Every=0"])
    for run in runs:
        assert "the mesh stays as it was" in run.log
        rows = adaptations(run)
        assert [row["converged"] for row in rows] == [0, 0]
        assert rows[-1]["cells"] == 20
        equal(run.segments(), plain.segments(), 1e-8)
