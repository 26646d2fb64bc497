// SPDX-License-Identifier: LGPL-2.1-or-later
// Chambers without cells: their volumes against closed forms, and what they add to
// equilibrium against finite differences, with hanging nodes and planes of
// symmetry; and a wall that is not closed.
#include <lumbricus/cavities/cavities.h>
#include <lumbricus/linear/linear_solver.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "read_plugin.h"
#include "specimen.h"

using namespace lumbricus;

namespace
{
  std::string
  two_chambers(const std::string &section, const std::string &more)
  {
    return R"(
subsection Geometry
  set Shape = segment chain
  subsection segment chain
    set Number of segments     = 2
    set Radius                 = 1.5
    set Segment length         = 2.5
    set Wall layers            = wall
    set Wall layer thicknesses = 0.3
    set Septum thickness       = 0.3
    set Cap thickness          = 0.4
    set Cells around a quarter = 2
    set Liquid                 = cavity
    set Cross-section          = )" +
           section + R"(
  end
end
subsection Mesh
  set Local refinements = 1
  set Refine where      = min(z - 0.7, 0.7 - abs(x - 2.8))
end
)" + more;
  }

  const std::string gas = R"(
subsection Cavities
  set Content = gas
  subsection gas
    set Exponent                  = 1.4
    set Absolute pressure outside = 0.05
  end
end
)";

  const std::string compressible = R"(
subsection Cavities
  subsection liquid
    set Compressibility = 0.3
  end
end
)";



  const std::string contents_and_flows = R"(
subsection Cavities
  set Segments with their own content = 2
  set Pores  = 0.4
  set Leak   = 0.7*s
  set Inflow = 0.1*t
  subsection Segment 2
    set Content = pressure
    subsection pressure
      set Pressure = 0.01*t
    end
  end
end
)";

  const std::string gas_flows = R"(
subsection Cavities
  set Content = gas
  set Pores   = 3
  set Leak    = 2
end
)";

  const std::string pump = R"(
subsection Cavities
  set Content = volume
  subsection volume
    set Relative volume = 1 + 0.3*s*t
  end
end
)";



  // Along the axis, which every plane of symmetry allows.
  std::string
  weight(const std::string &gravity)
  {
    return contents_and_flows + R"(
subsection Body forces
  set Names = weight
  subsection weight
    set Type = weight
    subsection weight
      set Gravity = )" +
           gravity + R"(
    end
  end
end
subsection Cavities
  subsection liquid
    set Density = 0.7
  end
end
subsection Boundary conditions
  set Names = hold
  subsection hold
    set Boundary = head
    set Type     = displacement
  end
end
)";
  }



  // Two chambers of unequal pressures in a state that is no equilibrium.
  class Chambers : public Specimen
  {
  public:
    Chambers(const std::string &section, const std::string &content)
      : Specimen(two_chambers(section, content))
    {
      state.globals = model->equilibrium.globals_at_rest();
      state.globals.at(cavity_pressure) = {0.03, -0.02};
      state.globals.at(cavity_filling)  = {1.1, 0.9};
      model->set_to(state);
      state.solution.add(1., random(0.002, 1));
    }

    // The residual r, and that of the pressures.
    std::vector<double>
    residual(const Vector &solution, const std::vector<double> &P, Vector &r)
    {
      EXPECT_TRUE(model->assembler.residual(solution, 1., r).valid());
      return model->cavities
        .border(solution,
                {{cavity_pressure, P}, {cavity_filling, {1.1, 0.9}}},
                1.,
                nullptr,
                r)
        .residual;
    }
  };
} // namespace



// Kept factors take the pressures along, where what is in the chambers leaves the
// matrix symmetric; else they go around the factors. With the volume kept as
// strictly as at first, 1e3 instead of 1e2 times the stiffness, rounding in single
// precision cost a chain of 40 segments 258 linear iterations instead of 108.
TEST(Cavities, AreSolvedForAsADirectSolverDoes)
{
  for (const std::string &content :
       {std::string(), gas, pump, contents_and_flows, gas_flows})
    {
      Chambers body("quarter", content);
      auto    &model = *body.model;
      model.assembler.linearise(body.state.solution, 1.);
      Vector       b = model.assembler.right_hand_side();
      const Border border =
        model.cavities.border(body.state.solution,
                              body.state.globals,
                              1.,
                              &model.assembler.tangent(),
                              b);
      std::vector<Vector>              x(2, b);
      std::vector<std::vector<double>> P(2);
      unsigned int                     i = 0;
      for (const std::string name : {"direct", "kept factor"})
        {
          const auto solver = Registry<LinearSolver>::create(name);
          solver->reinit(model.assembler.tangent());
          solver->solve(x[i], P[i], b, border.residual, border, 1e-10);
          EXPECT_LE(solver->statistics().n_iterations, 12u) << content;
          ++i;
        }
      const double size = x[0].l2_norm();
      x[1] -= x[0];
      EXPECT_LT(x[1].l2_norm(), 1e-7 * size) << content;
      for (unsigned int k = 0; k < P[0].size(); ++k)
        EXPECT_NEAR(P[0][k], P[1][k], 1e-7 * std::abs(P[0][k])) << content;
    }
}



TEST(Cavities, HaveTheVolumesOfTheirShapes)
{
  // x = A X keeps the planes of symmetry. On this mesh a circle is one of
  // parabolas through points of it, and all sections have one area.
  const double stretch[dim] = {1.3, 0.8, 1.15};
  const double volume = stretch[0] * stretch[1] * stretch[2];
  for (const std::string section : {"quarter", "half", "full"})
    {
      Chambers body(section, "");
      body.state.solution = 0.;
      const auto &space   = body.model->space;
      const auto  at_rest =
        cavity_volumes(body.model->body, space.with_ghosts(body.state.solution));
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : body.model->body.owned_cells())
        {
          cell.iterator->get_dof_indices(indices);
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto i = indices[space.displacement_dof[c][n]];
                if (space.locally_owned.is_element(i))
                  body.state.solution(i) =
                    (stretch[c] - 1.) *
                    body.model->shapes.node(cell.index, n)[c];
              }
        }
      const Vector relevant = space.with_ghosts(body.state.solution);
      const auto   volumes  = cavity_volumes(body.model->body, relevant);
      const auto   areas    = cavity_sections(body.model->body, relevant);
      const double part     =
        body.parameters.anatomy.geometry().symmetry_factor();
      for (unsigned int k = 0; k < 2; ++k)
        {
          const double cylinder = dealii::numbers::PI * 1.5 * 1.5 * 2.5;
          EXPECT_NEAR(at_rest[k] * part, cylinder, 1e-3 * cylinder);
          EXPECT_NEAR(volumes[k], volume * at_rest[k], 1e-12 * at_rest[k]);
          // Some of it lies in the planes of symmetry.
          EXPECT_NEAR(areas[k][0], volumes[k] / (2.5 * stretch[0]), 1e-12);
        }
    }
}



TEST(Cavities, BorderIsTheDerivativeOfTheResidual)
{
  for (const std::string section : {"quarter", "full"})
    for (const std::string &content :
         {std::string(),
          gas,
          compressible,
          contents_and_flows,
          gas_flows,
          pump,
          weight(section == "full" ? "0.003; 0.005; -0.01" : "0.02; 0; 0")})
      {
        Chambers                  body(section, content);
        const std::vector<double> P = body.state.globals.at(cavity_pressure);
        Tangent &tangent = body.model->assembler.tangent();
        body.model->assembler.linearise(body.state.solution, 1.);
        Vector       unused = body.free_part(body.state.solution);
        const Border border = body.model->cavities.border(
          body.state.solution, body.state.globals, 1., &tangent, unused);
        ASSERT_EQ(border.size(), 2u);

        // Along a motion of all unknowns together.
        const Vector              d  = body.random(1., 2);
        const std::vector<double> dP = {0.4, 0.7};
        const double              h  = 1e-6;
        Vector                    plus = body.state.solution, minus = plus;
        plus.add(h, d);
        minus.add(-h, d);
        std::vector<double> P_plus = P, P_minus = P;
        for (unsigned int k = 0; k < 2; ++k)
          {
            P_plus[k] += h * dP[k];
            P_minus[k] -= h * dP[k];
          }
        Vector     difference = body.free_part(d), r = difference;
        const auto s_plus  = body.residual(plus, P_plus, difference);
        const auto s_minus = body.residual(minus, P_minus, r);
        difference.add(-1., r);
        difference /= 2. * h;

        const Vector free = body.free_part(d);
        Vector       expected(free);
        tangent.vmult(expected, free);
        for (unsigned int k = 0; k < 2; ++k)
          border.columns[k].add_to(expected, dP[k]);
        expected = body.free_part(expected);
        Vector error = body.free_part(difference);
        error -= expected;
        EXPECT_LT(error.l2_norm(), 1e-7 * expected.l2_norm())
          << section << content;

        for (unsigned int k = 0; k < 2; ++k)
          {
            double s = dealii::Utilities::MPI::sum(border.rows[k].product(free),
                                                   body.comm);
            for (unsigned int l = 0; l < 2; ++l)
              s += border.corner(k, l) * dP[l];
            EXPECT_NEAR((s_plus[k] - s_minus[k]) / (2. * h),
                        s,
                        1e-7 * std::abs(s))
              << section << content;
          }
      }
}



TEST(Cavities, KeepTheTangentSymmetric)
{
  Chambers body("quarter", "");
  Tangent &tangent = body.model->assembler.tangent();
  body.model->assembler.linearise(body.state.solution, 1.);
  Vector unused = body.free_part(body.state.solution);
  body.model->cavities.border(
    body.state.solution, body.state.globals, 1., &tangent, unused);
  EXPECT_TRUE(tangent.symmetric);
  const Vector a = body.free_part(body.random(1., 3));
  const Vector b = body.free_part(body.random(1., 4));
  Vector       Ka(a), Kb(b);
  tangent.vmult(Ka, a);
  tangent.vmult(Kb, b);
  EXPECT_NEAR(b * Ka, a * Kb, 1e-12 * Ka.l2_norm() * b.l2_norm());
}



TEST(Cavities, PrescribedDisplacementsThatAreMissingPullAtThem)
{
  // The first iteration of a step takes what is prescribed whole: without the
  // part of the border it would end with other volumes, and the next iterations
  // would have to make up for it.
  Chambers body("quarter", R"(
subsection Boundary conditions
  set Names = hold, pull
  subsection hold
    set Boundary = head
    set Type     = displacement
  end
  subsection pull
    set Boundary = tail
    set Type     = displacement
    subsection displacement
      set Displacement = 1e-5*t; 0; 0
    end
  end
end
)");
  State state = body.model->rest_state();
  state.time  = 1.;
  const auto report = body.model->solve(state);
  EXPECT_LE(report.solves[0].newton.size(), 2u);
  // Were it left out, the first residual would be of the size of the load.
  EXPECT_LT(report.solves[0].newton[0].residual.border, 1e-9);
}
