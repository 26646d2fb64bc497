# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many runs of one case: side by side, each once, all in one table."""
from __future__ import annotations

import concurrent.futures
import hashlib
import itertools
import json
import os
import pathlib
import sys
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import pandas as pd

from .case import Case, text_of
from .errors import Interrupted, LumbricusError
from .results import Run
from .running import bar, run, wait_until_free

MANIFEST = "manifest.json"
TABLE = "sweep.csv"
Settings = Mapping[str, object]
Outcome = Callable[[Run], Mapping[str, object]]


def outcome(run: Run) -> dict[str, object]:
    """What a run came to, unless another function is given: the last row of body.csv,
    and length [mm], mid_radius [mm] and fluid_pressure [N/mm^2] of every segment at its
    end, as length_1, ..."""
    body = run.body.iloc[-1]
    last = run.segments
    last = last[last["t"] == last["t"].iloc[-1]]
    columns = ("length", "mid_radius", "fluid_pressure")
    return {**{str(name): value for name, value in body.items()},
            **{f"{column}_{segment:.0f}": value for column in columns
               for segment, value in zip(last["segment"], last[column], strict=True)}}


def grid(values: Mapping[str, Iterable[object]]) -> list[dict[str, object]]:
    """All combinations, the last parameter the fastest.

    >>> grid({"a": [1, 2], "b": "xy"})[1]
    {'a': 1, 'b': 'y'}
    """
    return [dict(zip(values, chosen, strict=True))
            for chosen in itertools.product(*values.values())]


class RunStore:
    """A folder of runs of one case, each in a folder named by what it computes: all
    parameters of the case and what is changed of them. What has been computed is not
    computed again, also by another process, later.

    manifest.json there has an entry for each run: settings, state ("finished" or
    "failed"), exit_code and message.
    """

    def __init__(self, case: Case, folder: str | os.PathLike[str],
                 workers: int | None = None) -> None:
        """With so many runs at a time, by default one for each core."""
        self.case = case
        self.folder = pathlib.Path(folder).absolute()
        self.workers = workers or len(os.sched_getaffinity(0))
        self._lock = threading.Lock()
        self._stop = threading.Event()
        self.folder.mkdir(parents=True, exist_ok=True)

    def key(self, settings: Settings) -> str:
        """The name of the folder for a run with these changes."""
        asked = [[name, text_of(parameter.value)]
                 for name, parameter in sorted(self.case.parameters.items())]
        changes = [[name, text_of(value)] for name, value in sorted(settings.items())]
        return hashlib.sha256(json.dumps([asked, changes]).encode()).hexdigest()[:16]

    def manifest(self) -> dict[str, dict[str, Any]]:
        """What is known of the runs, by their folders."""
        try:
            return dict(json.loads((self.folder / MANIFEST).read_text(encoding="utf-8")))
        except FileNotFoundError:
            return {}

    def _note(self, key: str, entry: dict[str, Any]) -> None:
        with self._lock:
            entries = self.manifest() | {key: entry}
            beside = self.folder / (MANIFEST + ".new")
            beside.write_text(json.dumps(entries, indent=1) + "\n", encoding="utf-8")
            # Whole or not at all.
            os.replace(beside, self.folder / MANIFEST)

    def _compute(self, settings: Settings, again: bool) -> Run | LumbricusError:
        key = self.key(settings)
        known = self.manifest().get(key)
        if known and known["state"] == "finished" and (self.folder / key).is_dir():
            return Run(self.folder / key)
        if known and known["state"] == "failed" and not again:
            return LumbricusError(known["message"], known["exit_code"],
                                  self.folder / key)
        if self._stop.is_set():
            return Interrupted("The sweep was interrupted.", 4)
        entry: dict[str, Any] = {"settings": {
            name: text_of(value) for name, value in settings.items()}}
        result: Run | LumbricusError
        try:
            wait_until_free(self.folder / key)
            result = run(self.case, self.folder / key, settings=settings,
                         progress=False, stop=self._stop)
            entry |= {"state": "finished", "exit_code": 0, "message": ""}
        except Interrupted as error:
            return error
        except LumbricusError as error:
            entry |= {"state": "failed", "exit_code": error.exit_code,
                      "message": error.message}
            result = error
        self._note(key, entry)
        return result

    def compute(self, points: Sequence[Settings], again: bool = False,
                progress: Callable[[int, int], None] | None = None
                ) -> list[Run | LumbricusError]:
        """The runs of all points in their order, with an error in the place of one that
        failed. At KeyboardInterrupt those that go on are stopped.

        Args:
            again: try those once more that have failed.
            progress: called with the number of runs that are done, and of all.
        """
        self._stop.clear()
        # Points that are the same are one run.
        unique = {self.key(point): point for point in points}
        with concurrent.futures.ThreadPoolExecutor(self.workers) as pool:
            futures = {key: pool.submit(self._compute, point, again)
                       for key, point in unique.items()}
            try:
                for n, done in enumerate(
                        concurrent.futures.as_completed(futures.values()), 1):
                    done.result()
                    if progress:
                        progress(n, len(unique))
            except BaseException:
                self._stop.set()
                raise
        return [futures[self.key(point)].result() for point in points]


def show_progress(done: int, of_all: int) -> None:
    """A bar on standard error."""
    print("\r" + bar(done, of_all).split("  t =")[0] + f"  {done} of {of_all} runs",
          end="\n" if done == of_all else "", file=sys.stderr, flush=True)


def sweep(case: Case, values: Mapping[str, Iterable[object]] | Sequence[Settings],
          folder: str | os.PathLike[str], *, workers: int | None = None,
          outcome: Outcome = outcome, again: bool = False,
          progress: bool | None = None) -> pd.DataFrame:
    """Compute a case for all combinations of values, one core a run.

        sweep(case, {"Muscles/circular/wave/Wavelength": [4, 6, 8]}, "results/waves")

    What is done is kept: a sweep that was killed, and is started again, computes what
    is missing, and one with further values only these.

    Args:
        case: what the runs have in common.
        values: of each parameter; or a list of points, each with its settings.
        folder: for all results; see RunStore.
        workers: runs at a time; as many as there are cores by default.
        outcome: what the table has of each run, a mapping of names to numbers.
        again: compute those once more that have failed.
        progress: a bar on standard error; by default on a terminal.

    Returns a row for each point: its settings, its outcome, "error" (the program's
    message, "" where there is none), "seconds" of the run and its "folder". Runs that
    failed have their row, with nan for the outcome. It is also in sweep.csv.
    """
    points = grid(values) if isinstance(values, Mapping) else [dict(p) for p in values]
    store = RunStore(case, folder, workers)
    show = sys.stderr.isatty() if progress is None else progress
    results = store.compute(points, again, show_progress if show else None)
    rows = []
    for point, result in zip(points, results, strict=True):
        row: dict[str, object] = dict(point)
        if isinstance(result, Run):
            row |= {**outcome(result), "error": "",
                    "seconds": result.description.status["seconds"]}
        else:
            row["error"] = result.message
        rows.append(row | {"folder": str(store.folder / store.key(point))})
    table = pd.DataFrame(rows)
    # What a run came to stands before how it went.
    behind = [name for name in ("error", "seconds", "folder") if name in table]
    table = table[[name for name in table if name not in behind] + behind]
    table.to_csv(store.folder / TABLE, index=False)
    return table
