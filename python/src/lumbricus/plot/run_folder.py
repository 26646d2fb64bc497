# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a run, which may still be going on: a table is read up to its
last complete line, and a time counts when all segments have their row."""

import io
import os
import pathlib
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pyvista

from .arrays import Array, Columns, Json, Series
from .body import Body
from .captions import no_formula
from .fields import read_grid, read_series
from .tables import DESCRIPTION, read_description, read_table, values_of

# What errors.csv has of each segment, with its title.
ESTIMATED = {"length": "length", "mid_radius": "radius", "fluid_pressure": "pressure",
             "middle_x": "place"}
# What its errors come from, by the end of their columns.
SOURCES = {"": "smaller cells", "_of_steps": "shorter steps",
           "_of_resets": "more resets"}


class PlotError(Exception):
    """What is wrong with the folder, and what to do: one sentence."""


def read_text(file_name: pathlib.Path) -> str:
    try:
        return file_name.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise PlotError(f"'{file_name}' cannot be read: "
                        f"{error.strerror or error}; make it readable or run "
                        "the case again.") from error


def read_complete_table(file_name: pathlib.Path) -> Columns:
    """The columns by name, without a last line that has no end yet."""
    if not file_name.exists():
        raise PlotError(f"The table '{file_name}' is missing; give the whole "
                        "output folder of a run, or run the case again.")
    text = read_text(file_name)
    text = text[:text.rfind("\n") + 1]
    lines = text.splitlines()
    if not lines:
        raise PlotError(f"The table '{file_name}' is empty; wait until the "
                        "run has written to it, or run the case again.")
    n_columns = lines[0].count(",") + 1
    for number, line in enumerate(lines, 1):
        if line.count(",") + 1 != n_columns:
            raise PlotError(
                f"Line {number} of '{file_name}' has {line.count(',') + 1} "
                f"entries instead of {n_columns}; the table is damaged, run "
                "the case again.")
    if len(lines) == 1:
        return {name: np.zeros(0) for name in lines[0].split(",")}
    return read_table(io.StringIO(text))


def check_columns(table: Columns, file_name: pathlib.Path, names: Sequence[str]) -> None:
    for name in names:
        if name not in table:
            raise PlotError(f"The table '{file_name}' has no column '{name}'; "
                            "run the case again with this version.")


class RunFolder:
    """What a run has left so far."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = pathlib.Path(path)
        self.description = self.read_description()
        try:
            self.parameters = values_of(self.description)
            self.status = self.description["status"]
            self.title = self.description["title"] or self.path.name
            self.body = Body(self.description["body"])
        except (KeyError, ValueError, TypeError) as error:
            raise PlotError(
                f"'{self.path / DESCRIPTION}' is not as this version writes it "
                f"({type(error).__name__}: {error}); run the case again."
            ) from error

        self.segments = self.table(
            "segments.csv",
            ["t", "segment", "length", "fluid_volume", "wall_volume",
             "fluid_pressure", "eta", "resets", "fluid_mesh_quality",
             "wall_mesh_quality"])
        t = self.segments["t"]
        # Of the first step only: a path may come back to its time.
        n_rows = int(np.argmax(np.append(t, np.nan) != t[0])) if len(t) else 0
        if n_rows == 0 or len(t) < 2 * n_rows:
            raise PlotError(
                f"The table '{self.path / 'segments.csv'}' has no load step "
                "yet, so that there is nothing to draw; wait for the first "
                "one, or run the case again.")
        self.n_segments = n_rows
        self.segments = self.whole_groups(self.segments)
        self.resets = self.whole_groups(self.table(
            "resets.csv", ["t", "cycle", "reset", "segment", "eta"]))
        self.steps = self.table(
            "steps.csv", ["step", "t", "cuts", "newton_iterations",
                          "elapsed_seconds"])
        self.newton = self.table(
            "newton.csv", ["step", "iteration", "force_residual",
                           "volume_residual", "increment"])
        self.mesh = self.table(
            "mesh.csv", ["step", "t", "cycle", "cells", "unknowns", "refined",
                         "coarsened", "converged", "estimated_error",
                         "volume_change", "pressure_change"])
        self.series = self.read_times("solution.pvd")
        self.obstacles = dict(self.read_times("obstacles.pvd"))
        self.contact = self.read_contact()
        self.errors = self.read_errors()

    def read_description(self) -> Json:
        file_name = self.path / DESCRIPTION
        if not file_name.exists():
            of_a_run = (self.path / "segments.csv").exists()
            raise PlotError(f"There is no '{file_name}', so that this is " + (
                "a run of an older version, which does not say what it is; run "
                "the case again with this version." if of_a_run else
                "no run; give the output folder of a run."))
        try:
            return read_description(self.path)
        except OSError as error:
            raise PlotError(f"'{file_name}' cannot be read: "
                            f"{error.strerror or error}; make it readable or "
                            "run the case again.") from error
        except ValueError as error:
            raise PlotError(f"'{file_name}' is damaged ({error}); run the case "
                            "again.") from error

    def table(self, name: str, columns: Sequence[str]) -> Columns:
        file_name = self.path / name
        table = read_complete_table(file_name)
        check_columns(table, file_name, columns)
        return table

    def whole_groups(self, table: Columns) -> Columns:
        """Without the rows of a last group that lacks some segments."""
        n = len(table["t"]) // self.n_segments * self.n_segments
        return {name: values[:n] for name, values in table.items()}

    def field(self, name: str) -> Array:
        """A column of segments.csv as [time, segment]."""
        return self.segments[name].reshape(-1, self.n_segments)

    @property
    def has_liquid(self) -> bool:
        return bool((self.field("fluid_volume") > 0).any())

    @property
    def times(self) -> Array:
        return self.segments["t"][::self.n_segments]

    @property
    def segment_numbers(self) -> Array:
        return self.segments["segment"][:self.n_segments].astype(int)

    @property
    def has_work(self) -> bool:
        """Whether there is an energy.csv, with any step."""
        file_name = self.path / "energy.csv"
        return file_name.exists() and file_name.read_text().count("\n") > 1

    def read_contact(self) -> tuple[Columns, Columns] | None:
        """contact.csv and body.csv; None where the run has no contact."""
        if not (self.path / "contact.csv").exists():
            return None
        return (self.table("contact.csv", ["t", "segment", "area", "sliding",
                                             "anchored"]),
                self.table("body.csv", ["t", "stride"]))

    def read_errors(self) -> Columns | None:
        """errors.csv; None where the run has no estimates, or none yet."""
        if not (self.path / "errors.csv").exists():
            return None
        table = self.whole_groups(self.table("errors.csv",
                                             ["t", "segment", *ESTIMATED]))
        check_columns(table, self.path / "errors.csv", [
            f"{name}_error{source}" for name in ESTIMATED for source in SOURCES
            if f"length_error{source}" in table])
        return table if len(table["t"]) else None

    def read_times(self, name: str) -> Series:
        """(time, file) of all times in a PVD file, which need not be there."""
        file_name = self.path / name
        if not file_name.exists():
            return []
        try:
            return read_series(self.path, name)
        except (ElementTree.ParseError, ValueError, OSError) as error:
            raise PlotError(f"'{file_name}' cannot be read ({error}); run the "
                            "case again.") from error

    def grid(self, pvtu_file: pathlib.Path) -> pyvista.UnstructuredGrid:
        return self.reading(pvtu_file, read_grid, pvtu_file)

    @staticmethod
    def reading(file_name: pathlib.Path, function: Callable[..., Any],
                *arguments: Any) -> Any:
        """function(*arguments), which reads file_name and what that names."""
        try:
            return function(*arguments)
        except OSError as error:
            raise PlotError(
                f"'{error.filename or file_name}' cannot be read: "
                f"{error.strerror or error}; bring the file back, start in "
                "the folder the run was started in, or run the case again."
            ) from error
        except (RuntimeError, ValueError, KeyError, IndexError,
                TypeError) as error:
            # VTK's errors have several lines.
            reason = " ".join(str(error).split())
            raise PlotError(f"'{file_name}' or a file it names is not as the "
                            f"program writes it ({reason}); bring the files "
                            "back, or run the case again.") from error

    def record(self, names: Sequence[str]) -> None:
        """Note in lumbricus.run what was drawn here, so that a fresh start of
        the run removes it with the rest."""
        file_name = self.path / "lumbricus.run"
        if not file_name.exists():
            return
        known = read_text(file_name).splitlines()
        lines = [f"file {name}\n" for name in names
                 if f"file {name}" not in known]
        with open(file_name, "a", encoding="utf-8") as file:
            file.write("".join(lines))

    def number(self, name: str) -> float | None:
        """A parameter as a number, None where there is none."""
        value = self.parameters.get(name)
        is_number = isinstance(value, (int, float)) and not isinstance(value,
                                                                       bool)
        return value if is_number else None

    def figure_title(self) -> str:
        """In which Matplotlib sees no formula."""
        return no_formula(self.title)
