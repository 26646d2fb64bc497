# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the pictures in a report show."""

from collections.abc import Sequence

from .arrays import Array


def no_formula(text: str) -> str:
    """A text of the user's, in which Matplotlib sees no formula."""
    return text.replace("$", r"\$")


def animation_caption(times: Sequence[float] | Array, with_fibres: bool,
                      with_obstacles: bool) -> str:
    when = (f"Time t = {times[0]:g}." if len(times) == 1 else
            f"{len(times)} times from t = {times[0]:g} to t = {times[-1]:g}.")
    text = (when + " The body is cut open along two planes through its axis or "
            "of its symmetry, where it has such planes inside, the head on the "
            "left, at true scale. Liquid is coloured by its pressure [N/mm²], "
            "muscle by its active contraction: by how much [%] the most active "
            "fibres want to be shorter than at rest. View and colours are the "
            "same at all times.")
    if with_obstacles:
        text += (" Obstacles are translucent, without what would be in front of "
                 "the body; their lines stay where they are in them.")
    if with_fibres:
        text += (" Green lines are fibres, green dots fibres that go into the "
                 "body.")
    return text


KYMOGRAPH = (
    "Segments downwards, the head at the top; time to the right. Length "
    "relative to rest [-]: red is shorter, blue longer.")
PRESSURE = " Pressure of the liquid [N/mm²], positive in compression."
ACTIVATION = (
    " Activation: for every muscle the mean active stretch [-] over the cells "
    "of a segment that have its fibres, at the times that have fields; less "
    "than 1 (dark) is a contraction, grey a segment without that muscle. Of a "
    "muscle that pulls the part of its tension that it has, from 0 to 1 (dark).")
ANCHORS = (
    "Left: segments that are anchored in an obstacle (dark: less than half of "
    "what touches slides), slide (light) or do not touch (white), the head on "
    "the left, time downwards. Right: how far the centre of mass has come "
    "forward [mm].")
ENERGY = (
    "Work [N mm] since the start, on the part of the body that is computed: of "
    "every muscle, load and support, what friction takes of it (dashed), and "
    "what the tissues store. Dotted is the balance, what is left of all work "
    "less what is stored: the error of the steps.")
ERRORS = (
    "Estimates of what smaller cells would add, and where the run asks for it shorter "
    "steps and more resets, to the length [mm], the radius in the middle [mm], the "
    "pressure [N/mm²] and the place [mm] of every segment, in per cent of the largest, "
    "of the place in per cent of the largest length: bars at the last time that has an "
    "estimate, dots at those before.")
SEGMENTS = (
    "Length [mm] and radius in the middle [mm], pressure [N/mm²] and relative "
    "change of the volume [-] of the liquid (of the wall where there is none) "
    "in every segment against time. Bars, where one or two segments have estimates, "
    "are the errors of the mesh.")
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
