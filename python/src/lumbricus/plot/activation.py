# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields that say how active a muscle is, by what it does to the tissue."""

from collections.abc import Callable

from .arrays import Array

# The beginning of their names, and how active a muscle is of which they say that.
KINDS = {"active_stretch_": lambda values: 1 - values,
         "activation_": lambda values: values}


def activation_of(name: str) -> tuple[str, Callable[[Array], Array]] | None:
    """The name that the muscle has in the field of its activation, and how active it
    is as a function of the values; None of another field."""
    for prefix, active in KINDS.items():
        if name.startswith(prefix):
            return name[len(prefix):], active
    return None
