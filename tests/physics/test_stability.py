# SPDX-License-Identifier: LGPL-2.1-or-later
"""A static instability is named for what it is: the limit point of a balloon,
the buckling of a wall."""
import math

import pytest
import thick_sphere
from lumbricus_run import SOURCE, run, run_well

# Of the balloon; the column is of the same rubber.
RADIUS, THICKNESS, STIFFNESS = 10., 0.5, 0.23


def thick_sphere_pressure(stretch):
    """Of the balloon, whose inner hoop stretch is given."""
    return thick_sphere.pressure(stretch**3, RADIUS, THICKNESS, STIFFNESS)


def test_limit_point_of_a_balloon(tmp_path):
    # A thin Neo-Hookean sphere takes most pressure at the hoop stretch 7^(1/6);
    # a thick one at a little less of the inside.
    stretches = [1 + 0.001 * i for i in range(1, 1000)]
    most = max(thick_sphere_pressure(s) for s in stretches)
    at = max(stretches, key=thick_sphere_pressure)
    assert at == pytest.approx(7 ** (1 / 6), rel=0.04)

    case = SOURCE / "parameters" / "balloon" / "case.prm"
    result = run(case, tmp_path, [
        f"Geometry/mesh file/File={case.parent / 'shell.msh'}",
        # It comes no nearer with shorter ones.
        "Time/Smallest step=0.005", "Stability/Watch=false", "Output/Every=0"])
    assert result.exit_code == 2, result.log + result.message
    last = result.table("points.csv")[-1]
    # There is little between the last step and the limit, and the cells are curved.
    assert 0.01426 * last["t"] == pytest.approx(most, rel=1e-3)
    stretch = 1 + last["ux"] / RADIUS
    assert stretch == pytest.approx(at, rel=0.02)
    assert thick_sphere_pressure(stretch) == pytest.approx(0.01426 * last["t"],
                                                           rel=1e-6)
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
