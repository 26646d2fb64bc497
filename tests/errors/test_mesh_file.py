# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of Gmsh or a file of fibres that cannot be used ends with exit code 1
and one message that names the parameter, the file, what is missing and the way
out."""
import math

import pytest
from cube_mesh import (HEXAHEDRON, HEXAHEDRON_20, QUADRILATERAL,
                       TETRAHEDRON, TETRAHEDRON_10, Mesh, second_order)
from lumbricus_run import run
from mesh_cases import FIBRES, FILE, SECTION, start
from mistakes import check_one_message, names, on_ranks, run_all

def without_names():
    mesh = Mesh()
    mesh.names = []
    return mesh


def with_gap():
    """The second cube has a middle of its own in the common face, beside that of the
    first."""
    mesh = second_order(27, 27)
    kind, tag, nodes = mesh.elements[2]
    old = nodes[22]
    mesh.nodes.append([1.1, *mesh.nodes[old - 1][1:]])
    mesh.elements[2] = (kind, tag, [len(mesh.nodes) if node == old else node
                                    for node in nodes])
    return mesh


def bulging():
    """The middle of the face at x = 0 is before it."""
    mesh = second_order(27)
    mesh.names = [(d, name.replace("begin", "symmetry x"))
                  for d, name in mesh.names]
    return mesh.move(mesh.elements[1][2][8], -0.05, 0.5, 0.5)


def only(kind, n_nodes):
    """One element of this type instead of the cubes."""
    mesh = Mesh()
    mesh.elements = []
    return mesh.add(kind, "wall", range(1, n_nodes + 1))


def of_version(version):
    mesh = Mesh()
    mesh.version = version
    return mesh


def cut_off():
    mesh = Mesh()
    mesh.elements = mesh.elements[:1]
    mesh.end = ""
    return str(mesh).replace("$Elements\n1", "$Elements\n2")


def around_the_axis():
    """The cubes with the x axis in their middle."""
    mesh = Mesh()
    mesh.nodes = [[x, y - 0.5, z - 0.5] for x, y, z in mesh.nodes]
    return mesh


def away_from_the_axis():
    """The cubes from z = 2 on, with a flat skin there."""
    mesh = Mesh().surface("skin", 1, 2, 6, 5)
    mesh.nodes = [[x, y, z + 2] for x, y, z in mesh.nodes]
    return mesh


def quarter_of_a_tube(outer=1.3):
    """From radius 1 to the outer, z = 1 to 3, about the z axis, as CAD has it."""
    mesh = Mesh(())
    mesh.nodes = [[r * math.cos(phi), r * math.sin(phi), z]
                  for z in (1., 2., 3.) for phi in (0, math.pi / 4, math.pi / 2)
                  for r in (1., outer)]
    for z in (0, 1):
        for phi in (0, 1):
            a, b = 6 * z + 2 * phi + 1, 6 * z + 2 * phi + 7
            mesh.add(HEXAHEDRON, "wall", [a, a + 1, a + 3, a + 2,
                                          b, b + 1, b + 3, b + 2])
            mesh.surface("inside", a, a + 2, b + 2, b)
            mesh.surface("outside", a + 1, a + 3, b + 3, b + 1)
    return mesh


def of_many_tissues():
    mesh = Mesh(["wall"] * 257)
    for i in range(257):
        name = "layer " + chr(ord("a") + i // 26) + chr(ord("a") + i % 26)
        mesh.elements[i] = (HEXAHEDRON, mesh.tag(3, name), mesh.elements[i][2])
    return mesh


def two_loose_cubes(shift):
    """The second cube with nodes of its own, so far from the first."""
    mesh = Mesh(("wall",))
    n = len(mesh.nodes)
    mesh.nodes += [[x + shift, y, z] for x, y, z in mesh.nodes]
    return mesh.add(HEXAHEDRON, "wall", range(n + 1, 2 * n + 1))


TWO_GROUPS = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "wall"
3 2 "cap"
$EndPhysicalNames
$Entities
0 0 0 1
1 0 0 0 1 1 1 2 1 2 0
$EndEntities
"""

# A block of nodes larger than any memory.
MANY_NODES = """$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 8 1 8
3 1 0 99999999999999999
1
$EndNodes
"""

PARTITIONED = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PartitionedEntities
$EndPartitionedEntities
"""

# What is wrong; the mesh, or None where it is right; settings; what the message
# has to say.
MISTAKES = [
    ("no file", None, [SECTION + "File=none.msh"],
     [FILE, "'none.msh' cannot be read", "the working directory"]),
    ("file not set", None, [SECTION + "File="],
     [FILE + " is not set", "Give the path of a .msh file"]),
    ("folder", None, [SECTION + "File=/tmp"],
     [FILE, "'/tmp' cannot be read"]),
    ("no file of Gmsh", "solid cube\n", [],
     [FILE, "'FOLDER/body.msh' is not a file of Gmsh", "'$MeshFormat'",
      "'Mesh.MshFileVersion = 4.1;'"]),
    ("empty file", "", [], [FILE, "is not a file of Gmsh"]),
    ("format 1", "$NOD\n1\n1 0 0 0\n$ENDNOD\n", [],
     [FILE, "is not a file of Gmsh", "'Mesh.MshFileVersion = 4.1;'"]),
    ("format 4.0", of_version("4 0 8"), [],
     [FILE, "has Gmsh's format 4;", "2.2 and 4.1 can be read",
      "'Mesh.MshFileVersion = 4.1;'"]),
    ("binary file", of_version("4.1 1 8"), [],
     [FILE, "is binary", "'Mesh.Binary = 0;'"]),
    ("file cut off", cut_off(), [], [FILE, "ends too early, in line 25"]),
    ("word for a number", str(Mesh()).replace("1.0 1.0 0.0", "1.0 one 0.0"),
     [], [FILE, "line 15, '6 1.0 one 0.0', has no number"]),
    ("node that is missing", Mesh().add(HEXAHEDRON, "wall", range(90, 98)), [],
     [FILE, "names a node the file does not have"]),
    # The reader took memory for as many nodes as the file says: exit code 3.
    ("more nodes than there is memory", MANY_NODES, [],
     [FILE, "line 8, '$EndNodes', has no number", "'Mesh.MshFileVersion"]),
    ("number below zero", str(Mesh()).replace("$Nodes\n12", "$Nodes\n-1"), [],
     [FILE, "line 9, has a number < 0", "'Mesh.MshFileVersion = 4.1;'"]),
    ("line between sections", str(Mesh()).replace("$Nodes", "Nodes", 1), [],
     [FILE, "line 8, 'Nodes', is not the begin of a section",
      "'Mesh.MshFileVersion = 4.1;'"]),
    ("file in partitions", PARTITIONED, [],
     [FILE, "has been partitioned", "Write it without partitions"]),
    ("name without quotation marks", str(Mesh()).replace('"wall"', "wall"), [],
     [FILE, "line 6, has no name in quotation marks",
      "'Mesh.MshFileVersion = 4.1;'"]),
    # A section cannot have such a name: this went on without the tissue.
    ("name with a slash", Mesh(("wall", "w/all")), [],
     [FILE, "a physical volume 'w/all': it has a '/'", "without '/', '#', '=' "
      "and commas"]),
    ("more tissues than there may be", of_many_tissues(), [],
     [FILE, "has 257 tissues", "there can be 256", "the last word"]),
    # The message was that 'File' is not set.
    ("misspelt parameter of the file", None,
     [SECTION + "File=", SECTION + "Flie=body.msh"],
     [f"'{SECTION}Flie' is unknown", f"Did you mean '{SECTION}File'?"]),
    ("no names", without_names(), [],
     [FILE, "has no physical names", "'Physical Volume(\"wall\") = {1};'"]),
    ("tetrahedra", only(TETRAHEDRON, 4), [],
     [FILE, "has 1 tetrahedra; only hexahedra can be used",
      "'Mesh.RecombineAll = 1;'", "'Mesh.SubdivisionAlgorithm = 2;'"]),
    ("tetrahedra beside hexahedra", Mesh().add(TETRAHEDRON, "cap", range(1, 5)),
     [], ["has 1 tetrahedra"]),
    ("too few nodes for second order", only(HEXAHEDRON_20, 12), [],
     [FILE, "line 25", "has no number where one belongs"]),
    ("tetrahedra of second order", only(TETRAHEDRON_10, 10), [],
     [FILE, "has 1 tetrahedra of second order; only hexahedra can be used (of "
      "first or second order)", "'Mesh.ElementOrder' to 1 or 2"]),
    ("two orders", second_order(27, 8), [],
     [FILE, "has 1 hexahedra of eight nodes beside 1 hexahedra of 27 nodes, "
      "which do not fit together", "'Mesh.ElementOrder'"]),
    ("two kinds of second order", second_order(20, 27), [],
     [FILE, "has 1 hexahedra of 20 nodes beside 1 hexahedra of 27 nodes",
      "'Mesh.SecondOrderIncomplete'"]),
    ("faces of first order at cells of second", second_order(20).surface(
        "begin", 1, 4, 8, 5), [],
     [FILE, "has quadrilaterals in its physical surface 'begin'",
      "its hexahedra are quadrilaterals of eight nodes"]),
    # Node 9 is in the middle of the first edge of the first cube, and 26 in that
    # of its face at x = 1.
    ("a folded curved cell", second_order(27).move(9, 0.9, 0, 0), [],
     [FILE, "has 1 curved cells that are folded or flat; the first is element 1, "
      "at (", "'Mesh.HighOrderOptimize = 2;'"]),
    ("a face that is curved in two ways", with_gap(), [],
     [FILE, "has the elements 1 and 3, whose common face is curved in two ways, "
      "at (1, 0.5, 0.5)", "'Mesh.ElementOrder'"]),
    ("round surfaces of curved cells", second_order(27, 27),
     [SECTION + "Round surfaces=begin"],
     [f"'{SECTION}Round surfaces'", "hexahedra of second order",
      "Leave the list empty"]),
    ("a plane of symmetry between straight corners", bulging(), [],
     [FILE, "the plane of mirror symmetry 'symmetry x' that is not flat",
      "from x = -0.05 to 0"]),
    ("surfaces only", only(QUADRILATERAL, 4), [],
     [FILE, "has no volume elements", "'Physical Volume'"]),
    ("volume without a name", Mesh().add(HEXAHEDRON, "", range(5, 13)), [],
     [FILE, "in no physical volume with a name", "at (1.5, 0.5, 0.5)",
      "'Mesh.SaveAll'"]),
    ("liquid there is not", None, [SECTION + "Liquid tissues=liquid, wall"],
     [f"'{SECTION}Liquid tissues'", "has no tissue 'liquid'", "It has 'wall'",
      "leave the list empty"]),
    ("wall there is not", None, [SECTION + "Wall layers=walls"],
     [f"'{SECTION}Wall layers'", "has no tissue 'walls'", "It has 'wall'"]),
    ("round surface there is not", Mesh().surface("head", 1, 2, 3, 4),
     [SECTION + "Round surfaces=skin"],
     [f"'{SECTION}Round surfaces'", "has no physical surface 'skin'",
      "It has 'head'"]),
    ("round surface on the axis", Mesh().surface("head", 1, 2, 3, 4),
     [SECTION + "Round surfaces=head"],
     [f"'{SECTION}Round surfaces'", "'head' on the x axis, at (0, 0, 0)",
      "Remove it"]),
    # The sides of these cubes became bent, in silence, as every surface did
    # that was round about another axis.
    ("round surface that is flat", away_from_the_axis(),
     [SECTION + "Round surfaces=skin"],
     [f"'{SECTION}Round surfaces'", "'skin', which is not round about the x "
      "axis", "distances from the axis of 2 to 2.23607 mm",
      "0.236068 mm off", "Set 'Round axis'", "remove the surface"]),
    ("tube about another axis", quarter_of_a_tube(),
     [SECTION + "Round surfaces=inside, outside"],
     [f"'{SECTION}Round surfaces'", "side', which is not round about the x "
      "axis", "Set 'Round axis'"]),
    ("tube beside its axis", quarter_of_a_tube(),
     [SECTION + "Round surfaces=inside",
      SECTION + "Round axis=0.1, 0, 0; 0, 0, 1"],
     [f"'{SECTION}Round surfaces'", "'inside', which is not round about the "
      "axis '0.1, 0, 0; 0, 0, 1'"]),
    # This was a run with folded cells: the inside bulges through the outside.
    ("round inside of a thin flat wall", quarter_of_a_tube(1.05),
     [SECTION + "Round surfaces=inside", SECTION + "Round axis=z"],
     [f"'{SECTION}Round surfaces'", "the cell of the mesh file", "at (0.",
      "becomes folded", "the other side of the wall"]),
    ("axis that is none", Mesh().surface("head", 1, 2, 3, 4),
     [SECTION + "Round surfaces=head", SECTION + "Round axis=0, 0, 1"],
     [f"'{SECTION}Round axis': '0, 0, 1' is no axis", "'0, 1.5, 0; 0, 0, 1'"]),
    ("axis without a direction", Mesh().surface("head", 1, 2, 3, 4),
     [SECTION + "Round surfaces=head", SECTION + "Round axis=0, 0, 1; 0, 0, 0"],
     [f"'{SECTION}Round axis'", "is no axis", "not zero"]),
    ("liquid that is wall", Mesh(("wall", "cap")),
     [SECTION + "Liquid tissues=wall"],
     [f"'{SECTION}Wall layers' has 'wall'", "'Geometry/mesh file/Liquid "
      "tissues' too", "Remove it"]),
    ("segment left out", Mesh(("wall", "wall 3", "wall 6")), [],
     [FILE, "has the segments 1, 3, 6, but no segment 2", "without gaps"]),
    ("segment zero", Mesh(("wall", "wall 0")), [],
     [FILE, "'wall 0'", "the number of the segment, from 1"]),
    ("number without tissue", Mesh(("wall", "2")), [],
     [FILE, "a physical volume '2'", "that of a tissue"]),
    ("liquids that touch", Mesh(("wall", "water", "water 2")),
     [SECTION + "Liquid tissues=water"],
     [FILE, "liquid of segment 1 and of segment 2 that touch at (2, ",
      "Put a septum between them"]),
    ("folded cell", Mesh().move(12, 0.5, 0., 1.), [],
     [FILE, "has 1 cells that are folded or flat", "its centre at (",
      "better shaped cells"]),
    ("nodes twice", two_loose_cubes(1), [],
     [FILE, "two nodes at the same place, (1, ", "'Coherence;'",
      "'BooleanFragments'"]),
    ("two bodies", two_loose_cubes(3), [],
     [FILE, "has 2 parts that are not joined", "(0.5, 0.5, 0.5)",
      "(3.5, 0.5, 0.5)", "'Coherence;'"]),
    ("cell twice", Mesh(("wall", "wall")).add(HEXAHEDRON, "cap", range(5, 13)),
     [], [FILE, "more than two cells at one face", "one physical group only"]),
    ("volume in two groups", TWO_GROUPS, [],
     [FILE, ", line 11, has a volume in two physical groups",
      "Put it into one"]),
    ("face in two surfaces",
     Mesh().surface("head", 1, 2, 3, 4).surface("mouth", 2, 3, 4, 1), [],
     [FILE, "a face in two physical surfaces, 'head' and 'mouth'"]),
    ("plane of symmetry that is not flat",
     Mesh().surface("symmetry y", 1, 5, 8, 4)
     .surface("symmetry y", 6, 7, 11, 10), [],
     [FILE, "'symmetry y' that is not flat", "from y = 0 to 1"]),
    ("plane of symmetry inside",
     Mesh().surface("symmetry z", 1, 2, 6, 5).move(9, 2, 0, -0.5), [],
     [FILE, "'symmetry z' inside the body", "from z = 0 to 0",
      "the body from -0.5 to 1", "at one end of the body"]),
    ("symmetry without a direction", Mesh().surface("symmetry", 1, 2, 3, 4), [],
     [FILE, "a physical surface 'symmetry'", "'symmetry x', 'symmetry y' or "
      "'symmetry z'"]),
    ("boundary there is not", Mesh().surface("head", 1, 2, 3, 4),
     ["Boundary conditions/Names=push",
      "Boundary conditions/push/Type=follower pressure",
      "Boundary conditions/push/Boundary=tail"],
     ["'Boundary conditions/push/Boundary' is 'tail'",
      "Give one of 'head', 'free'"]),
    ("tissue there is not", None, ["Tissues/cap/Law=Neo-Hooke"],
     ["'Tissues/cap' is unknown", "'wall'"]),

    ("no file of fibres", None, [FIBRES + "File=none.csv"],
     [f"'{FIBRES}File'", "'none.csv' cannot be read",
      "the working directory"]),
    ("fibres of five numbers", None, [FIBRES + "File=FOLDER/five.csv"],
     [f"'{FIBRES}File'", "five.csv, line 2, has 5 entries",
      "x, y, z, fx, fy, fz"]),
    ("fibres not set", None, [FIBRES + "File="],
     [f"'{FIBRES}File' is not set", "the working directory"]),
    ("fibres that are a folder", None, [FIBRES + "File=/tmp"],
     [f"'{FIBRES}File'", "'/tmp' cannot be read"]),
    ("fibres without a point", None, [FIBRES + "File=FOLDER/empty.csv"],
     [f"'{FIBRES}File'", "empty.csv' has no points", "x, y, z, fx, fy, fz"]),
    ("fibres of words", None, [FIBRES + "File=FOLDER/word.csv"],
     [f"'{FIBRES}File'", "word.csv, line 2, has 'one'", "six numbers"]),
    ("fibres that are NaN", None, [FIBRES + "File=FOLDER/nan.csv"],
     [f"'{FIBRES}File'", "nan.csv, line 1, has 'nan'", "finite"]),
    ("fibres of length zero", None, [FIBRES + "File=FOLDER/zero.csv"],
     [f"'{FIBRES}File'", "zero.csv, line 1, has a vector of length zero",
      "Give a vector"]),
    ("fibres twice at a point", None, [FIBRES + "File=FOLDER/twice.csv"],
     [f"'{FIBRES}File'", "lines 1 and 3, have the same point",
      "Remove one"]),
    ("radial fibres on the axis", around_the_axis(),
     ["Muscles/all/Fibres=radial"],
     ["Muscle 'all'", "'radial' has no direction at the point", ", 0, 0)",
      "on the x axis", "another fibre field"]),
    ("fibres that end halfway", None, [FIBRES + "File=FOLDER/half.csv"],
     ["Muscle 'all'", f"'{FIBRES}File'", "half.csv' lacks the part of the "
      "muscle around the point (", "mm away", f"'{FIBRES}Reach'"]),
]

CASES = on_ranks(MISTAKES, on_two=[
    "no file", "tetrahedra", "nodes twice", "segment left out",
    "fibres of five numbers", "fibres that end halfway"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("meshes"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_one_message_names_what_is_missing(i, results):
    (_, _, _, words), _ = CASES[i]
    folder = str(results[i].folder.parent)
    check_one_message(results[i],
                      [word.replace("FOLDER", folder) for word in words])


@pytest.mark.parametrize("ranks", [1, 2])
def test_the_base_has_no_mistake(ranks, tmp_path):
    result = start(("right", None, [], []), ranks, tmp_path / "case", run)
    assert result.exit_code == 0, result.message
