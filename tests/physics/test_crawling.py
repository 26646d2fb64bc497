# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cases of the gallery on the ground, shorter, on coarser meshes and in fewer
steps: which way the worm goes, and what it holds on with."""
import csv

import pytest
from lumbricus_run import SOURCE, run_well
from test_contact_output import contacts

CHAIN = "Geometry/segment chain/"
GROUND = "Boundary conditions/ground/contact/"
RAMP = 0.25


def crawl(folder, settings, name="crawling", segments=6):
    """The case with a worm as long as one wave, for half a period after the
    ramp."""
    return run_well(
        SOURCE / "parameters" / name / "case.prm", folder,
        [CHAIN + f"Number of segments={segments}",
         CHAIN + "Cells across the liquid=1",
         *(f"Muscles/{muscle}/wave/Wavelength={segments}"
           for muscle in ("circular", "septal", "longitudinal")),
         "Time/First step=0.0625", "Time/Largest step=0.0625",
         f"Time/End={RAMP + 0.5}", "Output/Every=0", *settings])


def stride(result):
    """Towards the head, after the ramp."""
    at = {row["t"]: row["stride"] for row in result.table("body.csv")}
    return at[max(at)] - at[RAMP]


def check_costs(result):
    """Newton's method gets by without smaller steps."""
    steps = result.steps()
    assert sum(row["cuts"] for row in steps) == 0
    assert sum(row["newton_iterations"] for row in steps) <= \
        9 * sum(row["solves"] for row in steps)


def check_energy(result):
    """Muscles do the work that friction takes and the tissues store, as nearly as steps
    of a sixteenth of a period can say, relative to the work of those that contract."""
    with open(result.folder / "energy.csv") as file:
        rows = [(row["kind"], float(row["work"])) for row in csv.DictReader(file)]
    def total(kind):
        return sum(work for of_kind, work in rows if of_kind == kind)
    by_contraction = sum(work for kind, work in rows if kind == "muscle" and work > 0)
    assert total("friction") > 0
    assert total("muscle") > total("friction")
    assert abs(total("balance")) < 0.02 * by_contraction
    assert total("muscle") + total("boundary condition") + total("body force") + \
        total("cavities") - total("stored") == pytest.approx(total("balance"),
                                                             abs=1e-12)


def check_warning(result):
    """A run says so whose stride is short against the elastic slip, 0.02 mm in these
    cases: whether it did."""
    slips = abs(result.table("body.csv")[-1]["stride"]) / 0.02
    warns = 1 < slips < 25
    assert ("Warning: The stride" in result.log) == warns
    if warns:
        assert f"mm, is only {slips:.0f} elastic slips long; its error is some " \
            f"{250 / slips:.0f} %" in result.log
        assert "ground/contact/Elastic slip'" in result.log
    return warns


def test_crawling(tmp_path):
    """It goes towards the head, and where it is anchored it is thick."""
    result = crawl(tmp_path, [
        GROUND + "Setae=1 + 5*max(0, sin(2*pi*(t + 0.5 - (s - 1)/6)))"])
    check_costs(result)
    assert stride(result) > 0.3
    assert not check_warning(result)
    shape = {(row["t"], row["segment"]): row for row in result.segments()}
    anchored, free = [], []
    for row in contacts(result.folder):
        if row["t"] > RAMP:
            (anchored if row["anchored"] else free).append(
                shape[row["t"], row["segment"]])
    assert len(anchored) >= 5
    for column, sign in (("mid_radius", 1), ("length", -1)):
        means = [sum(row[column] for row in rows) / len(rows)
                 for rows in (anchored, free)]
        assert sign * (means[0] - means[1]) > 0.1, column
    check_energy(result)
    # The ground carries the weight; it is that of half of the worm.
    last = [row for row in result.segments() if row["t"] == RAMP + 0.5]
    assert sum(row["normal_force"] for row in contacts(result.folder)
               if row["t"] == RAMP + 0.5) == pytest.approx(
        0.5 * 1.05e-9 * 9810 * sum(row["fluid_volume"] + row["wall_volume"]
                                   for row in last), rel=1e-6)


def test_burrow(tmp_path):
    """The short chambers press against the soil and the long ones do not touch
    it; forces along the worm are in balance."""
    result = run_well(
        SOURCE / "parameters" / "burrow" / "case.prm", tmp_path,
        ["Time/First step=0.3", "Time/Largest step=0.3", "Time/End=2.4",
         "Output/Every=0"])
    check_costs(result)
    end = 2.4
    lengths = {row["segment"]: row["length"] for row in result.segments()
               if row["t"] == end}
    rows = [row for row in contacts(result.folder) if row["t"] == end]
    long, short = (choose(lengths, key=lengths.get) for choose in (max, min))
    assert (long, short) == (2, 5)
    pressed = {row["segment"]: -2 * row["force_z"] for row in rows}
    assert max(pressed, key=pressed.get) == short
    assert pressed[short] == pytest.approx(0.0477, rel=0.05)
    assert pressed[long] == 0
    normal = sum(row["normal_force"] for row in rows)
    assert abs(sum(row["force_x"] for row in rows)) < 1e-6 * normal


def test_inching(tmp_path):
    """The same muscles take it forward or backward, by the friction alone."""
    strides = []
    for friction in ("0.3, 1.2, 0.6", "1.2, 0.3, 0.6"):
        result = run_well(
            SOURCE / "parameters" / "inching" / "case.prm",
            tmp_path / friction[0:3],
            [CHAIN + "Number of segments=2", CHAIN + "Cells across the liquid=1",
             GROUND + f"Friction={friction}", "Time/End=1.25",
             "Output/Every=0"])
        check_costs(result)
        assert check_warning(result)
        strides.append(stride(result))
    assert strides[0] > 0.1
    assert strides[1] == pytest.approx(-strides[0], rel=1e-5)
