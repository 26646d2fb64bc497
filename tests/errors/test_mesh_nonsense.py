# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nonsense in a mesh file is refused, and not read as something else.

Elements of a type that the program does not know, and those beyond the number
that a section gives, were dropped in silence: half of the body was missing, and
the run ended with exit code 0. Of a node that was there twice the last was
taken, behind a number whatever followed, and physical surfaces were forgotten
where their elements are no faces of the hexahedra."""
import pytest
from cube_mesh import HEXAHEDRON, TETRAHEDRON_10, TETRAHEDRON, Mesh
from mesh_cases import FILE, SECTION, start
from mistakes import check_one_message, names, on_ranks, run_all

TRIANGLE, PRISM, PYRAMID = 2, 6, 7
AGAIN = "Write the file again"


def changed(old, new, mesh=None):
    """The two cubes, with this change in the text."""
    text = str(Mesh() if mesh is None else mesh)
    assert old in text
    return text.replace(old, new, 1)


def with_surface(kind, name, nodes):
    """The cubes with an element in a physical surface."""
    mesh = Mesh().surface(name, 1, 2, 3, 4)
    mesh.elements[-1] = (kind, mesh.elements[-1][1], nodes)
    return mesh


V4 = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "wall"
$EndPhysicalNames
$Entities
0 0 0 1
1 0 0 0 1 1 1 1 1 0
$EndEntities
$Nodes
1 8 1 8
3 1 0 8
1
2
3
4
5
6
7
8
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
$EndNodes
$Elements
1 1 1 1
3 1 5 1
1 1 2 3 4 5 6 7 8
$EndElements
"""


def v4(old, new):
    assert old in V4
    return V4.replace(old, new, 1)


def entities(text):
    """The cube with another section of entities."""
    begin, end = V4.index("$Entities"), V4.index("$Nodes")
    return V4[:begin] + text + V4[end:]


ELEMENT_1, ELEMENT_2 = "1 5 2 1 1 1 2 3 4 5 6 7 8", "2 5 2 1 1 5 6 7 8 9 10 11 12"

NUMBERS = [(word, f"number that is '{word}'") for word in
           ("nan", "inf", "0x10", "1e", "1.5abc", "1,5", "1e999")]

# What is wrong; the mesh; settings; what the message has to say.
MISTAKES = [
    # The body with an unknown type was one cube long.
    ("type that Gmsh does not have", changed("\n2 5 2", "\n2 205 2"), [],
     [FILE, "line 26, has an element of type 205, which is none of Gmsh's"]),
    # As an unsigned number it was 4294967291.
    ("type below zero", changed("\n2 5 2", "\n2 -5 2"), [],
     [FILE, "line 26, has an element of type -5, which is none"]),
    ("polyhedron", changed("\n2 5 2", "\n2 35 2"), [],
     [FILE, "has 1 polyhedra beside 1 hexahedra of eight nodes"]),
    # The body with elements beyond the number was one cube long.
    ("elements beyond the number", changed("$Elements\n2", "$Elements\n1"), [],
     [FILE, "line 26, '2 5 2 1 1 5 6 7 8 9 10 11 12', comes where the section "
      "'$Elements' should end with '$EndElements'", AGAIN]),
    ("nodes beyond the number", changed("$Nodes\n12", "$Nodes\n11"), [],
     [FILE, "line 21, '12 2.0 0.0 1.0', comes where the section '$Nodes' "
      "should end"]),
    ("fewer elements than the number", changed("$Elements\n2", "$Elements\n3"),
     [], [FILE, "line 27, '$EndElements', has no number where one belongs"]),
    ("names beyond the number", changed('3 1 "wall"', '3 1 "wall"\n3 2 "cap"'),
     [], [FILE, "comes where the section '$PhysicalNames' should end"]),
    # Everything up to the end of the elements was skipped as a part of the
    # nodes.
    ("section without an end", changed("$EndNodes\n", ""), [],
     [FILE, "line 22, '$Elements', comes where the section '$Nodes' should "
      "end"]),
    ("format without an end", changed("$EndMeshFormat\n", ""), [],
     [FILE, "'$PhysicalNames', comes where the section '$MeshFormat' should "
      "end"]),
    ("unknown section without an end",
     changed("$Nodes", "$Periodic\n0\n$Nodes"), [],
     [FILE, "ends too early"]),
    ("section twice",
     str(Mesh()) + "$Elements\n1\n9 5 2 1 1 1 2 3 4 5 6 7 8\n$EndElements\n",
     [], [FILE, "line 28, begins a second section '$Elements'"]),
    # Of these two nodes the second was taken, and the cube was another.
    ("node twice", changed("\n2 0.0 1.0 0.0", "\n1 0.0 1.0 0.0"), [],
     [FILE, "line 11, has node 1 a second time"]),
    ("element twice", changed(ELEMENT_2, "1" + ELEMENT_2[1:]), [],
     [FILE, "line 26, has element 1 a second time", "one physical group"]),
    # The same cell twice has no boundary at all.
    ("one cell as two",
     str(Mesh(("wall",)).add(HEXAHEDRON, "wall", range(1, 9))), [],
     [FILE, "has the cell at (0.5, 0.5, 0.5) twice"]),
    ("wedge as a hexahedron",
     changed(ELEMENT_2, "2 5 2 1 1 5 6 7 8 9 10 11 11"), [],
     [FILE, "line 26, has an element with one node twice",
      "Mesh with hexahedra"]),
    ("nodes beyond those of the type", changed(ELEMENT_2, ELEMENT_2 + " 12"),
     [], [FILE, "line 26, ", "goes on with '12' where it should end"]),
    ("node in four dimensions", changed("12 2.0 0.0 1.0", "12 2.0 0.0 1.0 7"),
     [], [FILE, "line 21, '12 2.0 0.0 1.0 7', goes on with '7'"]),
    *((name, changed("6 1.0 1.0 0.0", f"6 1.0 {word} 0.0"), [],
       [FILE, f"line 15, '6 1.0 {word} 0.0', has no number where one belongs, "
        f"but '{word}'"]) for word, name in NUMBERS),
    ("node number that is broken", changed("\n6 1.0", "\n6.5 1.0"), [],
     [FILE, "line 15, '6.5 1.0 1.0 0.0', has no number", "but '6.5'"]),
    # abs() of it is no number.
    ("tag that is too large", changed("5 2 1 1", "5 2 -2147483648 1"), [],
     [FILE, "line 25, has the number -2147483648, which is too large"]),
    ("count that is too large", changed("$Nodes\n12", "$Nodes\n1" + 30 * "0"),
     [], [FILE, "line 9, '1000", "has no number"]),
    # Cells in no group had this name.
    ("physical group zero", changed('3 1 "wall"', '3 0 "wall"'), [],
     [FILE, "line 6, '3 0 \"wall\"', has no physical group"]),
    ("physical group of four dimensions",
     changed('3 1 "wall"', '4 1 "wall"'), [],
     [FILE, "line 6, '4 1 \"wall\"', has no physical group"]),
    ("two names of a group",
     changed('1\n3 1 "wall"', '2\n3 1 "wall"\n3 1 "cap"'), [],
     [FILE, "line 7, names the physical group 1 of dimension 3 a second "
      "time"]),
    ("mixed mesh",
     Mesh().add(TETRAHEDRON, "wall", range(1, 5))
     .add(PRISM, "wall", range(1, 7)).add(PRISM, "wall", range(2, 8))
     .add(PYRAMID, "wall", range(1, 6)), [],
     [FILE, "has 2 prisms, 1 pyramids, 1 tetrahedra beside 2 hexahedra of "
      "eight nodes; only hexahedra can be used", "'Mesh.RecombineAll = 1;'"]),
    ("mixed mesh of second order",
     Mesh().add(TETRAHEDRON_10, "wall", range(1, 11)), [],
     [FILE, "has 1 tetrahedra of second order beside 2 hexahedra of eight "
      "nodes", "'Mesh.ElementOrder' to 1 or 2"]),
    # The plane of symmetry was forgotten, and the body was half of it.
    ("surface of triangles", with_surface(TRIANGLE, "symmetry y", [1, 5, 8]),
     [], [FILE, "has triangles in its physical surface 'symmetry y', as at "
          "(", "'Recombine'"]),
    ("surface that is no face",
     with_surface(3, "skin", [1, 5, 11, 4]), [],
     [FILE, "has a quadrilateral in its physical surface 'skin' that is no "
      "face of a cell", "Mesh surfaces and volumes together"]),
    ("plane of symmetry beside the body",
     changed("$Nodes\n12", "$Nodes\n16", changed(
         "$EndNodes", "13 0 9 0\n14 1 9 0\n15 1 9 1\n16 0 9 1\n$EndNodes",
         with_surface(3, "symmetry y", [13, 14, 15, 16]))), [],
     [FILE, "has the plane of mirror symmetry 'symmetry y', but no cell has a "
      "face in it"]),

    ("nodes of 4.1 beyond the number", v4("1 8 1 8", "1 7 1 8"), [],
     [FILE, "is the last of 8 nodes, but the first line of the section says "
      "7"]),
    ("elements of 4.1 beyond the number", v4("1 1 1 1\n3", "1 3 1 1\n3"), [],
     [FILE, "is the last of 1 elements, but the first line of the section "
      "says 3"]),
    ("block beyond the number", v4("$EndElements", "3 1 5 0\n$EndElements"),
     [], [FILE, "'3 1 5 0', comes where the section '$Elements' should end"]),
    ("element in an entity there is not", v4("3 1 5 1", "3 2 5 1"), [],
     [FILE, "has elements of the entity 2 of dimension 3, which '$Entities' "
      "does not have"]),
    ("hexahedra in a surface", v4("3 1 5 1", "2 1 5 1"), [],
     [FILE, "has hexahedra in an entity of dimension 2"]),
    ("entity twice",
     v4("0 0 0 1\n", "0 0 0 2\n1 0 0 0 1 1 1 0 0\n"), [],
     [FILE, "has the entity 1 of dimension 3 a second time"]),
    # So meshio writes the format 4.1. The message was that the cells are in no
    # physical volume.
    ("4.1 without entities", entities(""), [],
     [FILE, "has no section '$Entities' before its elements", "meshio",
      'file_format="gmsh22"']),
    ("words behind a node of 4.1", v4("0 1 1\n$", "0 1 1 x\n$"), [],
     [FILE, "'0 1 1 x', goes on with 'x'"]),

    # A device has no end.
    ("device for a mesh", None, [SECTION + "File=/dev/zero"],
     [FILE, "'/dev/zero' cannot be read"]),
    ("device for fibres", None, ["Muscles/all/file/File=/dev/zero"],
     ["'Muscles/all/file/File'", "'/dev/zero' cannot be read"]),
    ("fibres in hexadecimal numbers", None,
     ["Muscles/all/file/File=FOLDER/hex.csv"],
     ["'Muscles/all/file/File'", "line 1, has '0x1'"]),

    # A load there was refused as one on a boundary that the shape does not
    # have.
    ("load on an inner surface", Mesh().surface("septum", 5, 6, 7, 8),
     ["Boundary conditions/Names=push",
      "Boundary conditions/push/Type=follower pressure",
      "Boundary conditions/push/Boundary=septum"],
     ["'Boundary conditions/push/Boundary' is 'septum', which is a physical "
      "surface inside the body: all faces have cells on both sides, as that "
      "at (1, 0.5, 0.5)", "act at the boundary", "Give one of 'free'"]),
    # Half of this load was missing in silence.
    ("load on a surface that is partly inside",
     Mesh().surface("push", 5, 6, 7, 8).surface("push", 1, 2, 3, 4),
     ["Boundary conditions/Names=push",
      "Boundary conditions/push/Type=follower pressure",
      "Boundary conditions/push/Boundary=push"],
     ["'Boundary conditions/push/Boundary' is 'push'",
      "inside the body: 1 of its 2 faces have cells on both sides"]),
]

CASES = on_ranks(MISTAKES, on_two=["type that Gmsh does not have", "node twice",
                                   "load on an inner surface"])


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    return run_all(start, CASES, tmp_path_factory.mktemp("nonsense"))


@pytest.mark.parametrize("i", range(len(CASES)), ids=names(CASES))
def test_nonsense_is_refused(i, results):
    (_, _, _, words), _ = CASES[i]
    check_one_message(results[i], words)
