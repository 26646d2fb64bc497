# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run costs, in operations: seconds depend on the machine, these do not. Where
one of the bounds breaks, the program has become slower for a reason to be found; where
counts fall for good, lower the bounds with them (doc/performance.md)."""
import pathlib

import pytest
from lumbricus_run import SOURCE, run_well

HERE = pathlib.Path(__file__).parent
BLOCK = SOURCE / "parameters" / "block_compression" / "case.prm"

# Newton iterations, linear iterations, factorisations. Measured: 31, 174, 5 and 12, 84, 1
# for the chain on one rank, 12, 85, 1 on two, where MUMPS adds as messages come; with
# Reset/Every = solve, as the chain was solved before, 53, 293, 3.
CASES = {
    "block": (BLOCK, ["Geometry/block/Cells=4, 4, 4",
                      "Newton/Volume tolerance=1e-9",
                      "Newton/Predictor order=2"], 32, 200, 6),
    "chain": (HERE / "chain.prm", [], 14, 100, 3),
    "chain, reset after solves": (HERE / "chain.prm", ["Reset/Every=solve"],
                                  57, 335, 5),
    # Without cells of liquid: 12, 74, 1 on one rank and on two.
    "chain of cavities": (HERE / "chain.prm",
                          ["Geometry/segment chain/Liquid=cavity"], 13, 90, 3),
}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("case", CASES)
def test_operation_counts(tmp_path, case, ranks):
    file, settings, newton, linear, factorisations = CASES[case]
    steps = run_well(file, tmp_path, settings + ["Output/Every=0"],
                     ranks).steps()
    total = {name: sum(row[name] for row in steps)
             for name in ("newton_iterations", "linear_iterations",
                          "factorisations")}
    assert 0.7 * newton < total["newton_iterations"] <= newton, total
    assert 0.5 * linear < total["linear_iterations"] <= linear, total
    assert 1 <= total["factorisations"] <= factorisations, total


def test_the_log_says_where_the_time_went(tmp_path):
    result = run_well(HERE / "chain.prm", tmp_path, ["Output/Every=0"])
    steps = result.steps()
    rows = dict(line.rsplit(None, 3)[0:2] for line in result.log.splitlines()
                if line.rstrip()[-1:].isdigit() and "%" in line)
    seconds = {name.strip(): float(value) for name, value in rows.items()}
    for name in ("assembly", "linear solver", "factorisation", "iterations",
                 "residual", "reset", "output", "setup"):
        assert name in seconds, seconds
    assert seconds["factorisation"] + seconds["iterations"] <= \
        1.02 * seconds["linear solver"] + 0.02
    calls = {line.split()[0]: int(line.split()[-1])
             for line in result.log.splitlines()
             if line.split()[:1] in (["factorisation"], ["iterations"])}
    assert calls == {
        "factorisation": sum(row["factorisations"] for row in steps),
        "iterations": sum(row["linear_iterations"] for row in steps)}
    assert "Peak memory of the largest rank" in result.log
