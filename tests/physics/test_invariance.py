# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result does not depend on the number of ranks, nor on whether a quarter,
a half or the whole of a cross-section is meshed."""
import math
import pathlib

import pytest
from lumbricus_run import run_well

HERE = pathlib.Path(__file__).parent


def equal(rows, others, tolerance):
    assert len(rows) == len(others) > 3
    for row, other in zip(rows, others):
        for name, value in row.items():
            if math.isnan(value):
                assert math.isnan(other[name])
                continue
            scale = max(abs(value), abs(other[name]))
            # Numbers that are zero but for rounding have no relative error.
            assert abs(value - other[name]) <= tolerance * scale + 1e-14, (
                name, row, other)


# On several ranks sums are added up as messages come, and so Newton's method may need
# an iteration more or less to the same tolerance: of eta, a ratio of 7e-4, that left
# 1e-9 now and then. To its end the method leaves nothing of it.
TO_THE_END = ["Newton/Force tolerance=1e-11", "Newton/Increment tolerance=1e-12"]


def test_one_two_and_four_ranks(tmp_path):
    tables = [run_well(HERE / "chain.prm", tmp_path / str(ranks), TO_THE_END,
                       ranks=ranks).segments() for ranks in (1, 2, 4)]
    equal(tables[0], tables[1], 1e-9)
    equal(tables[0], tables[2], 1e-9)


def test_one_and_two_ranks_and_the_other_solver(tmp_path):
    tables = [run_well(HERE / "chain.prm", tmp_path / f"{method}{ranks}",
                       [f"Linear solver/Method={method}", *TO_THE_END],
                       ranks).segments()
              for method, ranks in (("kept factor", 1), ("direct", 1),
                                    ("direct", 2))]
    equal(tables[0], tables[1], 1e-8)
    equal(tables[1], tables[2], 1e-9)


def test_quarter_half_and_full_section(tmp_path):
    tables = [run_well(HERE / "chain.prm", tmp_path / section,
                       [f"Geometry/segment chain/Cross-section={section}"],
                       ranks=2).segments()
              for section in ("quarter", "half", "full")]
    equal(tables[0], tables[1], 1e-7)
    equal(tables[0], tables[2], 1e-7)


def test_global_refinement_converges(tmp_path):
    # The shape of the chain changes little with refinement (Q2): no mesh
    # parameter is off by an order.
    lengths = [run_well(HERE / "chain.prm", tmp_path / str(level),
                        [f"Mesh/Global refinements={level}"],
                        ranks=2).last(2)["length"] for level in (0, 1)]
    assert lengths[1] == pytest.approx(lengths[0], rel=5e-3)
