# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: pictures, numbers and parameters of a run in one file."""

import json
import pathlib
from collections.abc import Iterator, Sequence
from typing import Any

from .arrays import Drawn, Json
from .defaults import that_differ
from .html_page import details, figure, heading, number, page, paragraph, table
from .run_folder import RunFolder
from .summary import Summary, adaptations

ENDS = {
    "running": "The run is going on. (It looks the same after one that was "
               "killed.)",
    "finished": "The run is done.",
    "interrupted": "The run was interrupted.",
    "failed": "The run could not go on."}


def program(run: RunFolder) -> str:
    """What computed the run."""
    made_by = run.description["program"]
    n_ranks = made_by["ranks"]
    text = (f"{made_by['name']} {made_by['version']} (deal.II "
            f"{made_by['deal_ii']}, {made_by['build_type']}), {n_ranks} "
            f"{'rank' if n_ranks == 1 else 'ranks'}")
    restart = run.description["restart"]
    if restart is not None:
        text += (f"; from time {restart['time']:g} on, until which it was "
                 f"version {restart['version']}")
    return text


def state_of_run(run: RunFolder, summary: Summary) -> str:
    return (f"{summary.n_steps} load steps to time {summary.time:g} of "
            f"{run.status['end_time']:g}, {summary.n_newton} Newton "
            f"iterations, {summary.n_cuts} cuts of a step, "
            f"{number(summary.seconds)} s. {ENDS[run.status['state']]}")


def numbers_of_segments(run: RunFolder, summary: Summary) -> str:
    columns = [
        ("liquid at rest [mm³]", summary.liquid_volume, 6),
        ("its largest relative change", summary.liquid_change, 3),
        ("wall at rest [mm³]", summary.wall_volume, 6),
        ("its largest relative change", summary.wall_change, 3),
        ("largest pressure [N/mm²]", summary.pressure, 3),
        ("largest η", summary.eta, 3),
        ("longest / shortest", summary.length_ratio, 4),
        ("least quality, liquid", summary.liquid_quality, 3),
        ("least quality, wall", summary.wall_quality, 3)]
    rows = [[segment, *(number(values[i], digits)
                        for _, values, digits in columns)]
            for i, segment in enumerate(run.segment_numbers)]
    return table(["segment", *(name for name, *_ in columns)], rows)


def numbers(run: RunFolder, summary: Summary) -> list[str]:
    tolerance = run.number("Reset/Tolerance")
    about_eta = ("" if tolerance is None else
                 f" Reset/Tolerance is {tolerance:g}.")
    return [
        heading("Numbers"),
        table(["over all segments and times", "value"],
              [(what, number(value)) for what, value in summary.worst()]),
        paragraph("Volumes are compared with those at rest; changes of about "
                  "1e-14 are round-off. η is the norm of the stress deviator "
                  "over the pressure, integrated over a segment's liquid."
                  + about_eta + " The quality of a mesh is the least scaled "
                  "Jacobian of its cells, which is 1 for bricks and 0 for a "
                  "cell that folds. Units are those of the input, taken to be "
                  "mm and N.", "note"),
        numbers_of_segments(run, summary)]


def mesh_adaptations(run: RunFolder) -> list[str]:
    rows = adaptations(run)
    content = [heading("Adaptations of the mesh")]
    if len(run.mesh["cells"]):
        content.append(paragraph(
            f"The first mesh has {run.mesh['cells'][0]:g} cells and "
            f"{run.mesh['unknowns'][0]:g} unknowns."))
    if not rows:
        return content + [paragraph("It was not adapted.")]
    content.append(table(
        ["after step", "time", "cycle", "cells", "unknowns", "cut", "merged",
         "estimated error before", "change of volume", "change of pressure",
         ""],
        [[f"{r['step']:g}", f"{r['t']:g}", f"{r['cycle']:g}",
          f"{r['cells']:.0f}", f"{r['unknowns']:.0f}", f"{r['refined']:.0f}",
          f"{r['coarsened']:.0f}", number(r["estimated_error"]),
          number(r["volume_change"]), number(r["pressure_change"]),
          "" if r["converged"] else "not converged, taken back"]
         for r in rows], text_columns=0))
    content.append(paragraph("Changes are the largest relative ones of all "
                             "segments. A cell is cut into eight.", "note"))
    return content


def times(run: RunFolder) -> list[str]:
    content = [heading("Where the time went")]
    costs = run.description["where_the_time_went"]
    if costs is None:
        return content + [paragraph("The run did not say so: it is told at "
                                    "its end.")]
    if run.description["restart"] is not None:
        content.append(paragraph("Since the last restart."))

    def rows(parts: list[Json], depth: int = 0) -> Iterator[tuple[Any, ...]]:
        for part in parts:
            yield ("\u2003" * depth + part["name"], f"{part['seconds']:.2f}",
                   f"{part['seconds'] / costs['seconds']:.0%}", part["calls"])
            yield from rows(part.get("parts", []), depth + 1)

    content.append(table(
        ["", "seconds", "share", "calls"],
        [*rows(costs["parts"]), ("total", f"{costs['seconds']:.2f}", "", "")]))
    return content + [paragraph(
        f"Peak memory of the largest rank: {costs['peak_memory_mb']:.0f} MB. "
        "Most iterations of a linear solve: "
        f"{costs['most_linear_iterations']}.", "note")]


def shown(value: Any) -> str:
    """A value of a parameter as it is written."""
    return value if isinstance(value, str) else json.dumps(value)


def all_parameters(run: RunFolder) -> list[str]:
    entries = run.description["parameters"]
    return [
        heading("Parameters"),
        paragraph("Those that differ from their defaults."),
        table(["parameter", "value", "default", "unit"],
              [(entry["path"], shown(entry["value"]),
                shown(entry["default"]) or "–", entry["unit"])
               for entry in that_differ(entries)], text_columns=4),
        details("All parameters", table(
            ["parameter", "value", "unit"],
            [(entry["path"], shown(entry["value"]), entry["unit"])
             for entry in entries], text_columns=3))]


def write_report(run: RunFolder, pictures: Sequence[Drawn], notes: Sequence[str],
                 file_name: pathlib.Path, reload_every: float | None = None) -> None:
    """Pictures are (file, title, caption); notes say what is left out. A browser
    loads the page anew every so many seconds, where they are given."""
    summary = Summary(run)
    message = run.status["message"]
    content = [
        paragraph(program(run), "note"),
        paragraph(state_of_run(run, summary)),
        *([paragraph(message)] if message else []),
        *(paragraph(note) for note in notes),
        *(figure(*picture) for picture in pictures),
        *numbers(run, summary),
        *mesh_adaptations(run),
        *times(run),
        *all_parameters(run)]
    file_name.write_text(page(run.title, content, reload_every), encoding="utf-8")
