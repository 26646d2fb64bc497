# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command lumbricus-plot."""

import argparse
import os
import pathlib
import sys
import tempfile
from collections.abc import Sequence

from . import captions
from .anchors import draw_anchors
from .animation import animate
from .arrays import Drawn
from .convergence import draw_convergence
from .energy import draw_energy
from .errors import draw_errors
from .kymograph import draw_kymograph
from .panels import draw_picture, draw_thumbnail
from .report import write_report
from .run_folder import PlotError, RunFolder
from .segments import draw_segments
from .viewer.page import write_scene
from .watching import state_of, watch

DESCRIPTION = """\
Draw a run and write a report of it. RUN_DIR, the output folder of a run that
is over or still going on, gets

  animation.gif    the deforming body, cut open: liquid coloured by pressure,
                   muscle by active contraction
  scene.html       the same body in a browser, to be turned and played, in one
                   file that needs no network
  picture.png      the same at a few times in one figure
  kymograph.png    length, pressure and activation, segments against time
  anchors.png      which segments are anchored, and how far the body has come;
                   of a run with a contact
  energy.png       the work of muscles, loads and friction, and what is
                   stored; of a run with Output/Energy
  errors.png       by how much the numbers of segments are off since cells are as
                   large and steps as long as they are; of a run with Output/Errors,
                   Errors of steps or Errors of resets
  segments.png     length, radius, pressure and volume of every segment
  convergence.png  resets, divergence after each, residuals of Newton's method
  report.html      all of these but picture.png in one file, with numbers and
                   parameters

With --watch all of it is drawn anew while the run goes on, and a last time when
it has ended; in a browser, report.html then shows the newest by itself. Files are
replaced as a whole, so that whoever reads them never sees half of one.

Exit code 1 says that the folder is no run, or that something in it is missing.
"""
WATCH_EVERY = 10  # seconds
NAMES = ["animation", "scene", "picture", "kymograph", "anchors", "energy", "errors",
         "segments", "convergence", "report"]


def positive(text: str) -> int:
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def seconds(text: str) -> float:
    value = float(text)
    if not 0 < value < float("inf"):
        raise ValueError
    return value


seconds.__name__ = "positive number of seconds"
positive.__name__ = "positive whole number"


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="lumbricus-plot", description=DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="RUN_DIR",
                        help="the output folder of a run")
    parser.add_argument("--only", choices=NAMES, nargs="+", default=NAMES,
                        metavar="NAME", help="make only these: "
                        + ", ".join(NAMES) + "; a report then has only these "
                        "pictures")
    parser.add_argument("--output", metavar="DIR",
                        help="write to this folder (default: RUN_DIR)")
    parser.add_argument("--watch", type=seconds, nargs="?", const=WATCH_EVERY,
                        metavar="SECONDS", help="draw again whenever the run has "
                        "something new, but not more often than that (default: "
                        f"{WATCH_EVERY}), until it ends; wait for it where it has "
                        "not begun yet")
    bodies = parser.add_argument_group("bodies")
    bodies.add_argument("--fibres", action="store_true",
                        help="draw the fibres of the muscles")
    bodies.add_argument("--mesh", action="store_true",
                        help="draw the cells on the cut")
    bodies.add_argument("--thumbnail", type=float, metavar="T",
                        help="write only thumbnail.png, the body at time T in "
                        "240 x 150 dots, without words")
    film = parser.add_argument_group("animation")
    film.add_argument("--frames", type=positive, default=40, metavar="N",
                      help="most frames, evenly spaced in time (default: 40)")
    film.add_argument("--mp4", action="store_true",
                      help="write animation.mp4 instead of the GIF")
    picture = parser.add_argument_group("picture.png")
    picture.add_argument("--times", type=float, nargs="+", default=[],
                         metavar="T", help="times to show (default: evenly "
                         "spaced ones)")
    picture.add_argument("--count", type=positive, default=6, metavar="N",
                         help="how many evenly spaced times (default: 6)")
    picture.add_argument("--columns", type=positive, default=0, metavar="N",
                         help="bodies side by side (default: as fits)")
    return parser.parse_args(arguments)


def make_animation(run: RunFolder, options: argparse.Namespace,
                   out: pathlib.Path) -> Drawn:
    name = out / ("animation.mp4" if options.mp4 else "animation.gif")
    times = animate(run, options, name)
    return name, "The deforming body", captions.animation_caption(
        times, options.fibres, bool(run.obstacles))


def make_scene(run: RunFolder, options: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "scene.html"
    return name, "A scene to be turned", write_scene(run, options, name)


def make_kymograph(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "kymograph.png"
    has_activation = draw_kymograph(run, name)
    return name, "Kymograph", (
        captions.KYMOGRAPH + (captions.PRESSURE if run.has_liquid else "")
        + (captions.ACTIVATION if has_activation else ""))


def make_anchors(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "anchors.png"
    draw_anchors(run, name)
    return name, "Anchored segments", captions.ANCHORS


def make_energy(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "energy.png"
    draw_energy(run, name)
    return name, "Energy", captions.ENERGY


def make_errors(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "errors.png"
    draw_errors(run, name)
    return name, "Estimated errors", captions.ERRORS


def make_segments(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "segments.png"
    draw_segments(run, name)
    return name, "Segments", captions.SEGMENTS


def make_convergence(run: RunFolder, _: argparse.Namespace, out: pathlib.Path) -> Drawn:
    name = out / "convergence.png"
    draw_convergence(run, name)
    return name, "Convergence", captions.CONVERGENCE


# In the order of the report.
OF_THE_REPORT = {"animation": make_animation, "scene": make_scene,
                 "kymograph": make_kymograph,
                 "anchors": make_anchors, "energy": make_energy, "errors": make_errors,
                 "segments": make_segments, "convergence": make_convergence}
NEED_FIELDS = {"animation", "picture", "scene"}


def make_all(run: RunFolder, options: argparse.Namespace,
             out: pathlib.Path) -> tuple[list[str], list[str]]:
    """Write what is wanted; the names of the files, and notes."""
    wanted, names, notes = set(options.only), [], []
    if not run.series and wanted & NEED_FIELDS:
        wanted -= NEED_FIELDS
        notes.append("There are no fields yet (no solution.pvd, or no time in "
                     "it), and therefore no animation, no scene, no "
                     "picture and no activation; Output/Every says how often fields are "
                     "written.")
    if run.contact is None:
        wanted.discard("anchors")
    if not run.has_work:
        wanted.discard("energy")
    if run.errors is None:
        wanted.discard("errors")
    pictures = [make(run, options, out)
                for name, make in OF_THE_REPORT.items() if name in wanted]
    names = [file.name for file, *_ in pictures]
    if "picture" in wanted:
        draw_picture(run, options, out / "picture.png")
        names.append("picture.png")
    if "report" in wanted:
        write_report(run, pictures, notes, out / "report.html",
                     options.reload_every)
        names.append("report.html")
    return names, notes


def make_thumbnail(run: RunFolder, options: argparse.Namespace,
                   out: pathlib.Path) -> tuple[list[str], list[str]]:
    if not run.series:
        raise PlotError(f"'{run.path}' has no fields yet, and a thumbnail "
                        "needs them; wait for the first ones.")
    draw_thumbnail(run, options, out / "thumbnail.png")
    return ["thumbnail.png"], []


def draw(options: argparse.Namespace,
         state: str = "finished") -> tuple[pathlib.Path, list[str], list[str]]:
    """Draw what there is, in a folder beside, and put all in its place: this folder,
    the names of the files, and notes."""
    options.reload_every = options.watch if state == "running" else None
    run = RunFolder(options.folder)
    out = pathlib.Path(options.output or options.folder)
    out.mkdir(parents=True, exist_ok=True)
    make = make_all if options.thumbnail is None else make_thumbnail
    with tempfile.TemporaryDirectory(dir=out, prefix=".lumbricus-plot-") as beside:
        names, notes = make(run, options, pathlib.Path(beside))
        if out.samefile(run.path):
            run.record(names)
        for name in names:
            os.replace(pathlib.Path(beside) / name, out / name)
    return out, names, notes


def draw_run(folder: str | os.PathLike[str]) -> None:
    """All that the command draws with its defaults, without a word."""
    draw(parse([str(folder)]))


def draw_and_say(options: argparse.Namespace, state: str = "finished") -> None:
    out, names, notes = draw(options, state)
    for note in notes:
        print(note)
    if names:
        print(f"Wrote {', '.join(names)} to {out}", flush=True)


def draw_while_it_goes_on(options: argparse.Namespace) -> None:
    folder = pathlib.Path(options.folder)
    if state_of(folder) == "none":
        print(f"Waiting for a run in '{folder}'.", flush=True)
    state = watch(folder, options.watch, lambda state: draw_and_say(options, state))
    if state == "killed":
        print("The run was killed: 'lumbricus --restart' goes on from its last "
              "checkpoint.")


def main(arguments: Sequence[str] | None = None) -> int:
    options = parse(arguments)
    try:
        (draw_and_say if options.watch is None else draw_while_it_goes_on)(options)
    except PlotError as error:
        print(f"lumbricus-plot: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"lumbricus-plot: '{error.filename}' cannot be written: "
              f"{error.strerror}; choose another folder with --output.",
              file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0
