# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in chambers without cells: liquid, gas, a pump, a pressure, each in its
own segment, and what flows between them through pores, out of the body by a leak
and into it."""
import pathlib

import pytest
from lumbricus_run import SOURCE, go_on, run_well

HERE = pathlib.Path(__file__).parent
CHAIN = HERE / "chain.prm"
CAVITY = ["Geometry/segment chain/Liquid=cavity"]
ATMOSPHERE = 0.101325


def rows_of(run, segment):
    return [row for row in run.segments() if row["segment"] == segment]


def column(run, segment, name):
    return [row[name] for row in rows_of(run, segment)]


def test_a_pump_and_the_pressure_it_needs(tmp_path):
    """Blow up the middle chamber to a volume; then prescribe the pressure that
    this took: it is the same body. The chambers beside it keep their volumes."""
    own = [*CAVITY, "Cavities/Segments with their own content=2"]
    section = "Cavities/Segment 2/"
    pump = run_well(CHAIN, tmp_path / "pump", [
        *own, section + "Content=volume",
        section + "volume/Relative volume=1 + 0.5*t"])
    for t, volume in zip(column(pump, 2, "t"), column(pump, 2, "fluid_volume")):
        assert volume == pytest.approx(
            (1 + 0.5 * t) * column(pump, 2, "fluid_volume")[0], rel=1e-11)
    for segment in (1, 3):
        volumes = column(pump, segment, "fluid_volume")
        assert volumes == pytest.approx([volumes[0]] * 4, rel=1e-11)
    P = pump.last(2)["fluid_pressure"]
    assert P > 1e-3
    valve = run_well(CHAIN, tmp_path / "valve", [
        *own, section + "Content=pressure",
        f"{section}pressure/Pressure={P:.15g}*t/0.3"], 2)
    for segment in (1, 2, 3):
        for name in ("length", "mid_radius", "fluid_volume", "fluid_pressure"):
            assert valve.last(segment)[name] == pytest.approx(
                pump.last(segment)[name], rel=1e-8), (segment, name)


def test_a_pressure_in_a_body_with_stiff_parts(tmp_path, monkeypatch):
    """A pressure was an unknown with an equation of its own, P = P(t), whose error
    counts relative to the stiffest tissue: nothing at first. What the pressure did
    to the soft parts one iteration later was far more, and taken for divergence: no
    step led on. It acts as a load does, from the first iteration on."""
    monkeypatch.chdir(SOURCE)  # paths of meshes are from there
    finger = SOURCE / "parameters" / "soft_actuator"
    short = ["Time/End=0.1", "Output/Every=0"]
    run = run_well(finger / "pump.prm", tmp_path / "cavity", [
        *short, "Cavities/Content=pressure",
        "Cavities/pressure/Pressure=0.04*t"])
    load = run_well(finger / "case.prm", tmp_path / "load", short)
    assert [row["cuts"] for row in run.steps()] == [0, 0]
    for row, expected in zip(run.table("points.csv"), load.table("points.csv")):
        for name in ("ux", "uz"):
            assert row[name] == pytest.approx(expected[name], abs=1e-9)


def test_gas_beside_liquid_under_a_falling_pressure_outside(tmp_path):
    """p V^1.4 is kept, with the absolute pressure p; liquid keeps its volume."""
    run = run_well(CHAIN, tmp_path, [
        *CAVITY, "Cavities/Segments with their own content=1, 2-3",
        "Cavities/Segment 1/Content=gas",
        "Cavities/Segment 1/gas/Exponent=1.4",
        "Cavities/Segment 1/gas/Absolute pressure outside="
        f"{ATMOSPHERE}*(1 - t)"])
    V_0 = column(run, 1, "fluid_volume")[0]
    for row in rows_of(run, 1):
        outside = ATMOSPHERE * (1 - row["t"])
        assert row["fluid_pressure"] + outside == pytest.approx(
            ATMOSPHERE * (V_0 / row["fluid_volume"])**1.4, rel=1e-9)
    assert run.last(1)["fluid_volume"] > 1.1 * V_0
    for segment in (2, 3):
        volumes = column(run, segment, "fluid_volume")
        assert volumes == pytest.approx([volumes[0]] * 4, rel=1e-11)


PORES = [*CAVITY, "Cavities/Pores=4000 + 1000*s"]


def check_flow(run, pore=lambda s: 4000 + 1000 * s, leak=0, inflow=0):
    """What a chamber of liquid gained in a step is what has flowed by the
    pressures at its end. Nothing is lost on the way."""
    chambers = [rows_of(run, s) for s in (1, 2, 3)]
    for before, after in zip(zip(*chambers), list(zip(*chambers))[1:]):
        dt = after[0]["t"] - before[0]["t"]
        P = [row["fluid_pressure"] for row in after]
        through = [0, *(pore(s) * (P[s - 1] - P[s]) for s in (1, 2)), 0]
        for k in range(3):
            gained = after[k]["fluid_volume"] - before[k]["fluid_volume"]
            expected = dt * (through[k] - through[k + 1] - leak * P[k] +
                             inflow)
            assert gained == pytest.approx(expected, abs=1e-9), (k, after[k])


@pytest.fixture(scope="module")
def pores(tmp_path_factory):
    return run_well(CHAIN, tmp_path_factory.mktemp("pores"), PORES)


def test_pores_keep_the_total(pores):
    check_flow(pores)
    totals = [sum(row["fluid_volume"] for row in pores.segments()
                  if row["t"] == t) for t in column(pores, 1, "t")]
    assert totals == pytest.approx([totals[0]] * 4, rel=1e-12)
    # That is much: septa that are closed make other pressures.
    assert abs(column(pores, 1, "fluid_volume")[-1] /
               column(pores, 1, "fluid_volume")[0] - 1) > 0.01


def test_pores_on_other_ranks_and_sections(pores, tmp_path):
    for name, settings, ranks in (
            ("two", [], 2), ("four", [], 4),
            ("full", ["Geometry/segment chain/Cross-section=full"], 2)):
        other = run_well(CHAIN, tmp_path / name, [*PORES, *settings], ranks)
        for row, expected in zip(other.segments(), pores.segments()):
            for part in ("length", "fluid_volume", "fluid_pressure"):
                assert row[part] == pytest.approx(
                    expected[part], rel=1e-8, abs=1e-10), (name, part)


def test_what_is_inside_goes_through_a_restart(pores, tmp_path):
    """Forgotten, the chambers would go on with the volumes of rest."""
    run_well(CHAIN, tmp_path, [*PORES, "Time/End=0.2", "Checkpoints/Steps=1"])
    on = go_on(tmp_path, ["Time/End=0.3"], 2)
    for s in (1, 2, 3):
        for part in ("length", "fluid_volume", "fluid_pressure"):
            assert on.last(s)[part] == pytest.approx(
                pores.last(s)[part], rel=1e-9), (s, part)


def test_wide_pores_make_one_chamber(tmp_path):
    run = run_well(CHAIN, tmp_path, [*CAVITY, "Cavities/Pores=1e9"])
    P = [run.last(s)["fluid_pressure"] for s in (1, 2, 3)]
    assert P[0] > 1e-4
    assert P == pytest.approx([P[0]] * 3, rel=1e-5)


def test_leak_inflow_and_order(tmp_path):
    """The error of backward Euler halves with the step."""
    ends = []
    for n in (3, 6, 12):
        run = run_well(CHAIN, tmp_path / str(n), [
            *CAVITY, "Cavities/Leak=30", "Cavities/Inflow=1",
            f"Time/First step={0.3 / n}", f"Time/Largest step={0.3 / n}"])
        check_flow(run, lambda s: 0, 30, 1)
        ends.append(run.last(2)["fluid_volume"])
    differences = [ends[1] - ends[0], ends[2] - ends[1]]
    assert differences[0] / differences[1] == pytest.approx(2, abs=0.3)


def test_new_meshes_keep_what_has_flowed(tmp_path, pores):
    """M is kept relative to the volume at rest, which is another one on another
    mesh of a round body."""
    adaptive = run_well(CHAIN, tmp_path, [
        *PORES, "Adaptivity/Every=1", "Adaptivity/Marking=fraction of cells",
        "Adaptivity/fraction of cells/Refine=0.1"], 2)
    for s in (1, 2, 3):
        assert adaptive.last(s)["fluid_volume"] == pytest.approx(
            pores.last(s)["fluid_volume"], rel=2e-3)
