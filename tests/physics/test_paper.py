# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's own experiments on coarse meshes, against the paper, closed forms
and the homogeneous solution, which do not use the program."""
import os
import pathlib
import sys

import pytest
from loaded_program import loaded_program
from lumbricus_run import SOURCE, run_well

CASES = SOURCE / "parameters" / "paper"
sys.path.insert(0, str(CASES))

import experiments  # noqa: E402

# What the experiments call.
os.environ["LUMBRICUS"] = loaded_program()


@pytest.fixture(scope="module", params=[1, 2])
def runs(request, tmp_path_factory):
    """On one and two ranks; runs that experiments share are made once."""
    return experiments.Runs(tmp_path_factory.mktemp(f"ranks{request.param}"),
                            ranks=request.param)


@pytest.mark.parametrize("experiment", experiments.EXPERIMENTS,
                         ids=lambda experiment: experiment.__name__)
def test_rows_agree(runs, experiment):
    rows = list(experiment(runs))
    assert rows
    for row in rows:
        assert row.agrees(), row
        if row.paper is not None and row.what.startswith("Figure 3"):
            assert row.ours == pytest.approx(row.paper, abs=1e-3), row


def divergences(folder):
    return list(experiments.read_table(folder / "resets.csv")["eta"])


def test_normals_at_rest_are_unstable(runs):
    # What the normals of the deformed liquid cure. First seen with pairs of
    # nodes on the open cylinder: the divergence fell until reset 20 and then
    # grew with every reset, since a hydrostatic liquid is not in equilibrium
    # where its surface is tilted against the normals of the coupling.
    eta = divergences(experiments.hundred_resets(runs, "reference slip"))
    assert min(eta) < 1e-3
    assert eta[-1] > 100 * min(eta)


LOCAL = ["Mesh/Local refinements=1", "Mesh/Refine where=x-5",
         "Reset/Least=60"]


@pytest.fixture(scope="module")
def coarse(tmp_path_factory):
    return run_well(CASES / "figure3" / "slip.prm",
                    tmp_path_factory.mktemp("coarse"))


@pytest.mark.parametrize("ranks", [1, 2])
def test_slip_with_hanging_nodes(tmp_path, coarse, ranks):
    """Hanging nodes on both sides of the interface: a hydrostatic liquid is in
    equilibrium there too, and refinement keeps the volume at rest."""
    fine = run_well(CASES / "figure3" / "slip.prm", tmp_path / "fine", LOCAL,
                    ranks)
    assert divergences(fine.folder)[-1] < 1e-7
    for volume in ("fluid_volume", "wall_volume"):
        for row in fine.segments():
            assert row[volume] == pytest.approx(coarse.segments()[0][volume],
                                                rel=1e-12)
    assert fine.last()["mid_radius"] == pytest.approx(
        coarse.last()["mid_radius"], rel=1e-4)


@pytest.fixture(scope="module")
def tied(tmp_path_factory):
    return run_well(
        pathlib.Path(__file__).parent / "segment.prm",
        tmp_path_factory.mktemp("tied"), ["Time/End=0.4"], ranks=2)


@pytest.mark.parametrize("section", ["quarter", "full"])
def test_slip_in_corners(tmp_path, tied, section):
    """One closed segment: the liquid stays in the corners of wall and cap, and
    a full section's liquid, which could spin, is held."""
    chain = "Geometry/segment chain/"
    result = run_well(
        pathlib.Path(__file__).parent / "segment.prm", tmp_path,
        ["Interface/Coupling=slip", f"{chain}Cross-section={section}",
         "Time/End=0.4"], ranks=2)
    first, last = result.segments()[0], result.last()
    assert last["t"] == 0.4
    assert last["eta"] < 1e-3
    for volume in ("fluid_volume", "wall_volume"):
        assert last[volume] == pytest.approx(first[volume], rel=1e-8)
    for shape in ("length", "mid_radius"):
        assert last[shape] == pytest.approx(tied.last()[shape], rel=5e-3)


def test_slip_is_the_same_on_one_two_and_four_ranks(tmp_path):
    rows = [run_well(CASES / "figure3" / "slip.prm", tmp_path / str(ranks),
                     LOCAL[:2] + ["Reset/Tolerance=1e-3"], ranks).segments()
            for ranks in (1, 2, 4)]
    for other in rows[1:]:
        for row, reference in zip(other, rows[0]):
            for name, value in reference.items():
                if name != "eta":
                    assert row[name] == pytest.approx(value, rel=1e-9,
                                                      abs=1e-12), name
