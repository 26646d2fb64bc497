# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two problems of Land et al. (Proc. R. Soc. A 471, 20150641, 2015) at some
20,000 unknowns. The numbers to compare with were computed independently of this
program, on exact ellipsoids with elements of fifth degree."""
import pytest
from lumbricus_run import SOURCE, run_well

RANKS = pytest.mark.parametrize("ranks", [1, 2])


def deformed(problem, folder, ranks, monkeypatch):
    """Where the points are in the end, by number."""
    # Paths in the cases are relative to the top folder.
    monkeypatch.chdir(SOURCE)
    result = run_well(SOURCE / f"parameters/land/{problem}.prm", folder,
                      ["Output/Every=0"], ranks)
    rows = result.table("points.csv")
    end = max(row["t"] for row in rows)
    assert end == 1
    return [{c: row[c] + row["u" + c] for c in "xyz"}
            for row in rows if row["t"] == end]


@RANKS
def test_beam(tmp_path, monkeypatch, ranks):
    (tip,) = deformed("beam", tmp_path, ranks, monkeypatch)
    assert tip["z"] == pytest.approx(4.1665, rel=3e-3)
    assert tip["x"] == pytest.approx(9.1775, rel=3e-3)


@RANKS
def test_inflation(tmp_path, monkeypatch, ranks):
    inside, middle, outside = deformed("inflation", tmp_path, ranks, monkeypatch)
    assert inside["x"] == pytest.approx(-26.6137, rel=2e-3)
    assert middle["x"] == pytest.approx(-27.3012, rel=2e-3)
    assert outside["x"] == pytest.approx(-28.2812, rel=2e-3)
