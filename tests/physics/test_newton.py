# SPDX-License-Identifier: LGPL-2.1-or-later
"""Newton's method converges quadratically: the linearisation is exact."""
import pathlib

import pytest
from lumbricus_run import run_well

HERE = pathlib.Path(__file__).parent


def increments(result):
    """The relative increments of every solve that took whole steps."""
    solves = {}
    for row in result.table("newton.csv"):
        solves.setdefault((row["step"], row["solve"]), []).append(row)
    return [[row["increment"] for row in solve] for solve in solves.values()
            if all(row["step_length"] == 1 for row in solve)]


# A follower pressure (unsymmetric tangent), muscles and liquid with a reset.
@pytest.mark.parametrize("case", ["tube.prm", "segment.prm", "chain.prm"])
def test_quadratic(tmp_path, case):
    result = run_well(HERE / case, tmp_path, ["Linear solver/Method=direct",
                                              "Time/Largest step=0.1",
                                              "Time/First step=0.1"])
    quadratic = 0
    for solve in increments(result):
        # The last increment above the noise, against the one before it. With
        # e_k+1 = C e_k^2 the number of valid digits doubles: C is bounded.
        for before, after in zip(solve, solve[1:]):
            if before < 1e-2 and after > 1e-13:
                assert after < 100 * before**2 + 1e-11, solve
                quadratic += 1
        # What is still to come is less than the tolerance.
        factor = solve[-1] / solve[-2] if len(solve) > 1 else 0.5
        assert solve[-1] * factor / (1 - factor) < 1e-8
    assert quadratic >= 3
