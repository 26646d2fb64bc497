# SPDX-License-Identifier: LGPL-2.1-or-later
"""parameters/whole_worm with ten segments instead of 150, each for fifteen: what must
hold of a worm that crawls, and that one number makes it coarser. First seen with
chambers as short as those of the animal: septa seven times as wide as a segment is
long were slack at rest, so that Newton's method bent them through each other, and
cells at the sharp rim of the caps folded as the ground dragged them."""
import pytest
from lumbricus_run import SOURCE, go_on, run_well

CASE = SOURCE / "parameters" / "whole_worm" / "case.prm"
NUMBER = "Geometry/segment chain/Number of segments"
# The ramp ends at 1.125; then the wave is under way. Both are ends of steps. After a
# restart steps begin elsewhere, so that a long one may be cut, and then differ by 1e-10.
# Increments are taken to a tenth of what the restart is compared to: with 1e-12 the
# estimate of what was still to come was 7e-13 where Newton's method ended.
MIDDLE, END = 1.2, 1.4
SETTINGS = [f"{NUMBER}=10", "Time/Largest step=0.1", "Output/Every=0",
            f"Time/End={END}", "Time/Result interval=0.2",
            "Newton/Force tolerance=1e-11", "Newton/Increment tolerance=1e-13"]


@pytest.fixture(scope="module")
def worm(tmp_path_factory):
    return crawl(tmp_path_factory.mktemp("worm"))


def crawl(folder, settings=(), ranks=1):
    # The table of measures is named from the top folder.
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(SOURCE)
        return run_well(CASE, folder / "run", [*SETTINGS, *settings],
                        ranks=ranks)


def last_rows(result, name):
    rows = result.table(name)
    return [row for row in rows if row["t"] == rows[-1]["t"]]


def equal(one, other, tolerance):
    """What both say of their last time, relative to the largest of a column."""
    for name in ("segments.csv", "body.csv"):
        rows, expected = last_rows(one, name), last_rows(other, name)
        assert len(rows) == len(expected)
        for column in set(rows[0]) - {"eta", "speed"}:
            size = max(abs(row[column]) for row in expected)
            for row, reference in zip(rows, expected):
                assert row[column] == pytest.approx(
                    reference[column], abs=tolerance * size + 1e-15), column


def test_volumes_and_cells(worm):
    at_rest = {row["segment"]: row for row in worm.segments() if row["t"] == 0}
    for row in worm.segments():
        for volume in ("fluid_volume", "wall_volume"):
            assert row[volume] == pytest.approx(
                at_rest[row["segment"]][volume], rel=1e-12)
        assert row["wall_mesh_quality"] > 0.05, (row["t"], row["segment"])
    assert "folded" not in worm.log
    assert sum(row["cuts"] for row in worm.steps()) <= 1


def test_it_gets_ahead(worm):
    """Towards the head, which is where x is less; where the circular muscle
    contracts it is long and thin, with the higher pressure."""
    last = worm.table("body.csv")[-1]
    assert last["stride"] > 4
    assert last["head_x"] < -5
    rows = last_rows(worm, "segments.csv")[1:-1]
    rest = {row["segment"]: row for row in worm.segments() if row["t"] == 0}

    def strains(row):
        return [row[name] / rest[row["segment"]][name] - 1
                for name in ("length", "mid_radius")]

    pressed = max(rows, key=lambda row: row["fluid_pressure"])
    length, radius = strains(pressed)
    assert length > 0.15 and radius < -0.02
    length, radius = strains(min(rows, key=lambda row: strains(row)[0]))
    assert length < -0.15 and radius > 0.05
    # kPa; 1.18 have been measured.
    assert 0.7 < 1e3 * pressed["fluid_pressure"] < 1.7


def test_two_ranks(worm, tmp_path):
    equal(crawl(tmp_path, ranks=2), worm, 1e-9)


def test_restart_in_the_middle_of_the_wave(worm, tmp_path):
    begun = crawl(tmp_path, [f"Time/End={MIDDLE:g}"])
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(SOURCE)
        equal(go_on(begun.folder, [f"Time/End={END}"]), worm, 1e-12)


def test_one_number_makes_it_coarser(worm, tmp_path):
    """The same worm at rest: length to rounding, volume up to how finely the taper is
    drawn."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(SOURCE)
        finer = run_well(CASE, tmp_path / "finer", [
            f"{NUMBER}=40", "Boundary conditions/Names=", "Body forces/Names=",
            *(f"Muscles/tone {way}/expression/Formula=1"
              for way in ("around", "inwards")), "Time/End=0.001",
            "Time/First step=0.001", "Output/Every=0"])

    def sizes(result):
        rows = [row for row in result.segments() if row["t"] == 0]
        return [sum(row[name] for row in rows)
                for name in ("length", "fluid_volume", "wall_volume")]

    # Behind the last segment there is no septum.
    for result, n in ((worm, 10), (finer, 40)):
        assert sizes(result)[0] == pytest.approx(155 - 0.05 * 150 / n,
                                                 rel=1e-12)
    for one, other in zip(sizes(worm)[1:], sizes(finer)[1:]):
        assert one == pytest.approx(other, rel=0.03)
