# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gallery on coarser meshes or in fewer steps: the numbers of its READMEs,
closed forms, and mirror images. Cases that are not here have tests of their own."""
import math

import pytest
from lumbricus_run import SOURCE, run, run_well

CHAIN = "Geometry/segment chain/"


def case(name, folder, settings, monkeypatch, file="case.prm"):
    # Paths in the cases are relative to the top folder.
    monkeypatch.chdir(SOURCE)
    return run_well(SOURCE / "parameters" / name / file, folder,
                    settings + ["Output/Every=0"])


def steps_of(size):
    return [f"Time/{name}={size}" for name in
            ("First step", "Largest step", "Result interval")]


def at(rows, t):
    """The points at a time, by number."""
    return {int(row["point"]): row for row in rows if abs(row["t"] - t) < 1e-9}


def volumes_kept(result, tolerance):
    rows = result.segments()
    for row in rows:
        first = next(r for r in rows if r["segment"] == row["segment"])
        for volume in ("fluid_volume", "wall_volume"):
            assert row[volume] == pytest.approx(first[volume], rel=tolerance)


def rotation(one, other):
    """Of the line from the other point to the one, about the x axis."""
    return math.atan2(one["z"] + one["uz"] - other["z"] - other["uz"],
                      one["y"] + one["uy"] - other["y"] - other["uy"])


def test_antagonism_in_metres_and_pascals(tmp_path, monkeypatch):
    """si.prm is case.prm in other units: the same numbers, converted."""
    settings = [CHAIN + "Cells around a quarter=2",
                CHAIN + "Cells along a segment=4", "Time/End=0.5"] + \
        steps_of(0.1)
    results = [case("antagonism", tmp_path / name, settings, monkeypatch,
                    name)
               for name in ("case.prm", "si.prm")]
    for result in results:
        assert "Warning" not in result.log
    scales = {"length": 1e3, "mid_radius": 1e3, "fluid_volume": 1e9,
              "wall_volume": 1e9, "fluid_pressure": 1e-6, "eta": 1,
              "resets": 1}
    for mm, m in zip(*(result.segments() for result in results), strict=True):
        for column, scale in scales.items():
            assert scale * m[column] == pytest.approx(
                mm[column], rel=1e-8, abs=1e-10), (column, mm["t"])
    assert results[0].last()["length"] > 6.6


def test_helical_twist(tmp_path, monkeypatch):
    twists = []
    for angle in (45, -45):
        result = case("helical_twist", tmp_path / str(angle), [
            CHAIN + "Cells along a segment=4", "Time/End=0.5",
            f"Muscles/helix/helical/Angle={angle}"] + steps_of(0.25),
            monkeypatch)
        points = at(result.table("points.csv"), 0.5)
        twists.append(rotation(points[7], points[8]) -
                      rotation(points[1], points[2]))
        volumes_kept(result, 1e-10)
        # A long tube twists by so much per length, the closed form says.
        middle = (rotation(points[5], points[6]) -
                  rotation(points[3], points[4])) / \
            (points[5]["x"] - points[3]["x"])
        assert abs(middle) == pytest.approx(0.09398, rel=2e-3)
    assert math.degrees(twists[0]) == pytest.approx(-43.086, abs=0.1)
    assert twists[1] == pytest.approx(-twists[0], rel=1e-8)


def test_bending_tentacle(tmp_path, monkeypatch):
    angles = []
    for side in ("z > 0 ? 1 - 0.5*t*z/2 : 1", "z < 0 ? 1 + 0.5*t*z/2 : 1"):
        result = case("bending_tentacle", tmp_path / str(len(angles)), [
            CHAIN + "Cells along a segment=2", "Time/End=0.5",
            f"Muscles/upper/expression/Formula={side}"] + steps_of(0.125),
            monkeypatch)
        points = at(result.table("points.csv"), 0.5)
        angles.append(math.degrees(math.atan2(
            -(points[1]["ux"] - points[2]["ux"]),
            points[1]["z"] - points[2]["z"] +
            points[1]["uz"] - points[2]["uz"])))
        volumes_kept(result, 1e-10)
        assert min(row["wall_mesh_quality"] for row in result.segments()) > 0.7
    # A beam at large strains bends by 34.78 degrees.
    assert abs(angles[0]) == pytest.approx(34.393, rel=2e-3)
    assert abs(angles[0]) == pytest.approx(34.78, rel=0.05)
    assert angles[1] == pytest.approx(-angles[0], rel=1e-6)


def test_soft_actuator(tmp_path, monkeypatch):
    settings = ["Time/End=0.3"] + steps_of(0.1)
    bent = case("soft_actuator", tmp_path / "bent", settings, monkeypatch)
    volumes_kept(bent, 1e-10)
    straight = case("soft_actuator", tmp_path / "straight", settings +
                    ["Tissues/strip/Neo-Hooke/a=0.0005",
                     "Linear solver/Method=direct"], monkeypatch)
    length = straight.last()["length"]
    assert length - 16 == pytest.approx(1.4251, rel=3e-3)
    # A tube whose outside keeps its radius becomes 1.611 longer.
    assert 0.85 < (length - 16) / 1.611 < 0.95
    assert bent.last()["length"] < length


def test_soft_actuator_with_air_inside(tmp_path, monkeypatch):
    """Air that flows in, the volume that it takes, by a pump, and the pressure
    that it has, as a load: the same finger."""
    settings = ["Time/End=0.05"] + steps_of(0.05)
    gas = case("soft_actuator", tmp_path / "gas", settings, monkeypatch,
               "gas.prm")
    first, last = gas.segments()[0], gas.last()
    volume, pressure = last["fluid_volume"], last["fluid_pressure"]
    assert (pressure + 0.101325) * volume == pytest.approx(
        0.101325 * (first["fluid_volume"] + 338 * 0.05), rel=1e-9)
    growth = (volume / first["fluid_volume"] - 1) / 0.05
    pump = case("soft_actuator", tmp_path / "pump", settings + [
        f"Cavities/volume/Relative volume=1 + {growth:.16g}*t"], monkeypatch,
        "pump.prm")
    assert pump.last()["fluid_pressure"] == pytest.approx(pressure, rel=1e-8)
    load = case("soft_actuator", tmp_path / "load", settings + [
        f"Boundary conditions/air on the {part}/follower pressure/Pressure="
        f"{pressure / 0.05:.16g}*t" for part in ("wall", "ends")], monkeypatch)
    expected = at(load.table("points.csv"), 0.05)
    for other in (gas, pump):
        for n, point in at(other.table("points.csv"), 0.05).items():
            for u in ("ux", "uy", "uz"):
                assert point[u] == pytest.approx(expected[n][u], abs=1e-8)
    assert expected[1]["uz"] < -0.5


def test_pores(tmp_path, monkeypatch):
    """What flows, step by step, from the pressures that a pump needs; and
    where it ends."""
    monkeypatch.syspath_prepend(SOURCE / "parameters" / "pores")
    import springs
    coarse = [CHAIN + "Cells around a quarter=2",
              CHAIN + "Cells along a segment=2"]
    pump = springs.Springs(springs.table(case("pores", tmp_path / "pump", [
        *coarse, "Time/End=0.9", "Cavities/Pores=0", "Cavities/Content=volume",
        "Cavities/volume/Relative volume="
        "t < 0.1 ? 1 : 1 + (2*s - 3)*0.1*(t - 0.1)"],
        monkeypatch).folder))
    end, slope = pump.at_rest()
    for g in (4000, 20000):
        result = case("pores", tmp_path / str(g), [
            *coarse, "Time/End=0.4", f"Cavities/Pores={g}"], monkeypatch)
        rows = springs.table(result.folder)
        flowed = rows[0][1]
        assert 0.1 * end < flowed < 0.8 * end
        for (before, *_), (t, v, _) in zip(rows, rows[1:]):
            flowed = pump.step(flowed, t - before, g)
            assert flowed == pytest.approx(v, rel=5e-4), (g, t)
        both = [row["fluid_volume"] for row in result.segments()]
        assert [a + b for a, b in zip(both[::2], both[1::2])] == pytest.approx(
            [2 * both[0]] * (len(both) // 2), rel=1e-12)
    # Backward Euler divides what is still missing by 1 + dt g |dD/dv|.
    (_, _, before), (_, _, after) = rows[-2:]
    assert before / after == pytest.approx(1 - 0.025 * g * slope, rel=2e-3)


def test_viscous_segment(tmp_path, monkeypatch):
    """What the branch leaves of the stroke, and what it takes, as in a standard linear
    solid."""
    monkeypatch.syspath_prepend(SOURCE / "parameters" / "viscous_segment")
    import standard_solid
    found = {}
    for tau in (0.01, 0.1):
        result = case("viscous_segment", tmp_path / str(tau), [
            CHAIN + "Cells along a segment=3", "Time/End=3",
            *(f"Tissues/{tissue}/Viscous branches/slow/Relaxation time={tau}"
              for tissue in ("wall", "cap"))], monkeypatch)
        volumes_kept(result, 1e-12)
        assert standard_solid.relaxation_time(result.folder) == tau
        found[tau] = standard_solid.measured(result.folder)
        _, lost, done = found[tau]
        assert done == pytest.approx(lost, rel=0.01)
    for i, theory in ((0, standard_solid.stroke), (1, standard_solid.loss)):
        assert found[0.1][i] / found[0.01][i] == pytest.approx(
            theory(0.1) / theory(0.01), rel=0.03)


def test_adaptive_septum(tmp_path, monkeypatch):
    """The first rows of its table: refined where the estimate says, the same
    at every change of the program that does not say why."""
    result = case("adaptive_septum", tmp_path, ["Adaptivity/Cycles=2"],
                  monkeypatch)
    meshes = result.table("mesh.csv")
    assert [row["cells"] for row in meshes] == [72, 86, 121]
    assert [row["unknowns"] for row in meshes] == [2667, 3320, 4804]
    assert all(row["volume_change"] < 1e-12 for row in meshes[1:])
    solves = {row["cycle"]: row["fluid_pressure"]
              for row in result.table("resets.csv") if row["t"] == 1}
    assert [solves[cycle] for cycle in range(3)] == pytest.approx(
        [0.008098, 0.008285, 0.008446], rel=1e-3)
    volumes_kept(result, 1e-12)


@pytest.mark.parametrize("case", sorted(
    str(file.relative_to(SOURCE))
    for file in (SOURCE / "parameters").glob("*/*.prm")))
def test_every_case_is_accepted_to_its_end(tmp_path, monkeypatch, case):
    """mesh_file was refused, for fibres whose muscle contracts in the second half
    of the run, and the tests of it ended in the first: the middle of the next cell
    is not the nearest yet where the way out of a cell ends."""
    monkeypatch.chdir(SOURCE)
    result = run(case, tmp_path, options=["--check"])
    assert result.exit_code == 0, result.message


def test_every_case_has_a_test():
    """A coarse or short variant of every case of the gallery is run here, in
    another file, or in tests/runs with reference output."""
    tests = "".join(
        file.read_text() for folder in ("physics", "runs", "errors")
        for file in (SOURCE / "tests" / folder).glob("*")
        if file.suffix in (".py", ".prm", ".cc"))
    cases = sorted(file.parent.relative_to(SOURCE / "parameters").parts[0]
                   for file in (SOURCE / "parameters").glob("*/README.md"))
    assert len(cases) >= 8
    for name in cases:
        assert f'"{name}"' in tests or f"parameters/{name}/" in tests, name


def test_lumbricus_terrestris_with_muscles_of_given_strength(tmp_path, monkeypatch):
    """The circular muscle makes the pressure that is measured, the longitudinal one
    next to none. Chambers without cells, coarser, to the end of the first pulses."""
    result = case("lumbricus_terrestris", tmp_path, [
        CHAIN + "Cells around a quarter=2", CHAIN + "Liquid=cavity",
        "Time/End=4.5"], monkeypatch, "active_stress.prm")
    rows = [row for row in result.segments()
            if row["segment"] == 6 and row["t"] >= 1.5]
    peak = max(rows, key=lambda row: row["fluid_pressure"])
    assert 1000 * peak["fluid_pressure"] == pytest.approx(1.24, rel=0.03)
    assert peak["length"] / 4.13 - 1 == pytest.approx(0.233, abs=0.01)
    # Between the pulses.
    assert 1000 * min(row["fluid_pressure"] for row in rows) < 0.12
    volumes_kept(result, 1e-9)


@pytest.mark.parametrize("circular", [0, 0.1])
def test_pressure_of_a_longitudinal_muscle_needs_the_circular_one(
        tmp_path, monkeypatch, circular):
    """Long chambers that are all alike, far from septa, as a tube: free_body.py."""
    monkeypatch.syspath_prepend(SOURCE / "parameters" / "lumbricus_terrestris")
    import free_body
    length, pressure = free_body.tube(0.06, circular)
    pulses = [f"Muscles/{muscle}/wave/{setting}" for muscle, amplitude in (
        ("longitudinal", 0.06), ("circular", circular), ("septal circular", 0),
        ("septal radial", 0)) for setting in (
            f"Amplitude={amplitude}", "Wavelength=1e9", "Phase=0")]
    result = case("lumbricus_terrestris", tmp_path, pulses + [
        CHAIN + "Cells around a quarter=2", CHAIN + "Liquid=cavity",
        CHAIN + "Number of segments=3", CHAIN + "Segment length=20",
        CHAIN + "Cells along a segment=10", "Time/End=1.5"], monkeypatch,
        "active_stress.prm")
    first, last = result.segments()[1], result.last(2)
    assert last["length"] / first["length"] == pytest.approx(length, abs=0.005)
    assert last["fluid_pressure"] == pytest.approx(
        pressure, abs=5e-5 if circular == 0 else 3e-5)
    volumes_kept(result, 1e-9)
