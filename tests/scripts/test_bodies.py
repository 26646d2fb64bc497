# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other programs read what a run writes, and lumbricus-plot draws the body that
is in it."""
import sys

import numpy as np
import pandas
import pytest
import pyvista
from PIL import Image

from lumbricus_run import SOURCE, run_well

sys.path.insert(0, str(SOURCE / "python" / "src"))
from lumbricus.plot.body import Body, with_image  # noqa: E402
from lumbricus.plot.command import main  # noqa: E402
from lumbricus.plot.fields import (  # noqa: E402
    MEAN_WEIGHTS, have_no_partner, nodes_of_cells, read_grid, read_series)
from lumbricus.plot.scene import LIQUID_COLOURS, MUSCLE_COLOURS  # noqa: E402
from lumbricus.plot.surface import Faces  # noqa: E402
from lumbricus.plot.tables import read_description  # noqa: E402

# The ends and the middle of every edge of VTK's quadratic hexahedra.
EDGES = np.array([[0, 1, 8], [1, 2, 9], [2, 3, 10], [3, 0, 11], [4, 5, 12],
                  [5, 6, 13], [6, 7, 14], [7, 4, 15], [0, 4, 16], [1, 5, 17],
                  [2, 6, 18], [3, 7, 19]])
TIMES = [0, 0.1]
MIRRORS = {"full": 1, "quarter": 4}


@pytest.fixture(scope="module", params=["quarter", "full"])
def section(request):
    return request.param


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """A run of three segments, by the part of the section that is meshed; on
    two ranks, so that there are two files at each time."""
    made = {}

    def run_of(section):
        if section not in made:
            made[section] = run_well(
                SOURCE / "tests" / "physics" / "chain.prm",
                tmp_path_factory.mktemp(section),
                ["Output/Every=1", f"Time/End={TIMES[-1]}",
                 f"Geometry/segment chain/Cross-section={section}"], ranks=2)
        return made[section]

    return run_of


def test_pandas_reads_the_tables(runs):
    run = runs("quarter")
    for name in ("segments", "resets", "steps", "newton", "mesh"):
        table = pandas.read_csv(run.folder / f"{name}.csv")
        assert len(table) == len(run.table(f"{name}.csv"))
        assert all(kind.kind in "if" for kind in table.dtypes)
    table = pandas.read_csv(run.folder / "segments.csv")
    assert table.groupby("segment").size().tolist() == [2, 2, 2]
    assert table["t"].unique() == pytest.approx(TIMES)


def test_pyvista_reads_the_fields(runs, section):
    run = runs(section)
    reader = pyvista.get_reader(run.folder / "solution.pvd")
    assert reader.time_values == pytest.approx(TIMES)
    reader.set_active_time_value(reader.time_values[-1])
    grid = reader.read()[0]
    assert grid.n_cells == run.table("mesh.csv")[0]["cells"]
    assert grid.n_points == 27 * grid.n_cells
    assert set(grid.celltypes) == {pyvista.CellType.LAGRANGE_HEXAHEDRON}
    assert {"displacement", "pressure", "cauchy_stress", "J",
            "hydrostatic_divergence", "pressure_unknown", "segment", "tissue",
            "rank", "fibre_longitudinal", "active_stretch_longitudinal",
            "fibre_circular", "active_stretch_circular"} <= set(grid.point_data)
    assert set(np.unique(grid["rank"])) == {0, 1}
    assert set(np.unique(grid["segment"])) == {1, 2, 3}


def test_order_of_the_nodes(runs, section):
    """Releases of VTK and of deal.II count edges in two ways; a file says in
    which way it does."""
    run = runs(section)
    grid = read_grid(read_series(run.folder)[0][1])
    x = grid.points[nodes_of_cells(grid)]
    for a, b, middle in EDGES:
        length = np.linalg.norm(x[:, b] - x[:, a], axis=1)
        off = np.linalg.norm(x[:, middle] - 0.5 * (x[:, a] + x[:, b]), axis=1)
        # The arc of an eighth of a circle is off its chord by 0.1 of it.
        assert (off < 0.15 * length).all()


def test_volume_and_pressure(runs, section):
    """As in segments.csv, to what chords of curved edges lose."""
    run = runs(section)
    grid = read_grid(read_series(run.folder)[-1][1])
    rows = [run.last(segment) for segment in (1, 2, 3)]
    volumes = grid.compute_cell_sizes()["Volume"]
    assert MIRRORS[section] * volumes.sum() == pytest.approx(
        sum(row["fluid_volume"] + row["wall_volume"] for row in rows), rel=0.03)
    nodes = nodes_of_cells(grid)
    for row in rows:
        inside = ((grid["tissue"][nodes[:, 0]] == 0)
                  & (grid["segment"][nodes[:, 0]] == row["segment"]))
        means = grid["pressure"][nodes[inside]] @ MEAN_WEIGHTS
        assert np.average(means, weights=volumes[inside]) == pytest.approx(
            row["fluid_pressure"], rel=0.03)


def test_body_is_closed(runs, section):
    """A quarter of the whole body is left out, and its surface is closed."""
    run = runs(section)
    body = Body(read_description(run.folder)["body"])
    assert 2**len(body.mirrors) == MIRRORS[section]
    grid = read_grid(read_series(run.folder)[0][1])
    volume = MIRRORS[section] * grid.compute_cell_sizes()["Volume"].sum()
    faces = Faces(*body.opened(grid))
    surface = faces.surface(np.full(len(faces.nodes), True))
    assert surface.clean(tolerance=1e-6).n_open_edges == 0
    assert surface.volume == pytest.approx(0.75 * volume, rel=0.03)
    # The lines on the cut are in its planes.
    lines = faces.lines(with_mesh=False).points
    assert np.abs(lines[:, 1:]).min(axis=1).max() < 1e-6
    assert len(faces.lines(with_mesh=True).points) > len(lines)


def test_planes_of_the_cut():
    """The planes through the axis come first, and there is a part of the body
    on both sides; a plane of symmetry need not go through the axis."""
    def body(*planes, axis="x"):
        return Body({"axis": axis, "tissues": [], "symmetry_planes": [
            {"normal": normal, "position": position}
            for normal, position in planes]})

    corners = np.array([[0, 0, 0], [4, 2, 3.0]])
    assert body().cut(corners) == []
    assert body().cut(corners - 1) == [(1, 0), (2, 0)]
    assert body(axis="z").cut(corners - 1) == [(0, 0), (1, 0)]
    # What is mirrored in two planes, of which one is across the axis.
    assert body(("y", 0), ("x", 0)).cut(
        np.array([[-4, -2, 0], [4, 2, 3.0]])) == [(0, 0), (1, 0)]
    # As far as all has been mirrored.
    assert body(("z", 3)).cut(np.array([[0, -2, 0], [4, 2, 6.0]])) == [
        (1, 0), (2, 3)]


def test_mirrored_in_a_plane_beside_the_axis():
    points = np.array([[1.0, 2, 3], [1, 2, 4]])
    assert np.allclose(with_image(points, 2, 4),
                       [[1, 2, 3], [1, 2, 4], [1, 2, 5], [1, 2, 4]])
    assert np.allclose(with_image(points, 2)[2:], [[1, 2, -3], [1, 2, -4]])
    assert np.allclose(with_image(points, None)[2:], points)


def test_parts_of_others_are_partners():
    """Things 0 and 1 are the same, 3 is a part of 2, and 4 is alone."""
    keys = np.array([7, 7, 8, 21, 9])
    parts = np.array([[1, 2], [1, 2], [21, 22], [31, 32], [41, 42]])
    assert have_no_partner(keys, parts).tolist() == [False] * 4 + [True]


def picture(run, folder, *options):
    assert main([str(run.folder), "--output", str(folder), *options]) == 0
    name = "thumbnail" if "--thumbnail" in options else "picture"
    with Image.open(folder / f"{name}.png") as image:
        assert image.format == "PNG"
        return np.asarray(image.convert("RGB")).astype(int)


def count(image, colour, tolerance=12):
    """How many dots have about this colour."""
    colour = 255 * np.array(colour[:3])
    return int((np.abs(image - colour) < tolerance).all(axis=2).sum())


def test_colours(runs, tmp_path):
    """Liquid has the colour of the pressure in segments.csv, relative to the
    largest there is, and muscle on the cut that of its contraction."""
    run = runs("quarter")
    image = picture(run, tmp_path, "--times", "0.1", "--only", "picture")
    assert count(image[:, :5], (1, 1, 1)) == 5 * len(image)
    # Without the bars, which have all colours.
    image = image[:int(0.7 * len(image))]
    pressures = [run.last(segment)["fluid_pressure"] for segment in (1, 2, 3)]
    for pressure in pressures:
        assert count(image, LIQUID_COLOURS(pressure / max(pressures))) > 5000
    assert count(image, MUSCLE_COLOURS(1.0)) > 500
    assert count(image, MUSCLE_COLOURS(0.0)) > 500
    at_rest = picture(run, tmp_path, "--times", "0", "--only", "picture")
    assert count(at_rest, LIQUID_COLOURS(0.0)) > 5000


def test_mesh_and_fibres_are_drawn(runs, tmp_path):
    run = runs("quarter")
    options = ["--times", "0.1", "--only", "picture"]
    plain = picture(run, tmp_path, *options)
    with_mesh = picture(run, tmp_path, *options, "--mesh")
    assert (np.abs(plain - with_mesh) > 30).any(axis=2).sum() > 1000
    green = (0.08, 0.72, 0.65)
    with_fibres = picture(run, tmp_path, *options, "--fibres")
    assert count(with_fibres, green, 30) > count(plain, green, 30) + 200


def test_quarter_and_full_look_alike(runs, tmp_path):
    quarter, full = (picture(runs(part), tmp_path, "--thumbnail", "0.1")
                     for part in ("quarter", "full"))
    assert quarter.shape == (150, 240, 3)
    assert (tmp_path / "thumbnail.png").stat().st_size < 30000
    assert (quarter < 250).any(axis=2).mean() > 0.3
    assert np.abs(quarter - full).mean() < 1
