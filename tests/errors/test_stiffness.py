# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tissues of which one is so much stiffer that the other drowns in its rounding
errors: a chain with caps of 1e12 times the stiffness was one per cent off, one
of 1e14 did not move at all, with exit code 0, and others ended with 'try a
smaller step'."""
import pathlib

import pytest
from lumbricus_run import run, run_well
from mistakes import check_one_message

CHAIN = pathlib.Path(__file__).resolve().parent / "chain.prm"


@pytest.mark.parametrize("tissue, a, stiff, soft", [
    ("liquid", 1e-13, "cap", "liquid"), ("cap", 1e10, "cap", "liquid"),
    ("septum", 1e13, "septum", "liquid"), ("liquid", 1e-99, "cap", "liquid")])
def test_is_named(tmp_path, tissue, a, stiff, soft):
    result = run(CHAIN, tmp_path / "out", [f"Tissues/{tissue}/Neo-Hooke/a={a}"])
    check_one_message(result, [
        f"Sections 'Tissues/{stiff}/Neo-Hooke' and 'Tissues/{soft}/Neo-Hooke'",
        f"the tissue '{stiff}' is ", f" times as stiff as '{soft}'",
        "bring the two closer together"])


def test_lengths_up_to_the_warning_are_those_of_rigid_caps(tmp_path):
    lengths = []
    for a in (1e5, 1e8):
        result = run_well(CHAIN, tmp_path / str(a),
                          [f"Tissues/cap/Neo-Hooke/a={a}"])
        assert ("Warning: the tissue 'cap' is" in result.log) == (a > 1e6)
        lengths.append(result.last()["length"])
    assert "Strains of the softer one are exact to about 1e-05" in result.log
    assert lengths[1] == pytest.approx(lengths[0], rel=1e-5)
