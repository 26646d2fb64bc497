# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run, read, sweep, fit and steer simulations of the program lumbricus.

    import lumbricus
    case = lumbricus.Case("parameters/antagonism/case.prm")
    case["Time/End"] = 0.5
    run = case.run("results/mine", ranks=2)
    run.segments                # a table of pandas
    run.mesh(0.5)               # fields of pyvista

Names are loaded when they are used: a Controller needs none of the packages that
tables and fields need.
"""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .case import Case as Case
    from .case import Parameter as Parameter
    from .controller import Controller as Controller
    from .errors import InputError as InputError
    from .errors import Interrupted as Interrupted
    from .errors import LumbricusError as LumbricusError
    from .errors import ProgramNotFound as ProgramNotFound
    from .errors import RunFailed as RunFailed
    from .fitting import Fit as Fit
    from .fitting import Target as Target
    from .fitting import Unknown as Unknown
    from .fitting import fit as fit
    from .program import find_program as find_program
    from .results import Description as Description
    from .results import Run as Run
    from .running import restart as restart
    from .running import run as run
    from .sweeping import sweep as sweep

_HOME = {
    "Case": "case", "Parameter": "case", "Controller": "controller",
    "LumbricusError": "errors", "InputError": "errors", "RunFailed": "errors",
    "Interrupted": "errors", "ProgramNotFound": "errors",
    "Fit": "fitting", "Target": "fitting", "Unknown": "fitting",
    "fit": "fitting",
    "find_program": "program", "Description": "results", "Run": "results",
    "run": "running", "restart": "running", "sweep": "sweeping",
}
__all__ = sorted(_HOME)


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'lumbricus' has no attribute '{name}'")
    return getattr(importlib.import_module(f".{_HOME[name]}", __name__), name)


def __dir__() -> list[str]:
    return __all__
