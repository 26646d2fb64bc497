# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: pictures, numbers and parameters of a run in one file."""

from .defaults import parameters_with_defaults, read_reference, that_differ
from .html_page import (details, figure, heading, number, page, paragraph,
                        table)
from .summary import Summary, adaptations, where_time_went


def state_of_run(run, summary, is_over):
    end = "" if summary.end is None else f" of {summary.end:g}"
    text = (f"{summary.n_steps} load steps to time {summary.time:g}{end}, "
            f"{summary.n_newton} Newton iterations, {summary.n_cuts} cuts of "
            f"a step, {number(summary.seconds)} s.")
    if not is_over:
        return (text + " The run is going on: its log has no table of times "
                "yet. (It looks the same after a run that was killed.)")
    if summary.end is not None and summary.time < summary.end * (1 - 1e-9):
        return text + " The run ended before its end; the log may say why."
    return text + " The run is done."


def numbers_of_segments(run, summary):
    columns = [
        ("liquid at rest [mm³]", summary.fluid_volume, 6),
        ("its largest relative change", summary.fluid_change, 3),
        ("wall at rest [mm³]", summary.wall_volume, 6),
        ("its largest relative change", summary.wall_change, 3),
        ("largest pressure [N/mm²]", summary.pressure, 3),
        ("largest η", summary.eta, 3),
        ("longest / shortest", summary.length_ratio, 4),
        ("least quality, liquid", summary.fluid_quality, 3),
        ("least quality, wall", summary.wall_quality, 3)]
    rows = [[segment, *(number(values[i], digits)
                        for _, values, digits in columns)]
            for i, segment in enumerate(run.segment_numbers)]
    return table(["segment", *(name for name, *_ in columns)], rows)


def numbers(run, summary):
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


def mesh_adaptations(run):
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


def times(run, rows, notes):
    content = [heading("Where the time went")]
    if not rows:
        return content + [paragraph(
            "The run is going on; the table is written at its end.")]
    if len(run.log_of_last_start()) < len(run.log):
        content.append(paragraph("Since the last restart."))
    content.append(table(
        ["", "seconds", "share", "calls"],
        [("\u2003" * depth + name, seconds, share, calls)
         for depth, name, seconds, share, calls in rows]))
    return content + [paragraph(" ".join(notes), "note")]


def all_parameters(run):
    rows = parameters_with_defaults(run.parameters, read_reference())
    content = [heading("Parameters")]
    if any(default is not None for _, _, default, _ in rows):
        content += [
            paragraph("Those that differ from their defaults in "
                      "doc/parameters.md, and those that have no default "
                      "there."),
            table(["parameter", "value", "default", "unit"],
                  [(name, value, "–" if default is None else default,
                    unit or "")
                   for name, value, default, unit in that_differ(rows)],
                  text_columns=4)]
    else:
        content.append(paragraph("The defaults are not known here, as "
                                 "doc/parameters.md was not found."))
    content.append(details("All parameters", table(
        ["parameter", "value"], [row[:2] for row in rows], text_columns=2)))
    return content


def write_report(run, pictures, notes, file_name):
    """Pictures are (file, title, caption); notes say what is left out."""
    summary = Summary(run)
    time_rows, time_notes = where_time_went(run)
    versions = run.versions() or ["The log does not name the version."]
    content = [
        paragraph("; ".join(versions), "note"),
        paragraph(state_of_run(run, summary, bool(time_rows))),
        *(paragraph(note) for note in notes),
        *(figure(*picture) for picture in pictures),
        *numbers(run, summary),
        *mesh_adaptations(run),
        *times(run, time_rows, time_notes),
        *all_parameters(run)]
    file_name.write_text(page(run.title, content), encoding="utf-8")
