# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shape alone is a case that runs.

The default shape did not: the liquid of a chain, and of a cylinder, had by
default the stiffness of the wall, which is refused. All shapes that the program
lists are tried, also those that will come."""
import re
import subprocess

import pytest
from cube_mesh import Mesh
from loaded_program import loaded_program
from lumbricus_run import run_well

# What a shape cannot do without.
NEEDS = {"mesh file": ["Geometry/mesh file/File=FOLDER/body.msh"]}

# Two cubes in a row, with the names that 'mesh file' has as defaults.
BODY = str(Mesh(("wall", "liquid")))


def shapes():
    """The names in what the program says of the parameter 'Shape', and its
    default."""
    reference = subprocess.run(
        [loaded_program(), "--parameters"], capture_output=True,
        text=True, check=True, timeout=60).stdout
    words = " ".join(re.search(
        r"subsection Geometry\n((?: *#.*\n)+) *set Shape", reference)[1]
        .replace("#", " ").split())
    default = re.search(r"set Shape *= *(.*)\n", reference)[1].strip()
    return re.findall(r"'([^']+)':", words), default


SHAPES, DEFAULT = shapes()


def test_the_shapes_are_found():
    assert {"block", "mesh file", "open cylinder", "segment chain"} <= \
        set(SHAPES)
    assert DEFAULT in SHAPES


@pytest.mark.parametrize("shape, ranks", [
    (None, 1), (DEFAULT, 2), *((shape, 1) for shape in SHAPES)])
def test_shape_alone_runs_to_its_end(shape, ranks, tmp_path):
    (tmp_path / "body.msh").write_text(BODY)
    case = tmp_path / "case.prm"
    case.write_text("set Title = The defaults\n" if shape is None else
                    f"subsection Geometry\n  set Shape = {shape}\nend\n")
    result = run_well(case, tmp_path / "out",
                      [need.replace("FOLDER", str(tmp_path))
                       for need in NEEDS.get(shape, [])], ranks)
    rows = result.segments()
    # Nothing acts on it: it stays as it is.
    assert rows[-1]["t"] == 1
    for first, last in zip(rows, rows[-int(rows[-1]["segment"]):]):
        assert last["wall_volume"] == pytest.approx(first["wall_volume"],
                                                    rel=1e-12)
        assert abs(last["fluid_pressure"]) < 1e-12


@pytest.mark.parametrize("law, stiffness", [("Neo-Hooke", {"a": 0.23}),
                                            ("Mooney-Rivlin",
                                             {"a": 0.2, "b": 0.03}),
                                            ("Hooke", {"E": 0.69})])
def test_liquid_is_by_default_a_thousandth_of_the_wall(law, stiffness,
                                                       tmp_path):
    case = tmp_path / "case.prm"
    case.write_text("set Title = The defaults\n")
    result = run_well(case, tmp_path / "out",
                      [f"Tissues/{tissue}/Law={law}" for tissue in
                       ("liquid", "cap")] + ["Time/End=0.05"])
    text = (result.folder / "parameters.prm").read_text()

    def value(tissue, name):
        begin = text.index(f"subsection {law}\n",
                           text.index(f"  subsection {tissue}\n"))
        return float(re.search(rf"set {name} *= (\S+)", text[begin:])[1])
    for name, number in stiffness.items():
        assert value("cap", name) == pytest.approx(number)
        assert value("liquid", name) == pytest.approx(number / 1000)
