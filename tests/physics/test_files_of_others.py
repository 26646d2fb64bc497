# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text files that other programs and systems write are read as they are meant.

A file with CR alone at the ends of its lines, as old programs on a Mac write it,
was one line: a parameter file was a comment, a mesh no file of Gmsh. Gmsh's
'$ParametricNodes' were skipped, so that elements had no nodes."""
import pytest
from cube_mesh import Mesh
from lumbricus_run import run_well

MESH = str(Mesh())

FIBRES = """x, y, z, fx, fy, fz
0.5, 0.5, 0.5, 1, 0, 0  # the first cell
1.5, 0.5, 0.5, 1, 0, 0
"""

PRM = """# A muscle that shortens
subsection Geometry
  set Shape = mesh \\
    file
  subsection mesh file
    set File           = FOLDER/body.msh
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    set Muscles = all
  end
end
subsection Muscles
  subsection all
    set Fibres         = file
    set Active stretch = expression
    subsection file
      set File = FOLDER/fibres.csv
    end
    subsection expression
      set Formula = 1 - 0.2*t
    end
  end
end
"""
TIME = """subsection Time
  set First step   = 1
  set Largest step = 1
end
"""
JSON = """{
  "Geometry": {"Shape": "mesh file",
               "mesh file": {"File": "FOLDER/body.msh", "Liquid tissues": ""}},
  "Tissues": {"wall": {"Muscles": "all"}},
  "Muscles": {"all": {
    "Fibres": "file", "file": {"File": "FOLDER/fibres.csv"},
    "Active stretch": "expression", "expression": {"Formula": "1 - 0.2*t"}}},
  "Time": {"First step": 1,
           "Largest step": 1}
}
"""


def parametric(mesh):
    """As Gmsh writes it with 'Mesh.SaveParametric = 1;': behind the point are
    the dimension and the number of what it lies on, and where on it."""
    begin, end = mesh.index("$Nodes"), mesh.index("$EndNodes")
    head, count, *nodes = mesh[begin:end].splitlines()
    tails = [" 0 1", " 1 7 0.25", " 2 3 0.25 0.75", " 3 1"]
    lines = ["$ParametricNodes", count] + \
        [node + tails[i % 4] for i, node in enumerate(nodes)]
    return mesh[:begin] + "\n".join(lines) + "\n" + \
        mesh[end:].replace("$EndNodes", "$EndParametricNodes")


def length(folder, texts, ranks=1):
    """Of the body at the end, from its files with these texts."""
    folder.mkdir()
    for name, text in texts.items():
        (folder / name).write_bytes(
            text.replace("FOLDER", str(folder)).encode())
    case = next(name for name in texts if name.startswith("case"))
    return run_well(folder / case, folder / "out",
                    ranks=ranks).last()["length"]


ENDS = {"LF": "\n", "CR LF": "\r\n", "CR": "\r"}


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("kind", ["prm", "json"])
def test_lines_may_end_in_any_way(kind, end, ranks, tmp_path):
    if ranks == 2 and end != "CR":
        pytest.skip("one kind is enough")
    texts = {"body.msh": MESH, "fibres.csv": FIBRES,
             "case." + kind: JSON if kind == "json" else
             "include time.prm\n" + PRM}
    if kind == "prm":
        texts["time.prm"] = TIME
    # The mark of UTF-8 that editors put first does not matter either.
    texts = {name: "\ufeff" + text.replace("\n", ENDS[end])
             for name, text in texts.items()}
    texts = dict(sorted(texts.items(), key=lambda item: item[0] == "time.prm"))
    assert length(tmp_path / "case", texts, ranks) == \
        pytest.approx(1.6, rel=1e-8)


def test_parametric_nodes_are_nodes(tmp_path):
    texts = {"body.msh": parametric(MESH), "fibres.csv": FIBRES,
             "case.prm": TIME + PRM}
    assert "$Nodes" not in texts["body.msh"]
    assert length(tmp_path / "case", texts) == pytest.approx(1.6, rel=1e-8)
