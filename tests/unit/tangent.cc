// SPDX-License-Identifier: LGPL-2.1-or-later
// The linearisation of equilibrium as an operator, as matrices of cells, and
// as what the linear solvers solve: against finite differences and each other.
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/volume_term.h>

#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "read_plugin.h"
#include "specimen.h"

using namespace lumbricus;

namespace
{
  const std::string segment = R"(
subsection Geometry
  set Shape = segment chain
  subsection segment chain
    set Wall layers            = wall
    set Wall layer thicknesses = 0.3
    set Septum thickness       = 0.3
    set Cap thickness          = 0.3
    set Cross-section          = quarter
    set Cells around a quarter = 2
  end
end
subsection Mesh
  set Local refinements = 1
  set Refine where      = min(y - z, 4 - x)
end
subsection Muscles
  subsection circular
    set Fibres         = circumferential
    set Active stretch = expression
    subsection expression
      set Formula = 1 - 0.1*t
    end
  end
end
subsection Tissues
  subsection wall
    set Muscles = circular
  end
  subsection liquid
    subsection Neo-Hooke
      set a = 0.0023
    end
  end
end
)";

  // A condition that presses onto a boundary along its normal.
  std::string
  pressing(const std::string &boundary)
  {
    return R"(
  subsection )" +
           boundary + R"(
    set Boundary = )" +
           boundary + R"(
    set Type     = follower pressure
    subsection follower pressure
      set Pressure = 0.01*t
    end
  end
)";
  }

  // Conditions in their section.
  std::string
  conditions(const std::string &names, const std::string &sections)
  {
    return "\nsubsection Boundary conditions\n  set Names = " + names +
           sections + "end\n";
  }

  const std::string pressure = conditions("skin", pressing("skin"));

  // The same, on all of the surface that is no plane of symmetry.
  const std::string pressure_around =
    conditions("head, tail, skin",
               pressing("head") + pressing("tail") + pressing("skin"));

  // The same, on the skin, whose ends are held.
  const std::string pressure_between =
    conditions("skin, front, rear", pressing("skin") + R"(
  subsection front
    set Boundary = head
    set Type     = displacement
  end
  subsection rear
    set Boundary = tail
    set Type     = displacement
  end
)");

  // A force that follows the place, and not as springs do.
  class Whirl : public VolumeTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    void
    volume(const VolumePoint &point, VolumeResponse &response) const override
    {
      response.db_du[0][1] = 0.02;
      response.db_du[1][0] = -0.05;
      response.db_du[2][2] = 0.03 * point.t.to();
      response.b           = response.db_du * (point.X + point.u);
    }

    bool
    symmetric() const override
    {
      return false;
    }
  };

  const Register<VolumeTerm, Whirl> whirl_term("whirl", "for this test.");

  const std::string whirl = R"(
subsection Body forces
  set Names = turn
  subsection turn
    set Type = whirl
  end
end
subsection Boundary conditions
  set Check symmetry = false
end
)";

  // The skin goes into the wall of a pipe by less than a twentieth of its
  // thickness, and by more than it moves.
  std::string
  in_pipe(const std::string &friction)
  {
    return conditions("wall", R"(
  subsection wall
    set Boundary = skin
    set Type     = contact
    subsection contact
      set Obstacle = burrow
      subsection burrow
        set Radius = 2.29
      end
)" + friction + R"(
    end
  end
)");
  }

  const std::string smooth_pipe = in_pipe("");

  // All of it sticks: the elastic slip is larger than what it moves.
  const std::string rough_pipe = in_pipe(R"(
      set Friction       = 0.6, 2.4, 1.2
      set Shear strength = 0.01, 0.04, 0.02
      set Elastic slip   = 0.1
)");

  const std::string reference_slip = R"(
subsection Interface
  set Coupling = reference slip
end
)";

  // A closed segment with hanging nodes, a muscle and liquid, in a state that
  // is no equilibrium.
  class Sample : public Specimen
  {
  public:
    explicit Sample(const std::string &text)
      : Specimen(text)
    {
      state.time = 0.5;
      model->set_to(state);
      // With more, the pressures of noise are no longer small beside the
      // stiffness of the liquid, which is no state that a run comes to.
      x = random(0.001, 1);
      state.solution.add(1., x);
    }

    Vector
    residual(const Vector &at)
    {
      Vector r(model->space.locally_owned, comm);
      EXPECT_TRUE(model->assembler.residual(at, state.time, r).valid());
      return r;
    }

    Vector x;
  };



  class Tangents : public ::testing::TestWithParam<const char *>
  {
  protected:
    Tangents()
      : body(sample())
    {
      body.model->assembler.linearise(body.state.solution, body.state.time);
    }

    // None of the tests changes it.
    static Sample &
    sample()
    {
      auto &sample = samples[GetParam()];
      if (!sample)
        sample = std::make_unique<Sample>(segment + GetParam());
      return *sample;
    }

    static void
    TearDownTestSuite()
    {
      samples.clear();
    }

    const Tangent &
    tangent() const
    {
      return body.model->assembler.tangent();
    }

    // Making one takes longer than most tests.
    static inline std::map<std::string, std::unique_ptr<Sample>> samples;

    Sample &body;
  };

  INSTANTIATE_TEST_SUITE_P(Loads,
                           Tangents,
                           ::testing::Values("",
                                             pressure.c_str(),
                                             pressure_around.c_str(),
                                             pressure_between.c_str(),
                                             whirl.c_str(),
                                             smooth_pipe.c_str(),
                                             rough_pipe.c_str(),
                                             slip.c_str(),
                                             reference_slip.c_str()));



  TEST_P(Tangents, IsTheDerivativeOfTheResidual)
  {
    // Where normals follow the deformation the constraints do too, see
    // Interface below.
    if (GetParam() == slip)
      return;
    const Vector d    = body.random(1., 2);
    const double h    = 1e-7;
    Vector       plus = body.state.solution, minus = plus;
    plus.add(h, d);
    minus.add(-h, d);
    Vector difference = body.residual(plus);
    difference.add(-1., body.residual(minus));
    difference /= 2. * h;

    Vector Kd = body.free_part(d);
    tangent().vmult(Kd, body.free_part(d));
    Vector expected = body.free_part(difference);
    Kd -= expected;
    EXPECT_LT(Kd.l2_norm(), 1e-7 * expected.l2_norm());
  }



  TEST_P(Tangents, IsSymmetricUnlessLoadsFollow)
  {
    const Vector a = body.free_part(body.random(1., 3));
    const Vector b = body.free_part(body.random(1., 4));
    Vector       Ka(a), Kb(b);
    tangent().vmult(Ka, a);
    tangent().vmult(Kb, b);
    const double scale = Ka.l2_norm() * b.l2_norm();
    EXPECT_EQ(tangent().symmetric,
              GetParam() != pressure && GetParam() != whirl &&
                GetParam() != rough_pipe);
    if (tangent().symmetric)
      EXPECT_NEAR(Ka * b, Kb * a, 1e-14 * scale);
    else
      EXPECT_GT(std::abs(Ka * b - Kb * a), 1e-9 * scale);
  }



  TEST_P(Tangents, MatricesOfCellsAddUpToTheOperator)
  {
    const CellUnknowns &unknowns = tangent().unknowns;
    Vector              a        = body.free_part(body.random(1., 5));
    Vector              Ka(a), sum(a);
    std::vector<double> K;
    tangent().vmult(Ka, a);
    a.update_ghost_values();
    sum = 0.;
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      {
        tangent().cell_matrix(i, K);
        unknowns.apply_constraints(i, K);
        const auto         places = unknowns.free_unknowns(i);
        const unsigned int n      = places.size();
        for (unsigned int r = 0; r < n; ++r)
          for (unsigned int s = 0; s < n; ++s)
            sum.local_element(places[r]) +=
              K[r * n + s] * a.local_element(places[s]);
      }
    sum.compress(dealii::VectorOperation::add);
    sum -= Ka;
    EXPECT_LT(sum.l2_norm(), 1e-13 * Ka.l2_norm());
  }



  TEST_P(Tangents, DiagonalsAreThoseOfTheMatrices)
  {
    const unsigned int  n = Tangent::n_per_cell;
    std::vector<double> K;
    for (unsigned int i = 0; i < tangent().unknowns.n_cells(); ++i)
      {
        tangent().cell_matrix(i, K);
        const auto d = tangent().diagonal(i);
        for (unsigned int k = 0; k < n; ++k)
          EXPECT_NEAR(d[k], K[k * n + k], 1e-13 * (1. + std::abs(d[k])));
      }
  }



  TEST(FlowingLiquid, IsStifferInMatricesThanInTheOperator)
  {
    // At rest: the operator has a ten-thousandth of the stiffness S that the liquid has
    // against shear where it does not flow, the matrix has it twice.
    Specimen                  body(segment);
    ChainModel               &model   = *body.model;
    const Tangent            &tangent = model.assembler.tangent();
    constexpr unsigned int    n       = Tangent::n_per_cell;
    std::vector<double>       x(n), flowing(n), K;
    std::vector<std::vector<double>> solid;
    for (unsigned int k = 0; k < n; ++k)
      x[k] = std::sin(1. + k * k);
    model.set_to(body.state);
    model.assembler.linearise(body.state.solution, 0.);
    for (const OwnedCell cell : model.body.owned_cells())
      {
        solid.emplace_back(n);
        tangent.vmult_cell(cell.index, x.data(), solid.back().data());
      }
    model.references.let_liquid_flow(true);
    model.assembler.linearise(body.state.solution, 0.);
    for (const OwnedCell cell : model.body.owned_cells())
      {
        tangent.vmult_cell(cell.index, x.data(), flowing.data());
        tangent.cell_matrix(cell.index, K);
        const auto d = tangent.diagonal(cell.index);
        for (unsigned int r = 0; r < n; ++r)
          EXPECT_NEAR(d[r], K[r * n + r], 1e-13 * (1. + std::abs(d[r])));
        double largest = 0.;
        for (unsigned int r = 0; r < n; ++r)
          {
            double matrix = 0.;
            for (unsigned int s = 0; s < n; ++s)
              matrix += K[r * n + s] * x[s];
            const double S = (solid[cell.index][r] - flowing[r]) / 0.9999;
            EXPECT_NEAR(matrix - flowing[r], 1.9999 * S, 1e-12);
            largest = std::max(largest, std::abs(S));
          }
        if (cell.is_liquid)
          EXPECT_GT(largest, 1e-4);
        else
          EXPECT_EQ(largest, 0.);
      }
  }



  TEST_P(Tangents, AllLinearSolversAgree)
  {
    // A matrix like that of pressure_between.
    if (GetParam() == pressure_around)
      return;
    const Vector     b      = body.free_part(body.random(1., 6));
    const auto       direct = Registry<LinearSolver>::create("direct");
    direct->reinit(tangent());
    Vector exact(b);
    direct->solve(exact, b, 1e-6);
    for (const std::string &name : Registry<LinearSolver>::names())
      {
        const auto solver = Registry<LinearSolver>::create(name);
        solver->reinit(tangent());
        Vector x(b), r(b);
        solver->solve(x, b, 1e-10);
        tangent().vmult(r, x);
        r -= b;
        EXPECT_LT(r.l2_norm(), 2e-10 * b.l2_norm()) << name;
        x -= exact;
        EXPECT_LT(x.l2_norm(), 1e-6 * exact.l2_norm()) << name;
        EXPECT_EQ(solver->statistics().n_solves, 1u) << name;
      }
  }



  // Under slip the wall's reaction turns with the surface of the liquid. A
  // hydrostatic liquid is in equilibrium wherever its nodes have slipped to, so
  // that slipping meets no force but that of shear, of which there is next to
  // none. With the normals held where they are each increment met the pressure
  // instead: the nodes slipped p / mu times too far or too short, and the state
  // that a run came to was not that of shorter steps.
  TEST(Interface, LetsAHydrostaticLiquidSlip)
  {
    const double p0 = 0.01, mu = 1e-9;
    Sample       body(segment + slip +
                "subsection Tissues\n subsection liquid\n"
                "  subsection Neo-Hooke\n   set a = 1e-9\n  end\n end\nend\n");
    auto        &model = *body.model;
    const auto  &space = model.space;
    Vector       p(space.locally_owned, body.comm), slips(p);
    const double mode =
      space.fe.shape_value(space.pressure_dof[0], dealii::Point<dim>());
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    std::vector<bool> of_liquid(space.locally_owned.n_elements(), false);
    Vector            state = body.state.solution;
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() &&
          body.parameters.anatomy.is_liquid(
            Region::of(cell->material_id()).tissue))
        {
          cell->get_dof_indices(indices);
          for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
            state(indices[space.pressure_dof[m]]) = m == 0 ? p0 / mode : 0.;
          for (unsigned int c = 0; c < dim; ++c)
            for (const unsigned int k : space.displacement_dof[c])
              if (space.locally_owned.is_element(indices[k]))
                of_liquid[space.locally_owned.index_within_set(indices[k])] =
                  true;
        }
    model.equilibrium.start_from(state);
    model.assembler.linearise(state, body.state.time);

    // Only the liquid moves.
    Vector d = body.free_part(body.random(1., 7));
    for (unsigned int i = 0; i < of_liquid.size(); ++i)
      if (!of_liquid[i])
        d.local_element(i) = 0.;
    const auto force_on_liquid = [&]() {
      Vector Kd(d);
      model.assembler.tangent().vmult(Kd, d);
      double sum = 0.;
      for (unsigned int i = 0; i < of_liquid.size(); ++i)
        if (of_liquid[i])
          sum += Kd.local_element(i) * Kd.local_element(i);
      return std::sqrt(dealii::Utilities::MPI::sum(sum, body.comm));
    };
    const double shear = 1e2 * mu * d.l2_norm();
    EXPECT_LT(force_on_liquid(), shear);
    // It is not small by itself.
    const_cast<Tangent &>(model.assembler.tangent()).clear_surface_matrices();
    EXPECT_GT(force_on_liquid(), 1e3 * shear);
  }



  // First seen with the paper's filled cylinder on two ranks: vectors kept the
  // ghost entries of the interface before its normals were renewed, and cells
  // added to places that were no longer theirs.
  TEST(Vectors, FollowTheConstraints)
  {
    Sample body(segment + slip);
    auto  &model = *body.model;
    for (unsigned int k = 0; k < 3; ++k)
      {
        body.state.solution.add(1., body.random(0.02, k));
        model.equilibrium.start_from(body.state.solution);
        model.assembler.linearise(body.state.solution, body.state.time);
        Vector fresh;
        model.assembler.tangent().unknowns.reinit_vector(fresh);
        EXPECT_TRUE(model.assembler.right_hand_side()
                      .get_partitioner()
                      ->is_globally_compatible(*fresh.get_partitioner()));
      }
  }
} // namespace
