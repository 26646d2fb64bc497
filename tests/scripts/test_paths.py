# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures along a path whose times go back. They came in the order of the times, so
that a balloon grew and shrank; and of an arch that lies before both planes of the cut
nothing was left to draw, with a message about an array."""
import sys

import numpy as np
import pytest
import pyvista
from PIL import Image

from lumbricus_run import SOURCE, run_well

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.animation import LAST_SECONDS, seconds_of_frames  # noqa: E402
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.energy import read_work  # noqa: E402
from lumbricus.plot.fields import read_grid, read_series  # noqa: E402
from lumbricus.plot.figures import choose_times, goes_back  # noqa: E402

ARCH = SOURCE / "parameters" / "snap_through"


@pytest.fixture(scope="module")
def arch(tmp_path_factory):
    return run_well(ARCH / "case.prm", tmp_path_factory.mktemp("arch") / "run",
                    [f"Geometry/mesh file/File={ARCH / 'arch.msh'}",
                     "Output/Energy=true"])


def test_the_series_is_in_the_order_of_the_steps(arch):
    series = read_series(arch.folder)
    times = [t for t, _ in series]
    assert times == pytest.approx([row["t"] for row in arch.segments()], rel=1e-5)
    assert goes_back(times) and not goes_back([0, 0.5, 0.5, 2])
    # The crown goes down all the way.
    lowest = [read_grid(file)["displacement"][:, 1].min() for _, file in series]
    assert lowest == sorted(lowest, reverse=True)


def test_others_read_it_in_that_order(arch):
    """Readers sort a series by its time steps, and ParaView shows one picture of each:
    they were the times, so that the arch went up and down."""
    reader = pyvista.get_reader(arch.folder / "solution.pvd")
    rows = arch.segments()
    assert list(reader.time_values) == list(range(len(rows)))
    lowest = []
    for number, row in enumerate(rows):
        reader.set_active_time_point(number)
        grid = reader.read()[0]
        assert grid.field_data["TIME"][0] == pytest.approx(row["t"], rel=1e-5)
        lowest.append(grid["displacement"][:, 1].min())
    assert lowest == sorted(lowest, reverse=True)


def test_in_time_the_steps_are_the_times(tmp_path):
    result = run_well(ARCH / "case.prm", tmp_path,
                      [f"Geometry/mesh file/File={ARCH / 'arch.msh'}",
                       "Path/Control=time", "Time/End=0.3"])
    times = [row["t"] for row in result.segments()]
    assert list(pyvista.get_reader(result.folder / "solution.pvd").time_values) == \
        pytest.approx(times, rel=1e-10)
    assert [t for t, _ in read_series(result.folder)] == pytest.approx(times)


def test_pictures_are_evenly_spaced_along_the_path(arch):
    series = read_series(arch.folder)
    chosen = choose_times(series, [], 4)
    assert [series.index(entry) for entry in chosen] == [0, 6, 12, len(series) - 1]
    assert choose_times(series, [], 1000) == series
    # A time that is asked for is taken where it comes first.
    assert choose_times(series, [series[5][0]], 4) == [series[5]]
    assert seconds_of_frames([0, 1, 0.5]) == [0.15, 0.15, LAST_SECONDS]


def test_work_adds_up_in_the_order_of_the_steps(arch):
    times, sums = read_work(arch.folder / "energy.csv")
    assert list(times) == [row["t"] for row in arch.steps()]
    load = sums["boundary condition", "load"]
    # It always does work, since the arch gives way all along.
    assert np.all(np.diff(load) > 0)


def test_all_is_drawn(arch):
    assert main([str(arch.folder)]) in (0, None)
    picture = np.asarray(Image.open(arch.folder / "picture.png").convert("L"))
    assert (picture < 240).mean() > 0.02
    assert (arch.folder / "kymograph.png").exists()
