// SPDX-License-Identifier: LGPL-2.1-or-later
// Global unknowns around equilibrium: the linear system against a dense one, with
// all linear solvers, also where the tangent alone is singular or nearly so; a
// multiplier that prescribes a mean displacement, in Newton's method; and the
// values in a checkpoint.
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/border.h>
#include <lumbricus/linear/linear_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "specimen.h"

using namespace lumbricus;

namespace
{
  const std::string block = R"(
subsection Geometry
  set Shape = block
  subsection block
    set Lengths     = 2, 1, 1
    set Cells       = 2, 1, 1
    set Tissue name = flesh
  end
end
subsection Tissues
  subsection flesh
    subsection Neo-Hooke
      set a = 1
    end
  end
end
subsection Boundary conditions
  set Names = push, wall
  subsection wall
    set Boundary = x min
    set Type     = displacement
  end
  subsection push
    set Boundary = y max
    set Type     = follower pressure
    subsection follower pressure
      set Pressure = 0.05*t
    end
  end
end
)";

  // A tangent that is not symmetric, and a border with nothing in common with it.
  class BorderedTangent : public Specimen, public ::testing::Test
  {
  public:
    static constexpr unsigned int n_globals = 3;

    BorderedTangent()
      : Specimen(block)
    {
      state.time = 1.;
      model->set_to(state);
      state.solution.add(1., random(0.01, 1));
      model->assembler.linearise(state.solution, state.time);
      b = free_part(2);
      for (unsigned int k = 0; k < n_globals; ++k)
        {
          border.columns.emplace_back(free_part(3 + k));
          border.rows.emplace_back(free_part(6 + k));
          c.push_back(1. + k);
        }
      border.corner.reinit(n_globals, n_globals);
      for (unsigned int k = 0; k < n_globals; ++k)
        for (unsigned int l = 0; l < n_globals; ++l)
          border.corner(k, l) = std::cos(1. + 3. * k + 7. * l);
      border.residual.resize(n_globals);
    }

    Vector
    free_part(const unsigned int seed) const
    {
      return Specimen::free_part(random(1., seed));
    }

    const Tangent &
    tangent() const
    {
      return model->assembler.tangent();
    }

    // The entries of all ranks.
    std::vector<double>
    all_of(const Vector &v) const
    {
      std::vector<double> all(v.size());
      for (const auto i : model->space.locally_owned)
        all[i] = v(i);
      dealii::Utilities::MPI::sum(all, comm, all);
      return all;
    }

    Vector
    dense(const BorderVector &sparse) const
    {
      Vector v(b);
      sparse.copy_to(v);
      return v;
    }

    // The solution of the whole system as one dense matrix.
    std::vector<double>
    dense_solution() const
    {
      const unsigned int               n = b.size();
      dealii::LAPACKFullMatrix<double> matrix(n + n_globals);
      Vector                       e(b), Ke(b);
      for (unsigned int j = 0; j < n; ++j)
        {
          e = 0.;
          if (model->space.locally_owned.is_element(j))
            e(j) = 1.;
          tangent().vmult(Ke, e);
          const auto column = all_of(Ke);
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, j) = column[i];
        }
      dealii::Vector<double> x(n + n_globals);
      const auto             of_b = all_of(b);
      std::copy(of_b.begin(), of_b.end(), x.begin());
      for (unsigned int k = 0; k < n_globals; ++k)
        {
          const auto column = all_of(dense(border.columns[k]));
          const auto row    = all_of(dense(border.rows[k]));
          for (unsigned int i = 0; i < n; ++i)
            {
              matrix(i, n + k) = column[i];
              matrix(n + k, i) = row[i];
            }
          for (unsigned int l = 0; l < n_globals; ++l)
            matrix(n + k, n + l) = border.corner(k, l);
          x[n + k] = c[k];
        }
      matrix.compute_lu_factorization();
      matrix.solve(x);
      return {x.begin(), x.end()};
    }

    // Solve, and compare with the dense solution.
    void
    check(LinearSolver &solver, const double tolerance)
    {
      const std::vector<double> exact = dense_solution();
      solver.reinit(tangent());
      Vector          x(b);
      std::vector<double> g;
      solver.solve(x, g, b, c, border, 1e-12);
      std::vector<double> found = all_of(x);
      found.insert(found.end(), g.begin(), g.end());
      double largest = 0., error = 0.;
      for (unsigned int i = 0; i < exact.size(); ++i)
        {
          largest = std::max(largest, std::abs(exact[i]));
          error   = std::max(error, std::abs(found[i] - exact[i]));
        }
      EXPECT_LT(error, tolerance * largest);
    }

    // Take all stiffness but the part eps from one motion, of a node that only
    // one cell has.
    void
    soften(const double eps)
    {
      const CellUnknowns &unknowns = tangent().unknowns;
      Vector          e(b), Ke(b);
      e                = 0.;
      const bool is_me = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
      if (is_me)
        e.local_element(unknowns.places(0)[0]) = 1.;
      tangent().vmult(Ke, e);
      const double eKe = e * Ke;
      Ke.update_ghost_values();
      if (!is_me)
        return;
      const unsigned int  n = CellUnknowns::n_per_cell;
      std::vector<double> v(n);
      unknowns.read_free(0, Ke, v.data());
      // The assembler's own, which is to be changed just here.
      auto &matrix = const_cast<Tangent &>(tangent()).surface_matrix(0);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix[i * n + j] -= (1. - eps) * v[i] * v[j] / eKe;
    }

    Vector          b;
    std::vector<double> c;
    Border              border;
  };



  TEST_F(BorderedTangent, IsSolvedByAllSolversAsADenseSystem)
  {
    for (const std::string &name : Registry<LinearSolver>::names())
      {
        const auto solver = Registry<LinearSolver>::create(name);
        check(*solver, 1e-8);
        // Its factors are kept: one would be enough.
        if (name == "kept factor")
          {
            EXPECT_LE(solver->statistics().n_factorisations, 2u);
          }
      }
  }



  TEST_F(BorderedTangent, IsTheTangentWhereTheBorderHasNoUnknowns)
  {
    const auto solver = Registry<LinearSolver>::create("direct");
    solver->reinit(tangent());
    Vector              x(b), alone(b);
    std::vector<double> g(1, 1.);
    solver->solve(x, g, b, {}, Border(), 1e-12);
    solver->solve(alone, b, 1e-12);
    EXPECT_TRUE(g.empty());
    EXPECT_GT(x.l2_norm(), 0.);
    alone -= x;
    // Ranks add in the order in which messages come.
    EXPECT_LT(alone.l2_norm(), 1e-11 * x.l2_norm());
  }



  TEST_F(BorderedTangent, IsSolvedWithoutARightHandSideOfTheBody)
  {
    b = 0.;
    check(*Registry<LinearSolver>::create("kept factor"), 1e-8);
  }



  TEST_F(BorderedTangent, MayHaveATangentThatIsNearlySingular)
  {
    // Close to a limit point, where the loads cannot be given.
    soften(1e-10);
    for (const std::string name : {"direct", "kept factor"})
      check(*Registry<LinearSolver>::create(name), 1e-6);
  }



  TEST_F(BorderedTangent, IsSolvedOrRefusedWhereTheTangentIsSingular)
  {
    soften(0.);
    for (const std::string name : {"direct", "kept factor"})
      try
        {
          check(*Registry<LinearSolver>::create(name), 1e-6);
        }
      catch (const ExcNotConverged &exception)
        {
          // Which of the two says it hangs on rounding.
          const std::string message = plain_message(exception);
          EXPECT_TRUE(message.find("The linear s") == 0 ||
                      message.find("The tangent matrix is singular") == 0)
            << message;
        }
  }



  TEST_F(BorderedTangent, HasToDetermineItsUnknowns)
  {
    // Two rows that say the same.
    border.rows[1] = border.rows[0];
    for (unsigned int l = 0; l < n_globals; ++l)
      border.corner(1, l) = border.corner(0, l);
    const auto solver = Registry<LinearSolver>::create("direct");
    solver->reinit(tangent());
    Vector          x(b);
    std::vector<double> g;
    EXPECT_THROW(
      solver->solve(x, g, b, c, border, 1e-12),
      ExcNotConverged);
  }



  // One force on the face x = 2, such that its mean displacement is what it is
  // to be; the force is spread evenly or, with a slope, more on one side, which
  // makes the border unsymmetric.
  class MeanDisplacement : public BorderSource
  {
  public:
    MeanDisplacement(Specimen    &body,
                     const double displacement,
                     const double slope)
      : comm(body.comm)
      , displacement(displacement)
    {
      const MixedSpace &space    = body.model->space;
      const auto       &unknowns = body.model->assembler.tangent().unknowns;
      unknowns.reinit_vector(mean);
      unknowns.reinit_vector(force);
      dealii::FEFaceValues<dim> values(space.mapping,
                                       space.fe,
                                       space.face_quadrature,
                                       dealii::update_values |
                                         dealii::update_quadrature_points |
                                         dealii::update_JxW_values);
      unsigned int cell_index = 0;
      for (const auto &cell : space.dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          const unsigned int i = cell_index++;
          for (const unsigned int f : cell->face_indices())
            {
              if (!cell->face(f)->at_boundary() ||
                  std::abs(cell->face(f)->center()[0] - 2.) > 1e-10)
                continue;
              values.reinit(cell, f);
              std::vector<double> of_mean(CellUnknowns::n_per_cell),
                of_force(CellUnknowns::n_per_cell);
              for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                for (const unsigned int q : values.quadrature_point_indices())
                  {
                    const double N_dA =
                      values.shape_value(space.displacement_dof[0][n], q) *
                      values.JxW(q);
                    const auto place = CellUnknowns::displacement(0, n);
                    of_mean[place] += N_dA;
                    of_force[place] +=
                      (1. + slope * (values.quadrature_point(q)[1] - 0.5)) *
                      N_dA;
                  }
              unknowns.add(i, of_mean.data(), mean);
              unknowns.add(i, of_force.data(), force);
            }
        }
      mean.compress(dealii::VectorOperation::add);
      force.compress(dealii::VectorOperation::add);
    }

    Globals
    globals_at_rest() const override
    {
      return {{"pull", {0.}}};
    }

    double
    of(const Vector &solution) const
    {
      double sum = 0.;
      for (unsigned int i = 0; i < mean.locally_owned_size(); ++i)
        sum += mean.local_element(i) * solution.begin()[i];
      return dealii::Utilities::MPI::sum(sum, comm);
    }

    Border
    border(const Vector   &solution,
           const Globals  &globals,
           const LoadTime &t,
           Tangent        *tangent,
           Vector         &r) override
    {
      for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
        r.local_element(i) +=
          globals.at("pull")[0] * force.local_element(i);
      Border border;
      border.names    = {{"pull", 1}};
      border.residual = {of(solution) - displacement * t.to()};
      border.scale    = {2.};
      border.rounding = {2. * std::numeric_limits<double>::epsilon()};
      if (tangent != nullptr)
        {
          border.columns = {BorderVector(force)};
          border.rows    = {BorderVector(mean)};
          border.corner.reinit(1, 1);
        }
      return border;
    }

  private:
    const MPI_Comm comm;
    const double   displacement;
    Vector         mean, force;
  };



  TEST(Bordered, NewtonsMethodPrescribesAMeanDisplacement)
  {
    for (const double slope : {0., 1.5})
      for (const std::string method : {"direct", "auto"})
        {
          Specimen body(block + "subsection Linear solver\n set Method = " +
                        method + "\nend\n");
          ChainModel      &model = *body.model;
          MeanDisplacement mean(body, 0.3, slope);
          model.equilibrium.set_borders({&mean});
          State &state  = body.state;
          state.globals = model.equilibrium.globals_at_rest();
          state.time    = 1.;
          const auto report = model.solve(state);
          EXPECT_NEAR(mean.of(state.solution), 0.3, 1e-10);

          // It pulls, and all others hold that.
          const double pull = state.globals.at("pull")[0];
          EXPECT_LT(pull, -0.1);
          double others = 0.;
          for (const ExternalForce &force : model.forces_on_body(state))
            others += force.force[0];
          EXPECT_NEAR(others, pull, 1e-8);

          // The order is 2, which a wrong border would spoil.
          const auto &newton = report.solves.back().newton;
          EXPECT_LE(newton.size(), 7u);
          if (method == "direct")
            {
              const std::size_t n = newton.size();
              EXPECT_LT(newton[n - 1].increment,
                        100. * std::pow(newton[n - 2].increment, 2));
            }

          // A converged state is one: nothing is left to do.
          State again = state;
          EXPECT_EQ(model.solve(again).solves.back().newton.size(), 0u);
          EXPECT_EQ(again.globals, state.globals);

          // As a load, the same force gives that mean displacement.
          std::ostringstream load;
          load.precision(17);
          load << "subsection Boundary conditions\n"
               << " set Names = pull, push, wall\n"
               << " subsection pull\n  set Boundary = x max\n"
               << "  set Type = dead traction\n  subsection dead traction\n"
               << "   set Traction = " << -pull << "*t*(1 + " << slope
               << "*(y - 0.5)); 0; 0\n  end\n end\nend\n";
          Specimen loaded(block + load.str());
          loaded.state.time = 1.;
          loaded.model->solve(loaded.state);
          EXPECT_NEAR(mean.of(loaded.state.solution), 0.3, 1e-8);
        }
  }



  TEST(Bordered, AppendsTheUnknownsOfAnother)
  {
    Border one, two;
    one.names    = {{"p", 2}};
    one.residual = {1., 2.};
    one.corner.reinit(2, 2);
    one.corner(0, 1) = 3.;
    two.names        = {{"q", 1}};
    two.residual     = {4.};
    two.corner.reinit(1, 1);
    two.corner(0, 0) = 5.;
    one.append(two);
    EXPECT_EQ(one.size(), 3u);
    EXPECT_EQ(one.corner(0, 1), 3.);
    EXPECT_EQ(one.corner(2, 2), 5.);
    EXPECT_EQ(one.corner(0, 2), 0.);
    const Globals globals = {{"p", {6., 7.}}, {"q", {8.}}};
    EXPECT_EQ(one.read(globals), (std::vector<double>{6., 7., 8.}));
    EXPECT_EQ(one.write(one.read(globals)), globals);
  }



  TEST(Globals, AreInACheckpointToTheLastBit)
  {
    RunProgress progress;
    progress.control = "time";
    progress.numbers = {{"step_size", 0.1}};
    progress.globals = {{"pressure", {0.1 + 0.2, -1. / 3., 5e-324}},
                        {"slope", {-0.}}};
    for (const auto &name : NodalHistory::names())
      progress.histories.insert(name);
    std::ostringstream out;
    progress.write(out);
    const std::string text = out.str();
    EXPECT_EQ(RunProgress::read(text).globals, progress.globals);
    EXPECT_EQ(RunProgress::read(text).numbers, progress.numbers);

    for (const std::string wrong :
         {"global slope 1 2\n",
          "global a 0\n",
          "global a 2 1\n",
          "global a 1 1 1\n",
          "global a 1 nan\n",
          "global a 1e9 1\n",
          "global a -1 1\n",
          "global a\n",
          "number step_size 1\n",
          "number radius 1\n"})
      EXPECT_THROW(RunProgress::read(text + wrong), ExcDamaged) << wrong;
  }



  TEST(Globals, GoFromMeshToMesh)
  {
    Specimen body(block + "subsection Adaptivity\n set Every = 1\nend\n");
    body.state.globals = {{"pressure", {0.1, 0.2}}};
    const Globals before = body.state.globals;
    for (const auto &cell : body.model->triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        cell->set_refine_flag();
    change_mesh(
      body.model->triangulation,
      body.model->space,
      [&]() { body.model->number_unknowns(); },
      body.state);
    EXPECT_EQ(body.state.globals, before);
  }
} // namespace
