# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of the gallery: how often each estimates the errors of its mesh, what else
its README is about, and which mesh is finer."""
import dataclasses
import functools
import math
import re
from collections.abc import Callable

from lumbricus_run import Run

CHAIN = "Geometry/segment chain/"
VENTRICLE = "Geometry/truncated ellipsoid/"


@dataclasses.dataclass(frozen=True)
class Number:
    """A number of a README that is no length, radius or pressure of a segment: of() a
    run, whose mesh is finer with the settings. Steps are half as long with `halved`,
    by default those in time; where it is empty there is nothing to halve."""

    words: str
    of: Callable[[Run], float]
    finer: tuple[str, ...] = ("Mesh/Global refinements=1",)
    halved: tuple[str, ...] | None = None


@dataclasses.dataclass(frozen=True)
class Case:
    """A parameter file below parameters/, with the settings that make it shorter, which
    the words say; an estimate after every so many steps, or 0 where it is refused.
    Its controller is served beside it, and a limit point may end it."""

    file: str
    every: int
    number: Number | None = None
    settings: tuple[str, ...] = ()
    words: str = ""
    controller: bool = False
    may_stop: bool = False

    @property
    def name(self) -> str:
        """The folder in the gallery."""
        return self.file.split("/")[0]

    @property
    def rest(self) -> str:
        """The file in that folder, as READMEs name it."""
        return f"`{self.file.partition('/')[2]}`" + \
            (f", {self.words}" if self.words else "")


def points(result, t=None):
    """The rows of points.csv at a time, by default the last one, by number."""
    rows = result.table("points.csv")
    time = rows[-1]["t"] if t is None else t
    return {int(row["point"]): row for row in rows if abs(row["t"] - time) < 1e-9}


def turned(result, plane, one, other, t=None):
    """By how many degrees the line from one point to the other has turned."""
    at, (a, b) = points(result, t), plane
    before, after = (
        math.atan2(*(at[one][b] - at[other][b] + part * (at[one][f"u{b}"] -
                                                         at[other][f"u{b}"])
                     for b in (b, a))) for part in (0, 1))
    return math.degrees(after - before)


def twist(result):
    """Of one end of the helical segment against the other [degrees]."""
    return turned(result, "yz", 7, 8) - turned(result, "yz", 1, 2)


def moved(result, component, point=1, t=None):
    return points(result, t)[point][f"u{component}"]


def stretch(result, one, other):
    """Of the line along x between two points."""
    at = points(result)
    return 1 + (at[one]["ux"] - at[other]["ux"]) / (at[one]["x"] - at[other]["x"])


def stride(result, begin, end):
    """The way of the centre of mass between two times."""
    rows = result.table("body.csv")

    def at(time):
        return min(rows, key=lambda row: abs(row["t"] - time))["stride"]
    return at(end) - at(begin)


def said(result, words):
    """The first number behind words in the log."""
    return float(re.search(words + r" ([\d.e+-]+\d)", result.log).group(1))


def stroke(result):
    """By how much the body gets longer and shorter in the last unit of time."""
    rows = result.segments()
    last = [row["length"] for row in rows if row["t"] > rows[-1]["t"] - 1 - 1e-9]
    return max(last) - min(last)


def gone_over(result):
    """From segment 1 into segment 2, since the rest."""
    return result.last(2)["fluid_volume"] - result.segments()[1]["fluid_volume"]


def wider(result):
    """dR/R of the inside of the paper's membrane."""
    return points(result)[1]["uy"] / 10


CASES = (
    Case("adaptive_septum/case.prm", 1),
    Case("antagonism/case.prm", 5),
    Case("balloon/case.prm", 0, Number(
        "way of the inside at 0.0135 N/mm²", functools.partial(
            moved, component="x", t=0.95)), may_stop=True),
    Case("balloon/beyond.prm", 0, Number(
        "pressure at the limit point", functools.partial(said, words="at the time"))),
    Case("bending_tentacle/case.prm", 2, Number(
        "angle of the tip", functools.partial(turned, plane="xz", one=1, other=2),
        (f"{CHAIN}Cells around a quarter=4",))),
    Case("block_compression/case.prm", 2, Number(
        "compression", functools.partial(moved, component="z"))),
    Case("burrow/case.prm", 8, Number(
        "stride", functools.partial(stride, begin=1.5, end=7.5),
        (f"{CHAIN}Cells along a segment=4", f"{CHAIN}Cells across the liquid=4"))),
    Case("crawling/case.prm", 5, Number(
        "stride", functools.partial(stride, begin=0.25, end=1.25),
        (f"{CHAIN}Cells along a segment=4", f"{CHAIN}Cells around a quarter=4")),
         ("Time/End=1.25",), "first period"),
    Case("crossed_fibres/case.prm", 3, Number(
        "length of the middle", functools.partial(stretch, one=1, other=2))),
    Case("crossed_fibres/shortens.prm", 3, Number(
        "length of the middle", functools.partial(stretch, one=1, other=2))),
    Case("curling_bar/case.prm", 4, Number(
        "way of the ends", functools.partial(moved, component="z", point=3),
        ("Geometry/block/Cells=24, 2, 2",))),
    Case("helical_twist/case.prm", 2, Number(
        "twist", twist,
        (f"{CHAIN}Cells around a quarter=4",))),
    Case("inching/case.prm", 5, Number(
        "stride", functools.partial(stride, begin=1.25, end=2.25),
        (f"{CHAIN}Cells along a segment=4", f"{CHAIN}Cells around a quarter=4"))),
    Case("land/beam.prm", 0, Number(
        "z of the point", functools.partial(moved, component="z"),
        ("Geometry/block/Cells=96, 3, 6",))),
    Case("land/inflation.prm", 0, Number(
        "way of the apex", functools.partial(moved, component="x", point=2),
        (f"{VENTRICLE}Cells around a quarter=8", f"{VENTRICLE}Cells up to the base=16"))),
    Case("land/contraction.prm", 0, Number(
        "way of the apex", functools.partial(moved, component="x", point=2),
        (f"{VENTRICLE}Cells up to the base=12", f"{VENTRICLE}Cells through the wall=8"))),
    Case("lumbricus_terrestris/case.prm", 5),
    Case("lumbricus_terrestris/active_stress.prm", 6, settings=("Time/End=4.5",),
         words="first pulses"),
    Case("lumbricus_terrestris/tone.prm", 6, settings=("Time/End=4.5",),
         words="first pulses"),
    Case("mesh_file/case.prm", 5),
    Case("octopus_arm/case.prm", 5),
    Case("oscillators/case.prm", 8, controller=True),
    Case("paper/figure3/tied.prm", 1, Number("dR/R", wider)),
    Case("paper/figure3/slip.prm", 0, Number("dR/R", wider)),
    Case("paper/figure4/case.prm", 0, Number("dR/R, 20 resets", wider, halved=())),
    Case("peristalsis/case.prm", 5),
    Case("peristalsis/cavities.prm", 5),
    Case("pores/case.prm", 5, Number(
        "gone over", gone_over, (f"{CHAIN}Cells along a segment=12",
                                 f"{CHAIN}Cells through a cap=2"))),
    Case("quarter_length/case.prm", 5),
    Case("reflex/case.prm", 5, controller=True),
    Case("septum_buckles/case.prm", 0, Number(
        "contraction where it buckles", functools.partial(
            said, words="another branch begins at the time"))),
    Case("snap_through/case.prm", 0, Number(
        "highest load", functools.partial(said, words="at the time"))),
    Case("soft_actuator/case.prm", 4, Number(
        "angle of the tip", functools.partial(turned, plane="xz", one=1, other=2))),
    Case("two_balloons/case.prm", 0, Number(
        "pressure where the path forks", functools.partial(
            said, words="another branch begins at the time"),
        halved=("Path/volume of a chamber/Step=0.05",))),
    Case("viscous_segment/case.prm", 20, Number("stroke", stroke)),
    Case("whole_worm/case.prm", 8, Number(
        "stride", functools.partial(stride, begin=1.125, end=5.625),
        (f"{CHAIN}Cells along a segment=2", f"{CHAIN}Cells around a quarter=4")),
         (f"{CHAIN}Number of segments=15",), "15 segments"),
)
