# SPDX-License-Identifier: LGPL-2.1-or-later
"""A static instability is named for what it is: the limit point of a balloon,
the buckling of a wall."""
import itertools
import math

import pytest
from lumbricus_run import run, run_well

RADIUS, THICKNESS, STIFFNESS = 1., 0.05, 0.23


def write_octant(file_name, n):
    """A spherical shell in x, y, z >= 0 as a file of Gmsh: three patches of n by n
    cells, one cell through the thickness."""
    nodes, volumes, surfaces = {}, [], {}

    def node(direction, radius):
        # A point of the cube's surface, pushed to the sphere.
        angles = [math.tan(math.pi / 4 * c) for c in direction]
        size = math.sqrt(sum(a * a for a in angles))
        x = tuple(round(radius * a / size, 12) for a in angles)
        return nodes.setdefault(x, len(nodes) + 1)

    def side(name, quadrilateral):
        surfaces.setdefault(name, []).append(quadrilateral)

    for axis in range(3):
        for i, j in itertools.product(range(n), repeat=2):
            corners = []
            for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)):
                direction = [0.] * 3
                direction[axis] = 1.
                direction[(axis + 1) % 3] = (i + k) / n
                direction[(axis + 2) % 3] = (j + m) / n
                corners.append(direction)
            inner = [node(c, RADIUS) for c in corners]
            outer = [node(c, RADIUS + THICKNESS) for c in corners]
            volumes.append(inner + outer)
            side("inside", inner)
            for edge in range(4):
                ends = (edge, (edge + 1) % 4)
                for plane in range(3):
                    if all(corners[e][plane] == 0. for e in ends):
                        side("symmetry " + "xyz"[plane],
                             [inner[ends[0]], inner[ends[1]],
                              outer[ends[1]], outer[ends[0]]])

    groups = [(3, "wall", volumes)] + [(2, name, elements) for name, elements
                                       in surfaces.items()]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
             str(len(groups))]
    lines += [f'{dimension} {tag + 1} "{name}"'
              for tag, (dimension, name, _) in enumerate(groups)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{number} {x[0]} {x[1]} {x[2]}" for x, number in nodes.items()]
    elements = [(5 if dimension == 3 else 3, tag + 1, element)
                for tag, (dimension, _, of_group) in enumerate(groups)
                for element in of_group]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number + 1} {kind} 2 {tag} {tag} " +
              " ".join(str(v) for v in element)
              for number, (kind, tag, element) in enumerate(elements)]
    lines += ["$EndElements", ""]
    file_name.write_text("\n".join(lines))


def thick_sphere_pressure(stretch):
    """Of an incompressible Neo-Hookean shell whose inner hoop stretch is given:
    p = int 2 (sigma_t - sigma_r) dr/r = int 2 a (l^2 - l^-4) dr/r."""
    outer = RADIUS + THICKNESS
    growth = RADIUS**3 * (stretch**3 - 1)

    def f(R):
        r = (R**3 + growth) ** (1 / 3)
        stretch_there = r / R
        return 2 * STIFFNESS * (stretch_there**2 - stretch_there**-4) * \
            (R / r)**2 / r
    n = 200
    h = (outer - RADIUS) / n
    return h / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2)
                       * f(RADIUS + i * h) for i in range(n + 1))


def test_limit_point_of_a_balloon(tmp_path):
    # A thin Neo-Hookean sphere takes most pressure at the hoop stretch 7^(1/6);
    # a thick one at a little less of the inside.
    stretches = [1 + 0.001 * i for i in range(1, 1000)]
    most = max(thick_sphere_pressure(s) for s in stretches)
    at = max(stretches, key=thick_sphere_pressure)
    assert at == pytest.approx(7 ** (1 / 6), rel=0.04)

    write_octant(tmp_path / "shell.msh", 4)
    case = tmp_path / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = mesh file
  subsection mesh file
    set File = {tmp_path / "shell.msh"}
    set Liquid tissues =
  end
end
subsection Tissues
  subsection wall
    set Law = Neo-Hooke
    subsection Neo-Hooke
      set a = {STIFFNESS}
    end
  end
end
subsection Boundary conditions
  set Names = inflation
  subsection inflation
    set Boundary = inside
    set Type     = follower pressure
    subsection follower pressure
      set Pressure = {1.2 * most}*t
    end
  end
end
subsection Output
  set Every        = 0
  set Points       = {RADIUS}, 0, 0
end
""")
    result = run(case, tmp_path / "run")
    assert result.exit_code == 2, result.log + result.message
    last = result.table("points.csv")[-1]
    # The facets of the mesh make it 1 % smaller than the sphere.
    assert 1.2 * last["t"] == pytest.approx(1., abs=0.02)
    assert 1 + last["ux"] / RADIUS == pytest.approx(at, rel=0.05)
    for words in ("limit point", "segment 1, wall", "stop short of it"):
        assert words in result.message, result.message
    assert "buckling" not in result.message


@pytest.mark.parametrize("ranks", [1, 2])
def test_buckling_of_a_column(ranks, tmp_path):
    # Euler's column with ends that cannot turn but move aside: buckles at the
    # strain pi^2/12 (h/L)^2. It stays straight in the computation, which says so.
    length, height = 10., 1.
    case = tmp_path / "case.prm"
    case.write_text(f"""
subsection Geometry
  set Shape = block
  subsection block
    set Lengths     = {length}, {height}, {1.5 * height}
    set Cells       = 8, 2, 2
    set Tissue name = column
  end
end
subsection Tissues
  subsection column
    set Law = Neo-Hooke
    subsection Neo-Hooke
      set a = {STIFFNESS}
    end
  end
end
subsection Boundary conditions
  set Names = bottom, top
  subsection bottom
    set Boundary = x min
    set Type     = displacement
    subsection displacement
      set Components   = x
      set Displacement = 0; 0; 0
    end
  end
  subsection top
    set Boundary = x max
    set Type     = displacement
    subsection displacement
      set Components   = x
      set Displacement = -{0.02 * length}*t; 0; 0
    end
  end
end
subsection Stability
  set Watch = true
end
subsection Output
  set Every = 0
end
""")
    result = run_well(case, tmp_path / "run", ranks=ranks)
    euler = math.pi**2 / 12 * (height / length) ** 2 / 0.02
    stiffness = [(row["t"], row["softest_stiffness"])
                 for row in result.steps()]
    for t, k in stiffness:
        assert (k < 0) == (t > euler), (t, k, euler)
    assert result.log.count("not stable any more") == 1
    assert "segment 1, column" in result.log
