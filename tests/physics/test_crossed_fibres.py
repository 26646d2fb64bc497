# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tube whose wall has two families of crossed helical fibres, as worms and McKibben
muscles have them, against the closed forms of parameters/crossed_fibres: at the
volume inside and the length at which nothing pulls at its closed ends, what the
pressure is and that nothing pulls; and what becomes of them where fibres are so stiff
that they keep their length."""
import csv
import math
import pathlib
import sys

import pytest
from lumbricus_run import SOURCE, run_well

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(SOURCE / "parameters" / "crossed_fibres"))
from closed_form import MAGIC, Tube, middle_of  # noqa: E402

# By the angle, a volume at which fibres are taut through all of the wall.
VOLUME = {30: 1.6, 70: 1.2}


def pressure_and_force(folder, angle, tube, length, volume, settings=(), ranks=1):
    """P, and T at both ends, of the whole cross-section."""
    family = "Tissues/wall/Elastic fibres/"
    run = run_well(HERE / "crossed_fibres.prm", folder, [
        "Geometry/open cylinder/Wall layer thicknesses="
        f"{tube.outer - tube.radius!r}",
        f"Tissues/wall/Neo-Hooke/a={tube.a}",
        *(f"{family}{name}/{setting}" for name, sign in
          (("right-handed", 1), ("left-handed", -1)) for setting in
          (f"helical/Angle={sign * angle}", f"k1={tube.k1}", f"k2={tube.k2}")),
        f"Cavities/volume/Relative volume=1 + {volume - 1!r}*t",
        "Boundary conditions/rear/displacement/Displacement="
        f"{2 * (length - 1)!r}*t; 0; 0", *settings], ranks)
    with open(run.folder / "reactions.csv") as file:
        forces = {row["name"]: 4 * float(row["force_x"])
                  for row in csv.DictReader(file) if float(row["t"]) == 1}
    return run.last()["fluid_pressure"], forces["rear"], -forces["front"]


@pytest.mark.parametrize("angle, k2, ranks", [
    (30, 0, 1), (70, 0, 2), (30, 20, 1), (70, 20, 1)])
def test_closed_form_of_stiff_fibres(tmp_path, angle, k2, ranks):
    """Below 54.74 degrees the tube becomes shorter, above it longer, at no force."""
    tube = Tube(angle, 2., k2)
    volume = VOLUME[angle]
    length, expected = tube.at_volume(volume)
    assert (length > 1.1) if angle > MAGIC else (length < 0.95)
    assert abs(tube.angle(length, volume) - MAGIC) < abs(angle - MAGIC) - 5
    pressure, *forces = pressure_and_force(tmp_path, angle, tube, length, volume,
                                           ranks=ranks)
    print(angle, k2, length, pressure / expected - 1,
          [force / (math.pi * 4 * expected) for force in forces])
    assert pressure == pytest.approx(expected, rel=2e-6)
    for force in forces:
        assert abs(force) < 2e-6 * math.pi * tube.radius**2 * expected
    # It is another one at a length that is off by little.
    _, off = pressure_and_force(tmp_path / "off", angle, tube, length + 1e-3,
                                volume)[:2]
    assert off > 1e-4 * math.pi * tube.radius**2 * expected


@pytest.mark.parametrize("angle", [30, 70])
def test_limit_of_fibres_that_keep_their_length(tmp_path, angle):
    """Ten times as stiff, ten times as near to Clark and Cowey; the length without a
    force is found from those at two lengths."""
    volume, errors = VOLUME[angle], []
    for k1 in (1, 10, 100):
        tube = Tube(angle, k1, thickness=0.02)
        guess = tube.at_volume(volume)[0]
        lengths = [guess - 1e-4, guess + 1e-4]
        low, high = (pressure_and_force(tmp_path / f"{k1}.{n}", angle, tube, length,
                                        volume)[1]
                     for n, length in enumerate(lengths))
        length = lengths[0] - low * 2e-4 / (high - low)
        errors.append(length / tube.inextensible(volume)[0] - 1)
        assert low < 0 < high
    print(angle, errors)
    for coarse, fine in zip(errors, errors[1:]):
        assert abs(fine) < abs(coarse) / (2 if fine * coarse < 0 else 4)
    assert abs(errors[-1]) < 2e-3


@pytest.mark.parametrize("case, angle", [("case.prm", 70), ("shortens.prm", 30)])
def test_case_of_the_gallery(tmp_path, case, angle):
    """In the middle of a tube with caps the closed form holds."""
    run_well(SOURCE / "parameters" / "crossed_fibres" / case, tmp_path, [
        "Time/End=0.6", "Time/Result interval=0.2", "Time/Largest step=0.2",
        "Output/Every=0"])
    rows = [row for row in middle_of(tmp_path) if row[1] > 0.009]
    tube, before = Tube(angle, 5., 100.), 1.
    assert len(rows) >= 3
    for _, pressure, length in rows:
        expected, volume = tube.at_pressure(pressure)
        assert length == pytest.approx(expected, rel=2.5e-3)
        assert (length > before) if angle > MAGIC else (length < before)
        before = length
    assert tube.angle(expected, volume) == pytest.approx(MAGIC, abs=4)
    # So long are fibres that end there and keep their length.
    limit = math.cos(math.radians(MAGIC)) / math.cos(math.radians(angle))
    assert length == pytest.approx(limit, rel=0.08)
