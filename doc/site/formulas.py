# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formulas of the pages as they are read in books: the sources write them as plain
text, 'tau = J_v dev(taubar) + p J I', so that they are read there too."""

import html
import re

GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "eps": "ε", "eta": "η",
         "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ",
         "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ",
         "omega": "ω", "Lambda": "Λ", "Pi": "Π"}
UPRIGHT = {"Grad": "Grad", "det": "det", "dev": "dev", "tr": "tr", "exp": "exp",
           "ln": "ln", "max": "max", "min": "min", "cos": "cos", "sin": "sin",
           "cof": "cof", "int": "∫", "sum": "∑", "sqrt": "√"}
SIGNS = {"->": "→", ">=": "≥", "<=": "≤", "(.)": "⊙", "-+": "∓", "+-": "±",
         "+=": "+=", "-=": "−=", "-": "−", ":=": ":="}
TOKEN = re.compile(
    r"(?P<script>[\^_](?:\((?:[^()]|\([^()]*\))*\)|-?\w(?:(?<=[^\W\d])[^\W_]*|\d*)))"
    r"|(?P<name>[^\W\d_]+)(?P<digit>\d?)(?![^\W_])"
    r"|(?P<sign>" + "|".join(re.escape(sign) for sign in SIGNS) + ")"
    r"|(?P<other>\w+|.)", re.S)
BAR = "\u0304"
# In a sentence a formula is a Greek name, or a symbol with scripts: one letter, a Greek
# name, a letter with a bar, or a sum. Neither names of files nor of members are.
NAMES = "|".join(GREEK)
SYMBOL = rf"(?:[A-Za-z]|[A-Za-z]bar|sum|int|d?(?:{NAMES}))"
ALONE, NO_NAME_GOES_ON = r"(?<![\w/.`\-])", r"(?![\w/`\-])(?!\.\w)"
INLINE = re.compile(
    rf"{ALONE}{SYMBOL}(?:_[A-Za-z0-9]+)?\^(?:\([^()]*\)|\w+)"
    rf"|{ALONE}{SYMBOL}_[A-Za-z0-9]+{NO_NAME_GOES_ON}(?!\()"
    rf"|{ALONE}(?:{NAMES}){NO_NAME_GOES_ON}")


def symbol(name: str) -> str | None:
    """Of one letter, Greek, or with a bar: taubar, Fbar; also with a d before it."""
    if len(name) == 1:
        return f"<i>{name}</i>"
    if name in GREEK:
        return f"<i>{GREEK[name]}</i>"
    if name.endswith("bar"):
        inner = symbol(name[:-3])
        return inner and inner.replace("</i>", BAR + "</i>")
    if name[0] == "d" and len(name) > 1:
        inner = symbol(name[1:])
        return inner and "<i>d</i>" + inner
    return None


def rendered(text: str) -> str:
    """A formula as HTML; lines and blanks stay what they are."""
    found = []
    for token in TOKEN.finditer(text):
        script, name, digit, sign, other = (token[kind] for kind in (
            "script", "name", "digit", "sign", "other"))
        if script:
            tag = "sup" if script[0] == "^" else "sub"
            inner = script[1:]
            if inner.startswith("("):
                inner = inner[1:-1]
            # An index of several letters is a word, or many indices.
            found.append(f"<{tag}>{rendered(inner)}</{tag}>")
        elif name:
            # The second derivative d2.
            tag = "sup" if name == "d" else "sub"
            shown = UPRIGHT.get(name) or symbol(name) or html.escape(name)
            found.append(shown + (f"<{tag}>{digit}</{tag}>" if digit and symbol(name)
                                  else digit))
        elif sign:
            found.append(html.escape(SIGNS[sign]))
        else:
            found.append(html.escape(other))
    return "".join(found)


def pieces(text: str) -> list[tuple[bool, str]]:
    """A sentence in parts, each with whether it is a formula."""
    found, at = [], 0
    for formula in INLINE.finditer(text):
        found += [(False, text[at:formula.start()]), (True, formula[0])]
        at = formula.end()
    found.append((False, text[at:]))
    return [part for part in found if part[1]]


def is_formula(block: str) -> bool:
    """Whether an indented block is no command and no parameters."""
    return "=" in block and not re.search(r"--set|mpirun|subsection|\.sh\b|\.py\b", block)
