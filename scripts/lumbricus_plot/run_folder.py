# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of a run, which may still be going on: a table is read up to its
last complete line, and a time counts when all segments have their row."""

import io
import pathlib
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from .body import Body
from .captions import no_formula
from .fields import read_grid, read_series
from .tables import read_parameters, read_table


class PlotError(Exception):
    """What is wrong with the folder, and what to do: one sentence."""


def read_text(file_name):
    try:
        return file_name.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise PlotError(f"'{file_name}' cannot be read: "
                        f"{error.strerror or error}; make it readable or run "
                        "the case again.") from error


def read_complete_table(file_name):
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


def check_columns(table, file_name, names):
    for name in names:
        if name not in table:
            raise PlotError(f"The table '{file_name}' has no column '{name}'; "
                            "run the case again with this version.")


class RunFolder:
    """What a run has left so far."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        parameter_file = self.path / "parameters.prm"
        if not parameter_file.exists():
            raise PlotError(f"There is no '{parameter_file}', so that this is "
                            "no run; give the output folder of a run.")
        try:
            self.parameters = read_parameters(self.path)
        except (OSError, ValueError, IndexError) as error:
            raise PlotError(f"'{parameter_file}' cannot be read ({error}); "
                            "run the case again.") from error
        self.title = self.parameters.get("Title", "") or self.path.name

        self.segments = self.table(
            "segments.csv",
            ["t", "segment", "length", "fluid_volume", "wall_volume",
             "fluid_pressure", "eta", "resets", "fluid_mesh_quality",
             "wall_mesh_quality"])
        t = self.segments["t"]
        n_rows = int(np.sum(t == t[0])) if len(t) else 0
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
        log_file = self.path / "log.txt"
        if not log_file.exists():
            raise PlotError(f"There is no '{log_file}', so that this is no "
                            "whole run; give the output folder of a run.")
        self.log = read_text(log_file)
        self.series = self.read_times()

    def table(self, name, columns):
        file_name = self.path / name
        table = read_complete_table(file_name)
        check_columns(table, file_name, columns)
        return table

    def whole_groups(self, table):
        """Without the rows of a last group that lacks some segments."""
        n = len(table["t"]) // self.n_segments * self.n_segments
        return {name: values[:n] for name, values in table.items()}

    def field(self, name):
        """A column of segments.csv as [time, segment]."""
        return self.segments[name].reshape(-1, self.n_segments)

    @property
    def has_liquid(self):
        return bool((self.field("fluid_volume") > 0).any())

    @property
    def times(self):
        return self.segments["t"][::self.n_segments]

    @property
    def segment_numbers(self):
        return self.segments["segment"][:self.n_segments].astype(int)

    def read_times(self):
        """(time, PVTU file) of all times that have fields."""
        file_name = self.path / "solution.pvd"
        if not file_name.exists():
            return []
        try:
            return read_series(self.path)
        except (ElementTree.ParseError, ValueError, OSError) as error:
            raise PlotError(f"'{file_name}' cannot be read ({error}); run the "
                            "case again.") from error

    def grid(self, pvtu_file):
        return self.reading(pvtu_file, read_grid, pvtu_file)

    def body(self):
        return self.reading(self.path / "parameters.prm", Body,
                            self.parameters)

    @staticmethod
    def reading(file_name, function, *arguments):
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

    def record(self, names):
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

    def number(self, name):
        """A parameter as a number, None where there is none."""
        try:
            return float(self.parameters[name])
        except (KeyError, ValueError):
            return None

    def figure_title(self):
        """In which Matplotlib sees no formula."""
        return no_formula(self.title)

    def versions(self):
        """The first lines of the log, and of what restarts added to it."""
        return list(dict.fromkeys(re.findall(r"^lumbricus \S.*$", self.log,
                                             re.M)))

    def log_of_last_start(self):
        """The log without what a run has said before it was restarted."""
        return re.split(r"^(?=lumbricus \S)", self.log, flags=re.M)[-1]
