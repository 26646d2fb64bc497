# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command lumbricus-plot."""

import argparse
import pathlib
import sys

from picture import draw_table

from .animation import animate, find_ffmpeg
from .convergence import draw_convergence
from .kymograph import draw_kymograph
from .report import write_report
from .run_folder import PlotError, RunFolder

DESCRIPTION = """\
Draw a run and write a report of it. RUN_DIR, the output folder of a run that
is over or still going on, gets

  animation.gif    the deforming body, cut open: liquid coloured by pressure,
                   muscle by active contraction
  kymograph.png    length, pressure and activation, segments against time
  segments.png     length, radius, pressure and volume of every segment
  convergence.png  resets, divergence after each, residuals of Newton's method
  report.html      all of these in one file, with numbers and parameters

Exit code 1 says that the folder is no run, or that something in it is missing.
"""


def positive(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


positive.__name__ = "positive whole number"


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="lumbricus-plot", description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="RUN_DIR",
                        help="the output folder of a run")
    parser.add_argument("--frames", type=positive, default=40, metavar="N",
                        help="most frames of the animation, evenly spaced in "
                        "time (default: 40)")
    parser.add_argument("--fibres", action="store_true",
                        help="draw the fibres of the muscles on the cut")
    parser.add_argument("--mp4", action="store_true",
                        help="write animation.mp4 instead of the GIF; needs "
                        "ffmpeg")
    parser.add_argument("--output", metavar="DIR",
                        help="write to this folder (default: RUN_DIR)")
    return parser.parse_args(arguments)


def animation_caption(times, with_fibres):
    when = (f"Time t = {times[0]:g}." if len(times) == 1 else
            f"{len(times)} times from t = {times[0]:g} to t = {times[-1]:g}.")
    text = (when + " The body is cut open along its axis (a block where it is "
            "symmetric), the head on the left, at true scale. Liquid is coloured by its pressure [N/mm²], muscle "
            "by its active contraction: by how much [%] the most active "
            "fibres want to be shorter than at rest. View and colours are "
            "the same at all times.")
    if with_fibres:
        text += (" Green lines are fibres in the plane of the cut, green dots "
                 "fibres that cross it.")
    return text


KYMOGRAPH = (
    "Segments downwards, the head at the top; time to the right. Length "
    "relative to rest [-]: red is shorter, blue longer.")
PRESSURE = " Pressure of the liquid [N/mm²], positive in compression."
ACTIVATION = (
    " Activation: for every muscle the mean active stretch [-] over the cells "
    "of a segment that have its fibres, at the times that have fields; less "
    "than 1 (dark) is a contraction, grey a segment without that muscle.")
SEGMENTS = (
    "Length [mm] and radius in the middle [mm], pressure [N/mm²] and relative "
    "change of the volume [-] of the liquid (of the wall where there is none) "
    "in every segment against time.")
CONVERGENCE = (
    "Top: how often liquid was reset, in any segment, in each load step with "
    "the adaptations that follow it, and how often a step was cut. Middle: the "
    "largest divergence η [-] from the hydrostatic state of all segments, "
    "after every solve; where a segment is above the tolerance it is reset "
    "and all is solved again. Bottom: residuals and increments [-] of Newton's "
    "method, a line for every solve, coloured by its load step. The residuals "
    "of a solve have to come below their tolerances; of the increment, what is "
    "estimated to be still to come has to, so that lines may end above it. "
    "Dashed lines are the tolerances of this run.")


def make_all(run, arguments, ffmpeg):
    """Write all files and return their names."""
    out = pathlib.Path(arguments.output or arguments.folder)
    out.mkdir(parents=True, exist_ok=True)
    pictures, notes = [], []

    if run.series:
        name = out / ("animation.gif" if ffmpeg is None else "animation.mp4")
        times = animate(run, arguments.frames, arguments.fibres, name, ffmpeg)
        pictures.append((name, "The deforming body",
                         animation_caption(times, arguments.fibres)))
    else:
        notes.append("There are no fields yet (no solution.pvd, or no time in "
                     "it), and therefore no animation and no activation; "
                     "Output/Every says how often fields are written.")

    name = out / "kymograph.png"
    has_activation = draw_kymograph(run, name)
    pictures.append((name, "Kymograph", KYMOGRAPH
                     + (PRESSURE if run.has_liquid else "")
                     + (ACTIVATION if has_activation else "")))
    name = out / "segments.png"
    draw_table(run.segments, run.figure_parameters(), name)
    pictures.append((name, "Segments", SEGMENTS))
    name = out / "convergence.png"
    draw_convergence(run, name)
    pictures.append((name, "Convergence", CONVERGENCE))

    write_report(run, pictures, notes, out / "report.html")
    return out, [*(file.name for file, *_ in pictures), "report.html"], notes


def main(arguments=None):
    arguments = parse(arguments)
    try:
        # Before anything takes time.
        ffmpeg = find_ffmpeg() if arguments.mp4 else None
        out, names, notes = make_all(RunFolder(arguments.folder), arguments,
                                     ffmpeg)
    except PlotError as error:
        print(f"lumbricus-plot: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"lumbricus-plot: '{error.filename}' cannot be written: "
              f"{error.strerror}; choose another folder with --output.",
              file=sys.stderr)
        return 1
    for note in notes:
        print(note)
    print(f"Wrote {', '.join(names[:-1])} and {names[-1]} to {out}")
    return 0
