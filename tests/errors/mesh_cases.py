# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of mesh files share: a case that reads a mesh, and wrong files of
fibres."""

from cube_mesh import Mesh

# Files of fibres, by their names.
WRONG_FIBRES = {
    "five.csv": "0 0 0 1 0 0\n1 0 0 1 0\n",
    "half.csv": "0 0 0 1 0 0\n0 0.2 0 1 0 0\n",
    "empty.csv": "x, y, z, fx, fy, fz\n",
    "word.csv": "0 0 0 1 0 0\n1 0 0 one 0 0\n",
    "nan.csv": "0 0 0 nan 0 0\n",
    "zero.csv": "0 0 0 0 0 0\n",
    "hex.csv": "0 0 0 0x1 0 0\n",
    "twice.csv": "0 0 0 1 0 0\n1 0 0 1 0 0\n0 0 0 0 1 0\n"}

SECTION = "Geometry/mesh file/"
FILE = f"'{SECTION}File'"
FIBRES = "Muscles/all/file/"

CASE = """
subsection Geometry
  set Shape = mesh file
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
    subsection expression
      set Formula = 1 - 0.1*t
    end
  end
end
subsection Time
  set First step   = 1
  set Largest step = 1
end
subsection Linear solver
  set Method = direct
end
"""


def start(mistake, ranks, folder, run):
    _, mesh, settings, _ = mistake
    if not any(text.startswith("Muscles/all/Fibres=") for text in settings):
        settings = [FIBRES + "File=FOLDER/fibres.csv", *settings]
    folder.mkdir()
    (folder / "body.msh").write_text(str(Mesh() if mesh is None else mesh))
    (folder / "fibres.csv").write_text("0.5 0.5 0.5 1 0 0\n1.5 0.5 0.5 1 0 0\n")
    for name, text in WRONG_FIBRES.items():
        (folder / name).write_text(text)
    case = folder / "case.prm"
    case.write_text(CASE.replace("FOLDER", str(folder)))
    return run(case, folder / "out",
               [setting.replace("FOLDER", str(folder)) for setting in settings],
               ranks)
