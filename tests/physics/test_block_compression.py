# SPDX-License-Identifier: LGPL-2.1-or-later
"""The block that many programs compress: parameters/block_compression."""
import pytest
from lumbricus_run import SOURCE, run_well

CASE = SOURCE / "parameters" / "block_compression" / "case.prm"
# Compression of the middle of the top, read to 0.3 % of the height from the
# diagram for four quadratic cells along an edge in deal.II's tutorial step-44.
PUBLISHED = {0.2: 0.219, 0.4: 0.424, 0.6: 0.586, 0.8: 0.697, 1.0: 0.772}
# The compression at the last load by FEniCSx and NGSolve: benchmarks/reese.
OTHER_PROGRAMS = 0.771923416470


def run_block(folder, *settings, ranks=1):
    return run_well(CASE, folder, ["Geometry/block/Cells=4, 4, 4",
                                   "Output/Every=0", *settings], ranks=ranks)


def compression(result):
    return {row["t"]: -row["uz"] for row in result.table("points.csv")
            if row["point"] == 1}


def test_published(tmp_path):
    found = compression(run_block(tmp_path, ranks=2))
    for t, expected in PUBLISHED.items():
        assert found[t] == pytest.approx(expected, abs=0.003)
    assert found[1.] == pytest.approx(OTHER_PROGRAMS, rel=1e-9)


def test_incompressible(tmp_path):
    """At nu = 0.5 the volume stays what it is, and nothing else changes much."""
    result = run_block(tmp_path, "Tissues/rubber/Neo-Hooke/nu=0.5")
    for row in result.segments():
        assert row["wall_volume"] == pytest.approx(4., abs=1e-10)
    assert compression(result)[1.] == pytest.approx(OTHER_PROGRAMS, rel=2e-3)


def test_warning_of_folded_cells(tmp_path):
    """Pressed further, cells at the edge of the load fold, which the table had
    and the log did not say."""
    good = run_well(CASE, tmp_path / "good")
    assert "Warning" not in good.log
    folded = run_well(CASE, tmp_path / "folded", ["Time/End=1.6"])
    first = next(row for row in folded.segments()
                 if row["wall_mesh_quality"] <= 0)
    assert folded.log.count("Warning") == 1
    assert f"from time {first['t']:g} on the wall of segment 1 has a cell that " \
        "is folded" in folded.log
