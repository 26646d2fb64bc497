# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters and the tables in the folder of a run. Needs NumPy only."""

import pathlib
import re

import numpy as np


def read_parameters(folder):
    """The values of parameters.prm by "Section/Subsection/Name"."""
    values, path = {}, []
    text = (pathlib.Path(folder) / "parameters.prm").read_text()
    # A backslash at the end of a line joins the next to it.
    for line in re.sub(r"\\\n\s*", "", text).splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            path.append(line[len("subsection "):].strip())
        elif line == "end":
            path.pop()
        elif line.startswith("set "):
            name, _, value = line[len("set "):].partition("=")
            values["/".join(path + [name.strip()])] = value.strip()
    return values


def read_table(file_name):
    """The columns of a CSV table by name."""
    table = np.genfromtxt(file_name, delimiter=",", names=True, ndmin=1)
    return {name: table[name] for name in table.dtype.names}
