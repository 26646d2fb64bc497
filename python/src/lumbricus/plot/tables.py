# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the folder of a run says of itself, and its tables as arrays."""

import numpy as np

from ..results import DESCRIPTION as DESCRIPTION
from ..results import read_description as read_description


def values_of(description):
    """The values of all parameters by "Section/Subsection/Name"."""
    return {entry["path"]: entry["value"]
            for entry in description["parameters"]}


def read_parameters(folder):
    """The values of all parameters of the run in a folder."""
    return values_of(read_description(folder))


def read_table(file_name):
    """The columns of a CSV table by name."""
    table = np.genfromtxt(file_name, delimiter=",", names=True, ndmin=1)
    return {name: table[name] for name in table.dtype.names}
