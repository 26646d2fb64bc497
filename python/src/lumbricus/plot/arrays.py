# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of what goes from one module to another."""


import pathlib
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[Any]
Columns: TypeAlias = dict[str, Array]
"""Of a table, by their names."""
Series: TypeAlias = list[tuple[float, pathlib.Path]]
"""Times, and the file with the fields of each."""
Json: TypeAlias = dict[str, Any]
"""An object in run.json."""
Drawn: TypeAlias = tuple[pathlib.Path, str, str]
"""A file, its title and its caption."""
Number: TypeAlias = float | np.floating[Any]
