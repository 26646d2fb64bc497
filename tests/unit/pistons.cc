// SPDX-License-Identifier: LGPL-2.1-or-later
// The volume of a liquid without cells between two pistons: its derivatives by any
// displacement, those of the rims too, against finite differences; what a piston
// feels; and pistons that do not stay plane.
#include <lumbricus/cavities/cavities.h>
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/cavity_volume.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "read_plugin.h"
#include "specimen.h"

using namespace lumbricus;

namespace
{
  // The displacements that are prescribed at both ends, as formulas of x.
  std::string
  ends(const std::string &head, const std::string &tail)
  {
    std::string text = "subsection Boundary conditions\n"
                       "  set Names = front, rear\n";
    for (const auto &[name, boundary, ux] :
         {std::tuple{"front", "head", head}, std::tuple{"rear", "tail", tail}})
      text += std::string("  subsection ") + name +
              "\n    set Boundary = " + boundary +
              "\n    set Type = displacement\n    subsection displacement\n"
              "      set Components = x\n      set Displacement = " +
              ux + "; 0; 0\n    end\n  end\n";
    return text + "end\n";
  }



  std::string
  tube(const std::string &section)
  {
    return R"(
subsection Geometry
  set Shape = open cylinder
  subsection open cylinder
    set Radius                   = 1.5
    set Length                   = 2
    set Wall layers              = wall
    set Wall layer thicknesses   = 0.3
    set Cells around a quarter   = 2
    set Cells along the cylinder = 2
    set Liquid                   = cavity
    set Cross-section            = )" +
           section + R"(
  end
end
subsection Mesh
  set Local refinements = 1
  set Refine where      = x - 1
end
)";
  }



  // A tube in a state that is no equilibrium.
  class Tube : public Specimen
  {
  public:
    explicit Tube(const std::string &section)
      : Specimen(tube(section) + ends("0", "0.1*t"))
      , wall(parameters.anatomy.geometry().cavities().at(0))
    {
      state.globals = model->equilibrium.globals_at_rest();
      state.globals.at(cavity_pressure) = {0.03};
      model->set_to(state);
      state.solution = anything(0.01, 1);
    }

    // A vector that obeys no constraints, the same on any number of ranks.
    Vector
    anything(const double size, const unsigned int seed) const
    {
      Vector v(model->space.locally_owned, comm);
      for (const auto i : model->space.locally_owned)
        v(i) = size * std::sin(1. + 12.9898 * i + 78.233 * seed);
      return v;
    }

    double
    volume(const Vector &solution) const
    {
      return cavity_volumes(model->body, model->space.with_ghosts(solution))[0];
    }

    // dV along d, and d^2V along d and e.
    std::array<double, 2>
    derivatives(const Vector &solution, const Vector &d, const Vector &e) const
    {
      constexpr unsigned int n     = CellUnknowns::n_per_cell;
      const MixedSpace      &space = model->space;
      const Vector           u     = space.with_ghosts(solution);
      const Vector           ghosted[2] = {space.with_ghosts(d),
                                           space.with_ghosts(e)};
      SurfaceKernel          surface(space);
      ElementKernel          kernel;
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell());
      std::vector<double> sums(2, 0.);
      CavityFaces(parameters.anatomy.geometry())
        .for_each(model->body,
                  [&](const OwnedCell   &cell,
                      const unsigned int face,
                      const unsigned int /*k*/) {
                    std::vector<double> first(n, 0.), second(n * n, 0.);
                    kernel.read(space, cell.iterator, u, indices);
                    surface.reinit(cell.iterator, face);
                    for (unsigned int q = 0; q < surface.n_points(); ++q)
                      {
                        surface.set(q, kernel.u);
                        add_volume_derivative(surface, wall, first.data());
                        add_volume_second_derivative(surface, wall, 1., second);
                      }
                    std::vector<double> along[2];
                    for (unsigned int i = 0; i < 2; ++i)
                      {
                        along[i].resize(n, 0.);
                        for (unsigned int m = 0; m < MixedSpace::n_nodes; ++m)
                          for (unsigned int c = 0; c < dim; ++c)
                            along[i][CellUnknowns::displacement(c, m)] =
                              ghosted[i](
                                indices[space.displacement_dof[c][m]]);
                      }
                    for (unsigned int i = 0; i < n; ++i)
                      {
                        sums[0] += first[i] * along[0][i];
                        sums[1] += along[0][i] *
                                   std::inner_product(along[1].begin(),
                                                      along[1].end(),
                                                      &second[i * n],
                                                      0.);
                      }
                  });
      dealii::Utilities::MPI::sum(sums, comm, sums);
      return {{sums[0], sums[1]}};
    }

    // All nodes of the head move towards x by one.
    Vector
    head_moves() const
    {
      Vector v(model->space.locally_owned, comm);
      for (const Supports::Prescribed &entry :
           model->supports.prescribed_unknowns())
        if (entry.component == 0 && entry.X[0] == 0. &&
            model->space.locally_owned.is_element(entry.index))
          v(entry.index) = 1.;
      return v;
    }

    const CavityWall wall;
  };
} // namespace



TEST(Pistons, HaveAVolumeWithTheseDerivatives)
{
  for (const std::string section : {"quarter", "full"})
    {
      const Tube   body(section);
      const Vector d = body.anything(1., 2), e = body.anything(1., 3);
      const double h    = 1e-5;
      Vector       plus = body.state.solution, minus = plus;
      plus.add(h, d);
      minus.add(-h, d);
      const auto [first, mixed] =
        body.derivatives(body.state.solution, d, e);
      EXPECT_NEAR((body.volume(plus) - body.volume(minus)) / (2. * h),
                  first,
                  1e-7 * std::abs(first));
      EXPECT_NEAR((body.derivatives(plus, e, d)[0] -
                   body.derivatives(minus, e, d)[0]) /
                    (2. * h),
                  mixed,
                  1e-7 * std::abs(mixed));
      EXPECT_NEAR(body.derivatives(body.state.solution, e, d)[1],
                  mixed,
                  1e-12 * std::abs(mixed));
    }
}



TEST(Pistons, FeelThePressureOnAllOfTheirArea)
{
  for (const std::string section : {"quarter", "half", "full"})
    {
      Tube body(section);
      body.state.solution = 0.;
      const double V      = body.volume(body.state.solution);
      const double part =
        body.parameters.anatomy.geometry().symmetry_factor();
      const double cylinder = dealii::numbers::PI * 1.5 * 1.5 * 2. / part;
      EXPECT_NEAR(V, cylinder, 1e-3 * cylinder);
      const Vector d = body.head_moves();
      EXPECT_NEAR(body.derivatives(body.state.solution, d, d)[0],
                  -V / 2.,
                  1e-12 * V);
    }
}



TEST(Pistons, BorderIsTheDerivativeOfTheResidual)
{
  Tube body("quarter");
  body.state.solution = body.random(0.002, 1);
  Tangent &tangent    = body.model->assembler.tangent();
  body.model->assembler.linearise(body.state.solution, 1.);
  Vector       unused = body.free_part(body.state.solution);
  const Border border = body.model->cavities.border(
    body.state.solution, body.state.globals, 1., &tangent, unused);
  EXPECT_TRUE(tangent.symmetric);

  const Vector d = body.random(1., 2);
  const double h = 1e-6;
  Vector       forces[2];
  double       volumes[2];
  for (const unsigned int i : {0, 1})
    {
      Vector moved = body.state.solution;
      moved.add(i == 0 ? h : -h, d);
      forces[i] = body.free_part(d);
      EXPECT_TRUE(body.model->assembler.residual(moved, 1., forces[i]).valid());
      volumes[i] = body.model->cavities
                     .border(moved, body.state.globals, 1., nullptr, forces[i])
                     .residual[0];
    }
  Vector difference(forces[0]);
  difference.add(-1., forces[1]);
  difference /= 2. * h;
  const Vector free = body.free_part(d);
  Vector       expected(free);
  tangent.vmult(expected, free);
  expected     = body.free_part(expected);
  Vector error = body.free_part(difference);
  error -= expected;
  EXPECT_LT(error.l2_norm(), 1e-7 * expected.l2_norm());
  const double s =
    dealii::Utilities::MPI::sum(border.rows[0].product(free), body.comm);
  EXPECT_NEAR((volumes[0] - volumes[1]) / (2. * h), s, 1e-7 * std::abs(s));
}



TEST(Pistons, TakeWhatIsPrescribedAtOnce)
{
  // The rims move by what is prescribed, and room is made for that in the first
  // iteration: without the forces on the rims it would end with a volume that is
  // wrong by the area times the displacement.
  Specimen body(tube("quarter") + ends("0", "1e-5*t"));
  State    state = body.model->rest_state();
  state.time     = 1.;
  const auto report = body.model->solve(state);
  EXPECT_LE(report.solves[0].newton.size(), 2u);
  EXPECT_LT(report.solves[0].newton[0].residual.border, 1e-9);
}



TEST(Pistons, HaveToStayPlane)
{
  const std::string loose = input_error([]() { Specimen body(tube("full")); });
  for (const std::string part :
       {"segment 1", "'head'", "'displacement'", "'Components' have x"})
    EXPECT_TRUE(contains(loose, part)) << loose;
  const std::string tilted = input_error(
    []() { Specimen body(tube("full") + ends("0.01*y", "0")); });
  for (const std::string part :
       {"'head'", "not the same all over", "-0.015 to 0.015", "on t only"})
    EXPECT_TRUE(contains(tilted, part)) << tilted;
}
