# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large deformation, again and again: a segment shortens to a quarter of its
length, and one wave is like the other."""
import pytest
from lumbricus_run import SOURCE, run_well

COARSE = ["Geometry/segment chain/Cells around a quarter=2", "Output/Every=0"]
VALUES = ("length", "mid_radius", "fluid_volume", "wall_volume",
          "fluid_pressure")


def of_segment(result, segment):
    return [row for row in result.segments() if row["segment"] == segment]


def test_a_quarter_of_the_length(tmp_path):
    # Between membranes, driven by muscles alone.
    result = run_well(SOURCE / "parameters" / "quarter_length" / "case.prm",
                      tmp_path, ["Time/End=1.5", "Output/Every=0"], ranks=2)
    middle = of_segment(result, 2)
    lengths = [row["length"] for row in middle]
    assert max(lengths) / min(lengths) >= 4
    assert lengths.index(max(lengths)) < lengths.index(min(lengths))
    for row in result.segments():
        for volume in ("fluid_volume", "wall_volume"):
            at_rest = of_segment(result, row["segment"])[0][volume]
            assert row[volume] == pytest.approx(at_rest, rel=1e-10)
        assert row["eta"] < 1e-3
        assert row["fluid_mesh_quality"] > 0.3
        assert row["wall_mesh_quality"] > 0.3


def waves(folder, settings):
    """Four waves through three segments, after the ramp: for each the worst
    quality of the liquid's mesh and the values of all steps."""
    result = run_well(SOURCE / "parameters" / "peristalsis" / "case.prm",
                      folder,
                      COARSE + settings +
                      ["Geometry/segment chain/Cells along a segment=2",
                       "Geometry/segment chain/Cells across the liquid=1",
                       "Geometry/segment chain/Number of segments=3",
                       "Reset/Every=solve", "Time/End=4.25"] +
                      [f"Muscles/{muscle}/wave/Wavelength=3" for muscle in
                       ("circular", "septal", "longitudinal")])
    found = []
    for wave in range(4):
        rows = [row for row in result.segments()
                if wave + 0.25 + 1e-9 < row["t"] < wave + 1.25 + 1e-9]
        found.append((min(row["fluid_mesh_quality"] for row in rows),
                      [[row[name] for row in rows] for name in VALUES]))
    return found


def difference(one, other):
    """The largest over steps and segments, relative to the largest value."""
    return max(max(abs(a - b) for a, b in zip(before, after)) /
               max(abs(a) for a in before)
               for before, after in zip(one[1], other[1]))


def test_every_wave_is_the_same(tmp_path):
    # Cells that go with the liquid drift: after four waves they are worse than
    # after two, and nothing repeats exactly.
    relaxed = waves(tmp_path / "relaxed", [])
    drifting = waves(tmp_path / "drifting", ["Reset/Relax below=0"])
    assert drifting[3][0] < drifting[1][0] - 0.005
    assert relaxed[3][0] == pytest.approx(relaxed[1][0], abs=1e-9)
    assert relaxed[3][0] > drifting[3][0]
    assert difference(relaxed[1], relaxed[3]) < 1e-10
    assert difference(drifting[1], drifting[3]) > 1e-8
    # Where the nodes inside the liquid are makes no difference.
    assert difference(relaxed[1], drifting[1]) < 1e-4


def test_pressures_of_lumbricus_terrestris(tmp_path):
    # Peaks of 12 and 7 cm of water, on a mesh that is coarser than the case's.
    result = run_well(SOURCE / "parameters" / "lumbricus_terrestris" / "case.prm",
                      tmp_path, COARSE + ["Time/End=7.5"])
    for segment in (5, 6):
        pressures = [1000 * row["fluid_pressure"]
                     for row in of_segment(result, segment) if row["t"] > 1.5]
        peaks = sorted(b for a, b, c in zip(pressures, pressures[1:],
                                            pressures[2:]) if a < b > c)
        assert len(peaks) == 2
        assert peaks[1] == pytest.approx(1.18, rel=0.1)
        assert peaks[0] == pytest.approx(0.69, rel=0.1)
