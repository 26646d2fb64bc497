# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whoever solves the linear systems, the solution is the same; the solver 'auto' says
what it chose, and goes on with factors where multigrid does not do."""
import pathlib
import re

from lumbricus_run import SOURCE, run_well
from test_invariance import equal

SEGMENT = pathlib.Path(__file__).parent / "segment.prm"
SHORT = ["Mesh/Global refinements=1", "Time/End=0.09",
         "Time/First step=0.03", "Time/Largest step=0.03"]
AUTO = "Linear solver/auto/"
LEVELS = [AUTO + "multigrid/Coarsest unknowns=1000"]
CHOSEN = r"solved by multigrid: factors would take (\S+) operations per unknown and " \
         r"(\S+) GB a rank, of (\S+) GB"


def test_multigrid_where_factors_are_too_much_work_or_too_large(tmp_path):
    factors = run_well(SEGMENT, tmp_path / "factors", SHORT, ranks=2)
    assert "multigrid" not in factors.log
    for limit in ("Most work=100", "Most memory=1e-4"):
        run = run_well(SEGMENT, tmp_path / limit, SHORT + LEVELS + [AUTO + limit],
                       ranks=2)
        work, needed, available = map(float, re.search(CHOSEN, run.log).groups())
        # Of 5,587 unknowns: dense matrices would take 1e7 and 0.06 GB.
        assert 100 < work < 1e6
        assert 1e-4 * available < needed < 0.06
        assert "goes on with" not in run.log
        equal(factors.segments(), run.segments(), 1e-8)


def test_factors_follow_where_multigrid_does_not_do(tmp_path):
    factors = run_well(SEGMENT, tmp_path / "factors", SHORT)
    run = run_well(SEGMENT, tmp_path / "auto", SHORT + LEVELS + [
        AUTO + "Most work=100", AUTO + "Most iterations=11"])
    assert "The linear solver goes on with factors, since multigrid needed more " \
           "than 11 iterations." in run.log
    equal(factors.segments(), run.segments(), 1e-8)


def test_stiffness_contrast_of_a_million(tmp_path, monkeypatch):
    """A finger of rubber with rings of steel wire stopped with exit code 2: no
    factors in single precision do, and 'auto' knew no others."""
    monkeypatch.chdir(SOURCE)
    runs = [run_well(SOURCE / "parameters/soft_actuator/case.prm",
                     tmp_path / method,
                     ["Tissues/ring/Neo-Hooke/a=5e4", "Time/End=0.05",
                      "Time/First step=0.0125", "Time/Largest step=0.0125",
                      "Time/Result interval=0",
                      "Output/Every=0", f"Linear solver/Method={method}"])
            for method in ("auto", "direct")]
    assert "goes on with factors in double precision" in runs[0].log
    equal(*(run.segments() for run in runs), 1e-8)
