# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find parameters of a case from what was measured, and say what cannot be found.

With the unknowns x, their scales s, the numbers y(x) of a run, what was measured m and
its standard errors e, least squares of r_i = (y_i - m_i)/e_i are taken. Of the scaled
Jacobian J_ij = s_j/e_i dy_i/dx_j = sum_k u_ik w_k v_jk every combination v_k of the
unknowns is known to 1/w_k of their scales: where that is more than a half the unknowns
in it cannot be told apart.
"""
from __future__ import annotations

import dataclasses
import math
import os
import statistics
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
import pandas as pd
from scipy.optimize import least_squares

from .case import Case
from .errors import LumbricusError
from .results import Run
from .sweeping import RunStore

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Vector = npt.NDArray[np.float64]
UNKNOWN_TO = 0.5     # of the scales: a combination that is not known better
TAKES_PART = 0.1     # of a unit vector: an unknown that belongs to a combination
LARGEST_STEP = 0.03  # of differences, relative to the scale
OF_A_FAILED_RUN = 1e6  # residuals of a trial that has no equilibrium
PRECISION = 1e-9
GRADIENT = 1e-6      # the same part of what unknowns are uncertain by, or less


@dataclasses.dataclass(frozen=True)
class Unknown:
    """A number to be found.

    Attributes:
        name: the path of a parameter; with settings, any name.
        start: where to begin.
        low, high: between which it lies.
        settings: what a value sets, where it is more than the parameter of that name:
            ``lambda c: {"Muscles/circular/expression/Formula": f"1 - (1 - {c!r})*t"}``.
        scale: by how much it may well be wrong; the size of start by default.
    """

    name: str
    start: float
    low: float = -np.inf
    high: float = np.inf
    settings: Callable[[float], Mapping[str, object]] | None = None
    scale: float | None = None

    def size(self) -> float:
        """The scale. Raises ValueError where start is 0 and there is none."""
        size = abs(self.start) if self.scale is None else self.scale
        if size <= 0:
            raise ValueError(f"The unknown '{self.name}' needs a scale > 0.")
        return size

    def set_to(self, value: float) -> Mapping[str, object]:
        """The settings for a value."""
        return {self.name: value} if self.settings is None else self.settings(value)


@dataclasses.dataclass(frozen=True)
class Target:
    """What was measured.

    Attributes:
        name: of one's own.
        of_run: the same of a run: one number, or an array as long as value.
        value: what was measured.
        error: its standard error; a hundredth of the largest value by default.
    """

    name: str
    of_run: Callable[[Run], npt.ArrayLike]
    value: npt.ArrayLike
    error: npt.ArrayLike | None = None

    def values(self) -> Vector:
        """What was measured, as a vector."""
        return np.atleast_1d(np.asarray(self.value, dtype=float))

    def errors(self) -> Vector:
        """Standard errors. Raises ValueError where they are not > 0."""
        values = self.values()
        error = 0.01 * np.abs(values).max() if self.error is None else self.error
        errors = np.broadcast_to(np.asarray(error, dtype=float), values.shape)
        if not (errors > 0).all():
            raise ValueError(f"The target '{self.name}' needs an error > 0.")
        return np.array(errors)


@dataclasses.dataclass(frozen=True)
class Fit:
    """What was found.

    Attributes:
        values: of the unknowns, by name.
        jacobian: dy_i/dx_j, a row for each number of a target, a column for each unknown.
        uncertainty: standard errors of the unknowns, from those of the targets; inf where
            an unknown cannot be found.
        combinations: a row for each right singular vector of the scaled Jacobian, the
            best known first: its parts in the unknowns, in their scales, and "known to",
            how well it is known in these.
        targets: "measured", "error" and "found" of each number.
        runs: that were asked for.
    """

    values: pd.Series[float]
    jacobian: pd.DataFrame
    uncertainty: pd.Series[float]
    combinations: pd.DataFrame
    targets: pd.DataFrame
    runs: int

    @property
    def cannot_be_told_apart(self) -> list[list[str]]:
        """The unknowns of each combination that is not known to half of their scales;
        a single one cannot be found at all."""
        return [[str(name) for name in self.values.index
                 if abs(float(row[name])) > TAKES_PART]
                for _, row in self.combinations.iterrows()
                if float(row["known to"]) > UNKNOWN_TO]

    def intervals(self, level: float = 0.95) -> pd.DataFrame:
        """Between which the unknowns are with that probability, "low" and "high", where
        errors are normal and small."""
        half = self.uncertainty * statistics.NormalDist().inv_cdf(0.5 + 0.5 * level)
        return pd.DataFrame({"low": self.values - half, "high": self.values + half})

    def report(self) -> str:
        """Values, 95 % intervals, the Jacobian, and what cannot be told apart."""
        found = pd.concat([self.values.rename("value"), self.intervals()], axis=1)
        lines = [f"Found in {self.runs} runs, with 95 % intervals:", found.to_string(),
                 "", "Targets:", self.targets.to_string(),
                 "", "Jacobian:", self.jacobian.to_string(),
                 "", "Combinations, in the scales of the unknowns:",
                 self.combinations.to_string(), ""]
        for names in self.cannot_be_told_apart:
            lines.append(
                f"'{names[0]}' cannot be found from these targets." if len(names) == 1
                else f"{' and '.join(repr(name) for name in names)} cannot be told apart "
                "by these targets.")
        return "\n".join(lines)

    def plot(self) -> Figure:
        """Left what was measured and what was found, in standard errors of the targets;
        right the combinations of unknowns and how well they are known."""
        from matplotlib.figure import Figure
        figure = Figure(figsize=(9, 3.6), layout="constrained")
        left, right = figure.subplots(1, 2)
        names = [str(name) for name in self.targets.index]
        off = (self.targets["found"] - self.targets["measured"]) / self.targets["error"]
        left.axhspan(-1, 1, color="0.9")
        left.plot(range(len(names)), off.to_numpy(), "o")
        left.set_xticks(range(len(names)), names, rotation=30, ha="right")
        left.set_ylabel("found less measured, in standard errors")
        unknowns = [str(name) for name in self.values.index]
        parts = self.combinations[unknowns].to_numpy()
        image = right.imshow(parts, cmap="RdBu", vmin=-1, vmax=1, aspect="auto")
        right.set_xticks(range(len(unknowns)), [n.split("/")[-1] for n in unknowns])
        right.set_yticks(range(len(parts)), [f"known to {known:.1e}" for known
                                             in self.combinations["known to"]])
        right.set_title("combinations, in scales of the unknowns", fontsize=10)
        figure.colorbar(image, ax=right)
        return figure


def step_for(run: Run) -> float:
    """Of central differences, relative to the scale of an unknown: the cube root of what
    a run's numbers are exact to, which is the tolerance of resets where a liquid is
    meshed and else that of Newton's method."""
    description = run.description
    resets = any(tissue["liquid"] and tissue["law"] for tissue
                 in description.body["tissues"])
    name = "Reset/Tolerance" if resets else "Newton/Force tolerance"
    tolerance = float(description.parameters[name].value)
    return min(LARGEST_STEP, math.cbrt(tolerance))


class _Problem:
    """Residuals and their Jacobian in scaled unknowns z = x/s, by runs."""

    def __init__(self, store: RunStore, unknowns: Sequence[Unknown],
                 targets: Sequence[Target], step: float | None) -> None:
        self.store, self.step = store, step
        self.unknowns, self.targets = unknowns, targets
        self.scales = np.array([unknown.size() for unknown in unknowns])
        self.measured = np.concatenate([target.values() for target in targets])
        self.errors = np.concatenate([target.errors() for target in targets])
        self.low = np.array([unknown.low for unknown in unknowns]) / self.scales
        self.high = np.array([unknown.high for unknown in unknowns]) / self.scales
        self.n_runs = 0

    def runs(self, points: Sequence[Vector]) -> list[Run | LumbricusError]:
        self.n_runs += len(points)
        return self.store.compute([
            {name: value for unknown, x
             in zip(self.unknowns, (z * self.scales).tolist(), strict=True)
             for name, value in unknown.set_to(x).items()} for z in points])

    def numbers(self, run: Run) -> Vector:
        found = []
        for target in self.targets:
            one = np.atleast_1d(np.asarray(target.of_run(run), dtype=float))
            if one.shape != target.values().shape:
                raise ValueError(f"The target '{target.name}' has {target.values().size} "
                                 f"values, and a run {one.size}.")
            found.append(one)
        return np.concatenate(found)

    def residuals(self, z: Vector) -> Vector:
        run, = self.runs([z])
        if isinstance(run, Run):
            return np.asarray((self.numbers(run) - self.measured) / self.errors)
        if run.exit_code != 2:
            raise run
        return np.full(self.measured.shape, OF_A_FAILED_RUN)

    def jacobian(self, z: Vector) -> Vector:
        assert self.step is not None
        points = []
        for j in range(len(z)):
            for side in (-self.step, self.step):
                point = z.copy()
                point[j] = np.clip(point[j] + side, self.low[j], self.high[j])
                points.append(point)
        numbers = []
        for run in self.runs(points):
            if not isinstance(run, Run):
                raise run
            numbers.append(self.numbers(run))
        columns = [(numbers[2 * j + 1] - numbers[2 * j])
                   / (points[2 * j + 1][j] - points[2 * j][j]) / self.errors
                   for j in range(len(z))]
        return np.stack(columns, axis=1)


def fit(case: Case, unknowns: Sequence[Unknown], targets: Sequence[Target],
        folder: str | os.PathLike[str], *, workers: int | None = None,
        step: float | None = None) -> Fit:
    """Find the unknowns with which runs of a case come nearest to the targets.

    Derivatives are central differences, whose runs go side by side. Runs are kept in
    the folder, as those of a sweep: a fit that is started again finds them there.

    Args:
        step: of the differences, relative to the scales; step_for() by default.

    Raises LumbricusError where a run fails that has to go well, ValueError where
    scales, errors or shapes are wrong.
    """
    problem = _Problem(RunStore(case, folder, workers), unknowns, targets, step)
    start = np.array([unknown.start for unknown in unknowns]) / problem.scales
    first, = problem.runs([start])
    if not isinstance(first, Run):
        raise first
    problem.step = step or step_for(first)
    found = least_squares(problem.residuals, start, jac=problem.jacobian,
                          bounds=(problem.low, problem.high), ftol=PRECISION,
                          xtol=PRECISION, gtol=GRADIENT)
    return _result(problem, np.asarray(found.x), np.asarray(found.fun))


def _result(problem: _Problem, z: Vector, residuals: Vector) -> Fit:
    scaled = problem.jacobian(z)
    names = pd.Index([unknown.name for unknown in problem.unknowns])
    rows = pd.Index([target.name + (f" {i + 1}" if target.values().size > 1 else "")
                     for target in problem.targets
                     for i in range(target.values().size)])
    _, w, v = np.linalg.svd(scaled, full_matrices=True)
    # Of fewer numbers than unknowns, some combinations are not seen at all.
    w = np.concatenate([w, np.zeros(len(v) - len(w))])
    # Nor are those below what differences can tell.
    assert problem.step is not None
    w[w < w.max() * problem.step**2] = 0
    with np.errstate(divide="ignore", invalid="ignore"):
        known_to = 1 / w
        parts = np.where(v == 0, 0, v * known_to[:, None])
    combinations = pd.DataFrame(v, columns=names)
    combinations["known to"] = known_to
    return Fit(
        values=pd.Series(z * problem.scales, index=names),
        jacobian=pd.DataFrame(scaled * problem.errors[:, None] / problem.scales,
                              index=rows, columns=names),
        uncertainty=pd.Series(np.sqrt((parts**2).sum(axis=0)) * problem.scales,
                              index=names),
        combinations=combinations,
        targets=pd.DataFrame({
            "measured": problem.measured, "error": problem.errors,
            "found": problem.measured + residuals * problem.errors}, index=rows),
        runs=problem.n_runs)
