# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the folder of a run says of itself, and its tables as arrays."""

import os
from typing import Any

import numpy as np

from ..results import DESCRIPTION as DESCRIPTION
from ..results import read_description as read_description
from .arrays import Columns, Json


def values_of(description: Json) -> dict[str, Any]:
    """The values of all parameters by "Section/Subsection/Name"."""
    return {entry["path"]: entry["value"]
            for entry in description["parameters"]}


def read_parameters(folder: str | os.PathLike[str]) -> dict[str, Any]:
    """The values of all parameters of the run in a folder."""
    return values_of(read_description(folder))


def read_table(file_name: Any) -> Columns:
    """The columns of a CSV table by name."""
    table = np.genfromtxt(file_name, delimiter=",", names=True, ndmin=1)
    return {name: table[name] for name in table.dtype.names or ()}
