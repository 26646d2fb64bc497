# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run has left: tables, fields, and what it says of itself."""
from __future__ import annotations

import dataclasses
import io
import json
import os
import pathlib
from typing import TYPE_CHECKING, Any, cast

import pandas as pd

from .bars import bars_of
from .case import Parameter, parameters_from
from .errors import LumbricusError

if TYPE_CHECKING:
    import pyvista

DESCRIPTION = "run.json"
# pandas 3 reads numbers as they were written, and earlier ones where they are told to.
_TO_THE_LAST_BIT: dict[str, Any] = (
    {"float_precision": "round_trip"} if int(pd.__version__.split(".")[0]) < 3 else {})


def read_description(folder: str | os.PathLike[str]) -> dict[str, Any]:
    """What is in run.json, see doc/results.md."""
    text = (pathlib.Path(folder) / DESCRIPTION).read_text(encoding="utf-8")
    return cast(dict[str, Any], json.loads(text))


@dataclasses.dataclass(frozen=True)
class Description:
    """run.json, whose members doc/results.md explains.

    Attributes:
        parameters: all parameters of the run by path.
        status: "state" ("running", "finished", "interrupted" or "failed"), "message",
            "step", "time", "end_time" [time] and "seconds" [s].
        body: "segments", "symmetry_planes" [mm], "tissues", "muscles", ...
        where_the_time_went: None until the run ends.
        further: members that a newer program has.
    """

    format: int
    program: dict[str, Any]
    title: str
    status: dict[str, Any]
    restart: dict[str, Any] | None
    body: dict[str, Any]
    boundary_conditions: list[dict[str, Any]]
    body_forces: list[dict[str, Any]]
    obstacles: list[dict[str, Any]]
    where_the_time_went: dict[str, Any] | None
    parameters: dict[str, Parameter]
    further: dict[str, Any]

    @classmethod
    def of(cls, members: dict[str, Any]) -> Description:
        """Of the object in run.json."""
        known = {field.name for field in dataclasses.fields(cls)} - {"further"}
        return cls(**{name: members[name] for name in known - {"parameters"}},
                   parameters=parameters_from(members["parameters"]),
                   further={name: value for name, value in members.items()
                            if name not in known})


class Run:
    """The folder of a run, also of one that is still going on.

    Every table there is an attribute: ``run.segments`` is segments.csv as a
    pandas.DataFrame, read anew each time; doc/results.md has all columns and units.
    ``run.tables`` lists them. ``print(run)`` says how far it has come and what it has
    estimated the errors of its mesh to be.

    Raises LumbricusError where there is no run.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = pathlib.Path(folder)
        if not (self.folder / DESCRIPTION).is_file():
            raise LumbricusError(f"There is no run in '{self.folder}'.",
                                 folder=self.folder)

    @property
    def description(self) -> Description:
        """run.json, as it is now."""
        return Description.of(read_description(self.folder))

    @property
    def tables(self) -> list[str]:
        """The names of all tables."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    def table(self, name: str) -> pd.DataFrame:
        """A table up to its last complete line. Raises AttributeError where the run has
        none of that name."""
        path = self.folder / f"{name}.csv"
        try:
            text = path.read_text(encoding="utf-8")
        except FileNotFoundError:
            raise AttributeError(
                f"The run in '{self.folder}' has no table '{name}', but "
                f"{', '.join(self.tables)}.") from None
        found: pd.DataFrame = pd.read_csv(
            io.StringIO(text[:text.rfind("\n") + 1]), **_TO_THE_LAST_BIT)
        return found

    def __getattr__(self, name: str) -> pd.DataFrame:
        if name.startswith("_") or name == "folder":
            raise AttributeError(name)
        return self.table(name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.tables]

    def __repr__(self) -> str:
        return f"Run({str(self.folder)!r})"

    def __str__(self) -> str:
        return self.summary()

    def bars(self, t: float | None = None) -> pd.DataFrame:
        """Length, radius [mm] and pressure [N/mm²] of each segment as texts, "2.216 ±
        0.004", at a time that has estimates of errors [time], by default the last one.

        Raises LumbricusError where there are none, see Output/Errors.
        """
        errors = self.errors if "errors" in self.tables else pd.DataFrame({"t": []})
        times = sorted(set(errors["t"]))
        found = times[-1:] if t is None else [
            time for time in times if abs(time - t) <= 1e-9 * max(1.0, abs(t))]
        if not found:
            raise LumbricusError(
                f"The run in '{self.folder}' has no estimates of errors"
                + ("" if t is None or not times else f" at time {t:g}, but at "
                   + ", ".join(f"{time:g}" for time in times)) + "; see Output/Errors.",
                folder=self.folder)
        return bars_of(errors[errors["t"] == found[0]]).reset_index(drop=True)

    def summary(self) -> str:
        """What the run is, how far it has come, and its numbers with error bars where
        it has estimated them."""
        description = self.description
        status, title = description.status, description.title
        text = (f"{title or self.folder.name}: {status['state']} at time "
                f"{status['time']:g} of {status['end_time']:g}, {status['step']} steps\n")
        try:
            bars = self.bars()
        except LumbricusError:
            return text
        return text + bars.to_string(index=False) + "\n"

    @property
    def log(self) -> str:
        """log.txt"""
        return (self.folder / "log.txt").read_text(encoding="utf-8")

    @property
    def times(self) -> list[float]:
        """The times that have fields [time]; they hang on Output/Every."""
        return [t for t, _ in self._series()]

    def _series(self) -> list[tuple[float, pathlib.Path]]:
        from .plot.fields import read_series
        if not (self.folder / "solution.pvd").exists():
            return []
        return read_series(self.folder)

    def mesh(self, t: float | None = None) -> pyvista.UnstructuredGrid:
        """The cells and fields at a time [time], by default the last one. The points
        are those at rest: ``mesh.warp_by_vector("displacement")`` is the deformed body.

        Raises LumbricusError where there are no fields at that time.
        """
        from .plot.fields import read_grid
        series = self._series()
        found = series[-1:] if t is None else [
            entry for entry in series if abs(entry[0] - t) <= 1e-9 * max(1.0, abs(t))]
        if not found:
            raise LumbricusError(
                (f"The run in '{self.folder}' has no fields"
                 + ("" if t is None else f" at time {t:g}")
                 + (", but at " + ", ".join(f"{time:g}" for time, _ in series)
                    if series else "; see Output/Every") + "."), folder=self.folder)
        return read_grid(found[0][1])

    def report(self) -> pathlib.Path:
        """Draw all that lumbricus-plot draws, in the folder of the run; report.html.
        Needs the packages of lumbricus[fields].

        Raises LumbricusError where there is nothing to draw yet, or not all files.
        """
        from .plot.command import draw_run
        from .plot.run_folder import PlotError
        try:
            draw_run(self.folder)
        except PlotError as error:
            raise LumbricusError(str(error), folder=self.folder) from None
        return self.folder / "report.html"
