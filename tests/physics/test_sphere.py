# SPDX-License-Identifier: LGPL-2.1-or-later
"""A thick sphere around a cavity, against numbers that a one-dimensional integral
and an ordinary differential equation give: what volume takes what pressure, beyond
the limit point too; gas that expands; a leak."""
import math
import pathlib

import pytest
from lumbricus_run import run_well

SPHERE = pathlib.Path(__file__).parent / "sphere.prm"


def through(volumes):
    """V/V_0 over time, straight from one of these to the next: at times 1, 2..."""
    formula, last = str(volumes[-1]), len(volumes)
    for n in range(last, 0, -1):
        a = ([1, *volumes])[n - 1]
        formula = (f"if(t < {n}, {a} + {volumes[n - 1] - a}*(t - {n - 1}), "
                   f"{formula})")
    return ["Cavities/Content=volume",
            f"Cavities/volume/Relative volume={formula}", f"Time/End={last}",
            "Time/First step=0.25", "Time/Largest step=0.25"]


def at(run, time, name):
    rows = [row for row in run.segments() if abs(row["t"] - time) < 1e-9]
    assert len(rows) == 1
    return rows[0][name]


@pytest.mark.parametrize("ranks", [1, 2])
def test_pressure_at_a_volume_and_beyond_the_limit_point(tmp_path, ranks):
    """A pressure that is prescribed ends at V/V_0 = 6.11; a volume does not."""
    volumes = [1.5, 2, 5, 6.10989264, 7.5, 8, 64]
    pressures = {1.5: 0.3828087365, 2: 0.5645064496, 6.10989264: 0.8164236480,
                 8: 0.8069266031, 64: 0.4912507070}
    run = run_well(SPHERE, tmp_path, through(volumes), ranks)
    for n, volume in enumerate(volumes, 1):
        if volume in pressures:
            assert at(run, n, "fluid_pressure") == pytest.approx(
                pressures[volume], rel=1e-4), volume
    top = at(run, 4, "fluid_pressure")
    assert at(run, 3, "fluid_pressure") < top > at(run, 5, "fluid_pressure")


def test_a_thinner_wall(tmp_path):
    run = run_well(SPHERE, tmp_path, [
        "Geometry/hollow sphere/Wall thickness=0.1",
        "Geometry/hollow sphere/Cells through the wall=1",
        *through([2.90208357, 8])])
    assert at(run, 1, "fluid_pressure") == pytest.approx(0.1180125366, rel=2e-4)
    assert at(run, 2, "fluid_pressure") == pytest.approx(0.0973301655, rel=2e-4)


@pytest.mark.parametrize("exponent, outside, stretch", [
    (1, 0.05, 1.0941939033), (1, 0, 1.2372872019), (1.4, 0, 1.1972229402)])
def test_gas_expands(tmp_path, exponent, outside, stretch):
    run = run_well(SPHERE, tmp_path, [
        "Tissues/wall/Neo-Hooke/a=0.1", "Cavities/Content=gas",
        f"Cavities/gas/Exponent={exponent}", "Cavities/gas/Absolute pressure "
        f"outside=0.101325 + ({outside} - 0.101325)*t", "Time/End=1"])
    rows = run.segments()
    assert (rows[-1]["fluid_volume"] / rows[0]["fluid_volume"])**(1 / 3) == \
        pytest.approx(stretch, rel=1e-5)


def test_a_leak(tmp_path):
    """Blown up to twice its volume by an inflow in the first unit of time, then
    left to a leak: dV/dt = -P. The error is of first order in the time step, so
    that extrapolation takes it away."""
    expected = {0.5: 1.9336882899, 1: 1.8695835459, 2: 1.7483652549,
                5: 1.4459594916}
    # In units of the volume of the mesh, which is that of the sphere to 1e-4.
    V_0 = run_well(SPHERE, tmp_path / "rest", ["Time/End=1e-3"]).segments()[
        0]["fluid_volume"]
    runs = []
    for step in (0.1, 0.05):
        runs.append(run_well(SPHERE, tmp_path / str(step), [
            f"Cavities/Inflow=if(t < 1 + 1e-6, {V_0}, 0)",
            f"Cavities/Leak=if(t < 1 + 1e-6, 0, {V_0 / (4 / 3 * math.pi)})",
            "Time/End=6", f"Time/First step={step}",
            f"Time/Largest step={step}"]))
    for time, volume in expected.items():
        coarse, fine = (at(run, 1 + time, "fluid_volume") / V_0 for run in runs)
        assert (coarse - volume) / (fine - volume) == pytest.approx(2, abs=0.2)
        assert 2 * fine - coarse == pytest.approx(volume, rel=1e-5)
