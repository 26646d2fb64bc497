# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work of muscles, loads, friction and viscosity since the start of a run, and
what is stored."""

import csv
import pathlib

import matplotlib.pyplot as plt
import numpy as np

from .arrays import Array
from .captions import no_formula
from .figures import INCHES, save
from .run_folder import RunFolder

LINES = {"stored": "-", "friction": "--", "viscosity": "--", "balance": ":"}


def read_work(file_name: pathlib.Path) -> tuple[Array, dict[tuple[str, str], Array]]:
    """The times, and for every (kind, name) the sum of the work until each."""
    with open(file_name, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    # In the order of the steps, in which the time may go back.
    place = {t: k for k, t in enumerate(dict.fromkeys(row["t"] for row in rows))}
    times = np.array([float(t) for t in place])
    sums: dict[tuple[str, str], Array] = {}
    for row in rows:
        work = sums.setdefault((row["kind"], row["name"]), np.zeros(len(times)))
        work[place[row["t"]]] += float(row["work"])
    return times, {key: np.cumsum(work) for key, work in sums.items()}


def label(kind: str, name: str) -> str:
    alone = kind in ("stored", "balance", name)
    return no_formula(kind if alone else f"{kind} {name}")


def draw_energy(run: RunFolder, file_name: pathlib.Path) -> None:
    times, sums = read_work(run.path / "energy.csv")
    figure, axes = plt.subplots(figsize=(INCHES, 3.4), layout="constrained")
    times = np.concatenate([[0.], times])
    for (kind, name), work in sums.items():
        axes.plot(times, np.concatenate([[0.], work]), LINES.get(kind, "-"),
                  linewidth=1.2 if kind == "muscle" else 0.9,
                  label=label(kind, name))
    axes.set_xlabel("time", fontsize=8)
    axes.set_ylabel("work since the start [N mm]", fontsize=8)
    axes.ticklabel_format(axis="y", scilimits=(-3, 4))
    axes.tick_params(labelsize=7)
    axes.yaxis.get_offset_text().set_fontsize(7)
    axes.grid(linewidth=0.3)
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle(run.figure_title(), fontsize=11)
    save(figure, file_name)
