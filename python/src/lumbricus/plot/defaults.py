# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parameters of a run differ from their defaults."""

import re
from typing import Any

from .arrays import Json


def equal(value: Any, default: Any) -> bool:
    """Whether two values are the same, numbers in a text by what they are
    worth."""
    def parts(text: str) -> list[float | str]:
        found: list[float | str] = []
        for part in re.split(r"[\s,;]+", text.strip()):
            try:
                found.append(float(part))
            except ValueError:
                found.append(part)
        return found

    if isinstance(value, str) and isinstance(default, str):
        return parts(value) == parts(default)
    return bool(value == default)


def that_differ(entries: list[Json]) -> list[Json]:
    """Of the parameters in run.json."""
    return [entry for entry in entries
            if not equal(entry["value"], entry["default"])]
