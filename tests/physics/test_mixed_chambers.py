# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chains of which some chambers are meshed and others have no cells: all come to the
same state, as far as the reset brings the liquid that is meshed."""
import json
import pathlib

import pytest
from lumbricus_run import go_on, run_well
from test_cavities import CAVITY, CHAIN, PARTS, equal, volumes_are_kept

OF_TWO = "Geometry/segment chain/Segment 2/Liquid="
TOLERANCE = "Reset/Tolerance=1e-5"
# chain.prm has measures of the second segment's own.
MIXED = {(2,): [OF_TWO + "cavity"], (1, 3): [*CAVITY, OF_TWO + "meshed"]}


@pytest.fixture(scope="module")
def pure(tmp_path_factory):
    return [run_well(CHAIN, tmp_path_factory.mktemp("pure"),
                     [*liquid, TOLERANCE]) for liquid in ([], CAVITY)]


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("cavities", MIXED)
def test_each_chamber_either_way(tmp_path, pure, cavities, ranks):
    mixed = run_well(CHAIN, tmp_path, [*MIXED[cavities], TOLERANCE], ranks)
    # Two with liquids that are meshed are off each by what its resets leave.
    for other, tolerance in zip(pure, (4e-5, 2e-5), strict=True):
        equal(mixed, other, tolerance)
    volumes_are_kept(mixed)
    # What is not meshed is not reset either.
    for row in mixed.segments():
        is_cavity = row["segment"] in cavities
        assert (row["eta"] == 0 and row["resets"] == 0) == (
            is_cavity or row["t"] == 0)
    body = json.loads((mixed.folder / "run.json").read_text())["body"]
    assert body["tissues"][0]["name"] == "liquid"
    assert not any(tissue["name"] == "cavity" for tissue in body["tissues"])


def test_restart_on_other_ranks(tmp_path):
    whole = run_well(CHAIN, tmp_path / "whole", MIXED[(2,)])
    parts = tmp_path / "parts"
    run_well(CHAIN, parts, [*MIXED[(2,)], "Time/End=0.2",
                            "Checkpoints/Steps=1"])
    equal(go_on(parts, ["Time/End=0.3"], 2), whole, 1e-9)


def test_liquid_that_slips_beside_a_cavity(tmp_path):
    """A frictionless liquid pushes as one pressure does. Only the second segment
    has liquid that could slip away; a support was looked for in all of them."""
    slip = "Interface/Coupling=slip"
    mixed = run_well(CHAIN, tmp_path / "mixed",
                     [*MIXED[(1, 3)], slip, TOLERANCE])
    cavities = run_well(CHAIN, tmp_path / "cavities", CAVITY)
    equal(mixed, cavities, 1e-3, PARTS[:-1])
    equal(mixed, cavities, 1e-2)
    volumes_are_kept(mixed)
