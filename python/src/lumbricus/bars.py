# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers with their error bars, as people write them."""
from __future__ import annotations

import math

import pandas as pd

ERROR = "_error"
ROUND_OFF = 1e-10  # of the value


def with_bar(value: float, error: float) -> str:
    """The value ± the size of its error, which has two digits: the value ends with the
    same one. A value without a finite error has six digits, and no bar; one whose error
    is round-off, ten.

    >>> with_bar(2.21571573, 0.00371022)
    '2.2157 ± 0.0037'
    """
    size = abs(error)
    if not (math.isfinite(value) and math.isfinite(size)):
        return f"{value:.6g}"
    if size < ROUND_OFF * abs(value) or size == 0:
        return f"{value:.10g} ± {size:.1g}"
    # Of the error as it is rounded: 0.0996 is 0.10.
    digits = 1 - math.floor(math.log10(float(f"{size:.1e}")))
    larger = max(size, abs(value))
    if 1e-4 <= larger < 1e6 and 0 <= digits <= 12:
        return f"{value:.{digits}f} ± {size:.{digits}f}"
    power = math.floor(math.log10(larger))
    digits = max(0, digits + power)
    value, size = value / 10**power, size / 10**power
    return f"({value:.{digits}f} ± {size:.{digits}f})e{power:+03d}"


def bars_of(errors: pd.DataFrame) -> pd.DataFrame:
    """errors.csv with a text for each number that has a column of its error."""
    columns: dict[str, object] = {}
    for name in map(str, errors):
        error = errors.get(name + ERROR)
        if error is not None:
            columns[name] = list(map(with_bar, errors[name], error))
        elif not name.endswith(ERROR):
            columns[name] = errors[name].to_list()
    return pd.DataFrame(columns)
