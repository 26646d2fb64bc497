# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three problems of Land et al. (Proc. R. Soc. A 471, 20150641, 2015) at some
20,000 unknowns. The numbers to compare with were computed independently of this
program, on exact ellipsoids with elements of fifth degree."""
import pytest
from lumbricus_run import SOURCE, run_well
from test_invariance import TO_THE_END

APEX = ("inside", "in the middle of the wall", "outside")
# A few cells.
COARSE = [f"Geometry/truncated ellipsoid/Cells {which}" for which in
          ("around a quarter=2", "up to the base=3", "through the wall=1")]


def deformed(problem, folder, ranks, monkeypatch, settings=()):
    """Where the points are in the end, by number."""
    # Paths in the cases are relative to the top folder.
    monkeypatch.chdir(SOURCE)
    result = run_well(SOURCE / f"parameters/land/{problem}.prm", folder,
                      ["Output/Every=0", *settings], ranks)
    rows = result.table("points.csv")
    end = max(row["t"] for row in rows)
    assert end == 1
    return [{c: row[c] + row["u" + c] for c in "xyz"}
            for row in rows if row["t"] == end]


@pytest.mark.parametrize("ranks", [1, 2])
def test_beam(tmp_path, monkeypatch, ranks):
    tip, *_ = deformed("beam", tmp_path, ranks, monkeypatch)
    assert tip["z"] == pytest.approx(4.1665, rel=3e-3)
    assert tip["x"] == pytest.approx(9.1775, rel=3e-3)


@pytest.mark.parametrize("problem, ranks, positions, bar", [
    ("inflation", 2, (-26.6137, -27.3012, -28.2812), 2e-3),
    ("contraction", 1, (-12.348, -14.2221, -15.452), 5e-3)])
def test_ventricle(tmp_path, monkeypatch, problem, ranks, positions, bar):
    points = deformed(problem, tmp_path, ranks, monkeypatch)
    assert {where: point["x"] for where, point in
            zip(APEX, points)} == pytest.approx(
                dict(zip(APEX, positions)), rel=bar)


@pytest.mark.parametrize("problem", ["inflation", "contraction"])
def test_ventricle_on_one_and_two_ranks(tmp_path, monkeypatch, problem):
    one, two = (deformed(problem, tmp_path / str(ranks), ranks, monkeypatch,
                         COARSE + TO_THE_END) for ranks in (1, 2))
    for a, b in zip(one, two, strict=True):
        for c in "xyz":
            assert a[c] == pytest.approx(b[c], rel=1e-9, abs=1e-9)
