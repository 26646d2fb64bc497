# SPDX-License-Identifier: LGPL-2.1-or-later
"""Physical surfaces that are to be the walls around chambers without cells, and
are not: one message with the name and the way out."""
import pytest
from cube_mesh import FACES, boxes
from lumbricus_run import run
from mesh_cases import FILE
from mistakes import check_one_message, names, on_ranks, run_all

CASE = """
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File           = FOLDER/body.msh
    set Liquid tissues = LIQUIDS
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
"""


def named_twice():
    """The same name under two tags."""
    mesh = boxes("cavity 1")
    mesh.names.append((2, "cavity 1"))
    kind, _, corners = mesh.elements[-1]
    mesh.elements[-1] = (kind, len(mesh.names), corners)
    return mesh


def with_an_inner_face():
    mesh = boxes("cavity 1")
    # Between the cells at the origin and beside it.
    corners = mesh.elements[0][2]
    return mesh.surface("cavity 1", *[corners[v] for v in FACES[2][0]])


def without_faces():
    mesh = boxes("cavity 1", "cavity 2")
    mesh.elements = [element for element in mesh.elements
                     if mesh.names[element[1] - 1] != (2, "cavity 2")]
    return mesh


MISTAKES = [
    ("a face that is missing", boxes("cavity 1", left_out=[(0, 1)]),
     [FILE, "'cavity 1'", "does not close its chamber", "(2, 1, ",
      "no plane of mirror symmetry", "Which surface is missing?"]),
    # Its area vectors add up to zero.
    ("faces across that are missing",
     boxes("cavity 1", left_out=[(1, 0), (1, 1)]),
     [FILE, "'cavity 1'", "does not close", "Which surface is missing?"]),
    ("a face that is missing in half a body",
     boxes("cavity 1", symmetric=True, left_out=[(2, 1)]),
     [FILE, "'cavity 1'", "does not close", "Which surface is missing?"]),
    ("no such segment", boxes("cavity 2"),
     [FILE, "'cavity 2', but no segment 2", "it has 1", "'wall 2'"]),
    ("no number", boxes("cavity"),
     [FILE, "'cavity'", "as in 'cavity 1'", "must not begin with"]),
    ("number zero", boxes("cavity 0"), [FILE, "'cavity 0'", "as in 'cavity 1'"]),
    ("a word", boxes("cavity wall 1"), [FILE, "'cavity wall 1'", "'cavity 1'"]),
    ("twice", named_twice(),
     [FILE, "'cavity 1' and 'cavity 1' for the same segment", "one chamber"]),
    ("twice in two ways", boxes("cavity 1", "cavity 01"),
     [FILE, "for the same segment", "number the chambers"]),
    ("a face inside", with_an_inner_face(),
     [FILE, "'cavity 1' with cells on both sides", "(0.5, 0.5, 1)",
      "must have no cells", "another name"]),
    ("no faces", without_faces(), [FILE, "'cavity 2'", "no cell has a face"]),
    ("a gap", boxes(None, "cavity 2"),
     [FILE, "'cavity 2'", "the segment 1 before it has no chamber",
      "'cavity 1'", "without gaps"]),
    ("liquid too", boxes("liquid").surface("cavity 1", 1, 2, 3, 4),
     [FILE, "'cavity 1'", "segment 1 has cells of liquid too", "one chamber"]),
    ("a load on it", boxes("cavity 1"),
     ["'cavity 1'", "Boundary conditions/push/Boundary"])]
CASES = on_ranks(MISTAKES, on_two=["a face that is missing", "a gap"])


def start(mistake, ranks, folder, run):
    name, mesh, _ = mistake
    folder.mkdir()
    (folder / "body.msh").write_text(str(mesh))
    case = folder / "case.prm"
    liquid = any(name.startswith("liquid") for _, name in mesh.names)
    case.write_text(CASE.replace("FOLDER", str(folder)).replace(
        "LIQUIDS", "liquid" if liquid else ""))
    settings = ["Boundary conditions/Names=push",
                "Boundary conditions/push/Boundary=cavity 1",
                "Boundary conditions/push/Type=follower pressure"] \
        if name == "a load on it" else []
    return run(case, folder / "out", settings, ranks)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("cavities"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_one_message_says_what_to_do(i, results):
    check_one_message(results[i], CASES[i][0][2])


RIGHT = {"one": (boxes("cavity 1"), [1]), "two": (
             boxes("cavity 1", "cavity 2"), [1, 1]),
         "after liquid": (boxes("liquid", "cavity 2"), [1, 1]),
         "half": (boxes("cavity 1", symmetric=True), [1])}


@pytest.mark.parametrize("name", RIGHT)
def test_these_have_no_mistake(name, tmp_path):
    """The cell that is left out is a cube of 1 mm."""
    mesh, volumes = RIGHT[name]
    result = start((name, mesh, []), 1, tmp_path / "case", run)
    assert result.exit_code == 0, result.message
    assert [row["fluid_volume"] for row in result.segments()
            if row["t"] == 0] == pytest.approx(volumes)
