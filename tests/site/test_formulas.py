# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formulas that are written as plain text, as they are set in the site."""
import pytest
from formulas import is_formula, pieces, rendered


@pytest.mark.parametrize("plain, set_", [
    ("F = F_e G", "<i>F</i> = <i>F</i><sub><i>e</i></sub> <i>G</i>"),
    ("J^(-1/3)", "<i>J</i><sup>−1/3</sup>"),
    ("taubar", "<i>τ\u0304</i>"),
    ("I1 < 3", "<i>I</i><sub>1</sub> &lt; 3"),
    ("d2 psi/dF dp", "<i>d</i><sup>2</sup> <i>ψ</i>/<i>d</i><i>F</i> <i>d</i><i>p</i>"),
    ("mu_p x^(alpha_p/2)", "<i>μ</i><sub><i>p</i></sub> <i>x</i><sup><i>α</i>"
                           "<sub><i>p</i></sub>/2</sup>"),
    ("int_S sigma dv", "∫<sub><i>S</i></sub> <i>σ</i> <i>d</i><i>v</i>"),
    ("A_iJkL", "<i>A</i><sub>iJkL</sub>"),
    ("for all du", "for all <i>d</i><i>u</i>"),
    ("a\n  = b", "<i>a</i>\n  = <i>b</i>")])
def test_set(plain, set_):
    assert rendered(plain) == set_


def test_in_a_sentence_names_of_files_and_members_stay():
    text = ("The stretch lambda_i of F_r, in u_before of state.h and file_name, "
            "sum_p mu_p x_a^(alpha_p/2 - 1); nu = 0.5, doc/mu.md.")
    assert [part for formula, part in pieces(text) if formula] == [
        "lambda_i", "F_r", "u_before", "sum_p", "mu_p", "x_a^(alpha_p/2 - 1)", "nu"]
    assert "".join(part for _, part in pieces(text)) == text


def test_commands_are_no_formulas():
    assert is_formula("F = I + Grad u")
    assert not is_formula("lumbricus case.prm --set Time/End=0.1")
    assert not is_formula("subsection A\n  set B = 1")
    assert not is_formula("a list of words")
