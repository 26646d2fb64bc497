# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chambers without cells, one pressure each: against the rubber fluid on the same
wall, which is the same discrete problem once it is hydrostatic; and what must hold
of any run."""
import csv
import pathlib

import pytest
from lumbricus_run import SOURCE, go_on, run_well

HERE = pathlib.Path(__file__).parent
CHAIN = HERE / "chain.prm"
CAVITY = ["Geometry/segment chain/Liquid=cavity"]
PARTS = ("length", "mid_radius", "fluid_volume", "wall_volume",
         "fluid_pressure")


def equal(run, reference, tolerance, parts=PARTS):
    largest = {name: max(abs(row[name]) for row in reference.segments())
               for name in parts}
    assert len(run.segments()) == len(reference.segments())
    for row, expected in zip(run.segments(), reference.segments()):
        for name in parts:
            assert row[name] == pytest.approx(
                expected[name], abs=tolerance * largest[name]), (name, row)


def volumes_are_kept(run):
    rows = run.segments()
    for segment in {row["segment"] for row in rows}:
        own = [row["fluid_volume"] for row in rows
               if row["segment"] == segment]
        assert own == pytest.approx([own[0]] * len(own), rel=1e-12)


@pytest.fixture(scope="module")
def cavities(tmp_path_factory):
    return run_well(CHAIN, tmp_path_factory.mktemp("cavities"), CAVITY)


def test_the_rubber_fluid_comes_to_the_same(tmp_path, cavities):
    """What is left of the rubber's shear is the difference: it falls with the
    tolerance of resets after solves, and there is none where the liquid flows."""
    flowing = run_well(CHAIN, tmp_path / "flowing")
    equal(cavities, flowing, 1e-8)
    differences = []
    for tolerance in (1e-3, 1e-5):
        rubber = run_well(CHAIN, tmp_path / str(tolerance),
                          ["Reset/Every=solve",
                           f"Reset/Tolerance={tolerance}"])
        differences.append(max(
            abs(row["fluid_pressure"] - expected["fluid_pressure"])
            for row, expected in zip(rubber.segments(), cavities.segments())))
    equal(cavities, rubber, 2e-5)
    assert differences[1] < 0.1 * differences[0]
    # No resets and no liquid to relax: a third of the iterations or fewer.
    iterations = [sum(row["newton_iterations"] for row in run.steps())
                  for run in (cavities, rubber)]
    assert 3 * iterations[0] <= iterations[1]


def test_volumes_and_balance(cavities):
    volumes_are_kept(cavities)
    assert all(row["eta"] == 0 and row["resets"] == 0
               for row in cavities.segments())
    with open(cavities.folder / "reactions.csv") as file:
        rows = list(csv.DictReader(file))
    # On a quarter the other three push at the planes of symmetry.
    of_cavities = [row for row in rows if row["name"] == "cavities"][-1]
    scale = abs(float(of_cavities["force_y"]))
    assert scale > 1e-4
    for row in rows:
        if row["name"] == "sum":
            for part in "xyz":
                assert abs(float(row[f"force_{part}"])) < 1e-9 * scale
                assert abs(float(row[f"moment_{part}"])) < 1e-8 * scale


def test_ranks_sections_and_solvers(tmp_path, cavities):
    for ranks in (2, 4):
        equal(run_well(CHAIN, tmp_path / str(ranks), CAVITY, ranks),
              cavities, 1e-9)
    equal(run_well(CHAIN, tmp_path / "direct", [
        *CAVITY, "Linear solver/Method=direct"]), cavities, 1e-9)
    full = run_well(CHAIN, tmp_path / "full", [
        *CAVITY, "Geometry/segment chain/Cross-section=full"], 2)
    equal(full, cavities, 1e-8)


def test_restart_on_other_ranks(tmp_path, cavities):
    run_well(CHAIN, tmp_path, [*CAVITY, "Time/End=0.2", "Checkpoints/Steps=1"])
    on = go_on(tmp_path, ["Time/End=0.3"], 2)
    equal(on, cavities, 1e-9)


@pytest.mark.parametrize("ranks", [1, 2])
def test_hanging_nodes_and_a_new_mesh(tmp_path, ranks):
    adaptive = run_well(CHAIN, tmp_path, [
        *CAVITY, "Adaptivity/Every=1", "Adaptivity/Marking=fraction of cells",
        "Adaptivity/fraction of cells/Refine=0.1",
        "Linear solver/Method=multigrid"], ranks)
    cells = [row["cells"] for row in adaptive.table("mesh.csv")]
    assert cells[-1] > cells[0]
    # On each mesh, to rounding; its own volume at rest is a little another.
    rows = adaptive.segments()
    for row in rows:
        assert row["fluid_volume"] == pytest.approx(
            rows[int(row["segment"]) - 1]["fluid_volume"], rel=1e-3)
    assert adaptive.last()["t"] == pytest.approx(0.3)


def test_main_job(tmp_path):
    """Ten chambers, the first two steps of both files."""
    runs = [run_well(SOURCE / "parameters" / "peristalsis" / f"{name}.prm",
                     tmp_path / name, ["Time/End=0.1", "Output/Every=0"], 2)
            for name in ("cavities", "case")]
    equal(runs[0], runs[1], 5e-5, PARTS[:-1])
    equal(runs[0], runs[1], 5e-3)
    volumes_are_kept(runs[0])
    # 5 a step, where the rubber fluid takes 12 to 16.
    assert all(row["newton_iterations"] <= 6 for row in runs[0].steps())
    cells = [run.table("mesh.csv")[0]["cells"] for run in runs]
    assert cells == [420, 780]


def test_gas_gives_way(tmp_path, cavities):
    """The softer the gas, the less pressure; one under a high pressure is as
    stiff as a liquid."""
    gas = [*CAVITY, "Cavities/Content=gas"]
    high = "Cavities/gas/Absolute pressure {}=1e5"
    stiff = run_well(CHAIN, tmp_path / "stiff", [
        *gas, high.format("at rest"), high.format("outside")])
    equal(stiff, cavities, 1e-5)
    air = run_well(CHAIN, tmp_path / "air", gas)
    # p V is what it was, in all chambers: isothermal.
    at_rest = {row["segment"]: row["fluid_volume"]
               for row in air.segments() if row["t"] == 0}
    changes = []
    for row in air.segments():
        part = row["fluid_volume"] / at_rest[row["segment"]]
        changes.append(abs(part - 1))
        assert (row["fluid_pressure"] + 0.101325) * part == pytest.approx(
            0.101325, rel=1e-9)
    assert max(changes) > 1e-3


def test_the_stability_is_that_with_the_pressures(tmp_path):
    """A body with incompressible chambers is stiffer than one without: the
    softest motion keeps all volumes. The liquid that is meshed says the same, the
    softer it is."""
    watch = ["Stability/Watch=true", "Time/End=0.1"]
    cavity = run_well(CHAIN, tmp_path / "cavity", [*CAVITY, *watch])
    rubber = run_well(CHAIN, tmp_path / "rubber",
                      [*watch, "Tissues/liquid/Neo-Hooke/a=2.3e-6"])
    stiffness = [run.steps()[-1]["softest_stiffness"]
                 for run in (cavity, rubber)]
    assert stiffness[0] > 0
    assert stiffness[0] == pytest.approx(stiffness[1], rel=0.02)
