# SPDX-License-Identifier: LGPL-2.1-or-later
"""A case is what the program says it is."""
import pytest
from loaded_program import loaded_program
from lumbricus_run import SOURCE

import lumbricus

BLOCK = SOURCE / "tests" / "errors" / "block.prm"
PISTONS = SOURCE / "tests" / "physics" / "pistons.prm"
FORMULA = "Muscles/circular/expression/Formula"


def test_values_defaults_and_units():
    case = lumbricus.Case(PISTONS, program=loaded_program())
    assert case["Geometry/open cylinder/Radius"] == 3
    assert case[FORMULA] == "1 - 0.2*t"
    radius = case.parameter("Geometry/open cylinder/Radius")
    assert (radius.default, radius.unit) == (2, "mm")
    assert "Inner radius" in radius.meaning
    with pytest.raises(KeyError, match="Did you mean 'Geometry/open cylinder/Radius'"):
        case["Geometry/open cylinder/Radus"]


def test_changes_are_checked_by_the_program():
    case = lumbricus.Case(PISTONS, program=loaded_program())
    with pytest.raises(lumbricus.InputError) as unknown:
        case["Geometry/open cylinder/Radus"] = 1
    assert "Did you mean 'Geometry/open cylinder/Radius'?" in unknown.value.message
    assert unknown.value.exit_code == 1
    with pytest.raises(lumbricus.InputError, match="has to be"):
        case["Time/End"] = -1
    assert case["Time/End"] == 1 and case.settings == {}
    # Only both together are right.
    layers = {"Geometry/open cylinder/Wall layers": "circular layer, circular layer",
              "Geometry/open cylinder/Wall layer thicknesses": [0.1, 0.2]}
    with pytest.raises(lumbricus.InputError):
        case.update(dict([layers.popitem()]))
    other = case.changed({"Time/End": 0.1 + 0.2, "Output/Every": 0})
    assert other["Time/End"] == 0.1 + 0.2 and case["Time/End"] == 1
    with pytest.raises(lumbricus.InputError, match="no-such-file"):
        lumbricus.Case("no-such-file.prm", program=loaded_program())


@pytest.mark.parametrize("file", [
    PISTONS, BLOCK, SOURCE / "parameters" / "crawling" / "case.prm",
    SOURCE / "parameters" / "lumbricus_terrestris" / "case.prm"])
def test_what_is_written_is_the_case(file, tmp_path):
    case = lumbricus.Case(file, {"Time/End": 1 / 3}, loaded_program())
    again = lumbricus.Case(case.write(tmp_path / "mine.prm"), program=case.program)
    assert dict(again) == dict(case)
    assert again["Time/End"] == 1 / 3


def test_the_program_is_found(monkeypatch, tmp_path):
    assert lumbricus.find_program().name == "lumbricus"
    monkeypatch.setenv("LUMBRICUS", str(tmp_path / "none"))
    with pytest.raises(lumbricus.ProgramNotFound, match="none"):
        lumbricus.find_program()
