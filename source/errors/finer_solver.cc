// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/errors/finer_solver.h>
#include <lumbricus/linear/bordered_system.h>
#include <lumbricus/linear/flexible_gmres.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    // v times, or divided by, the factors of the free and the global unknowns.
    void
    multiply(BorderedVector            &v,
             const Vector              &free,
             const std::vector<double> &global,
             const bool                 divide)
    {
      for (unsigned int k = 0; k < v.block(0).locally_owned_size(); ++k)
        v.block(0).local_element(k) *=
          divide ? 1. / free.local_element(k) : free.local_element(k);
      for (unsigned int k = 0; k < v.block(1).locally_owned_size(); ++k)
        v.block(1).local_element(k) *= divide ? 1. / global[k] : global[k];
    }
  } // namespace



  FinerSolver::FinerSolver(const OnLargeCells &on_large_cells,
                           const unsigned int  n_iterations)
    : on_large_cells(on_large_cells)
    , n_iterations(n_iterations)
  {}



  void
  FinerSolver::set_cells(const Body &small, const CutCells &new_cells)
  {
    cells      = &new_cells;
    enrichment = std::make_unique<Enrichment>(small, *tangent, new_cells);
  }



  void
  FinerSolver::reinit(const Tangent &new_tangent)
  {
    tangent = &new_tangent;
  }



  Vector
  FinerSolver::scale() const
  {
    constexpr unsigned int n       = CellUnknowns::n_per_cell;
    constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
    Vector                 factors;
    tangent->unknowns.reinit_vector(factors);
    for (unsigned int i = 0; i < tangent->unknowns.n_cells(); ++i)
      {
        auto       d    = tangent->diagonal(i);
        const auto mass = tangent->pressure_mass(i);
        for (unsigned int m = 0; m < n_modes; ++m)
          d[CellUnknowns::pressure(m)] =
            mass[m * n_modes + m] / tangent->shear_modulus[i];
        for (unsigned int k = 0; k < n; ++k)
          factors.local_element(tangent->unknowns.places(i)[k]) += std::abs(d[k]);
      }
    factors.compress(dealii::VectorOperation::add);
    for (unsigned int k = 0; k < factors.locally_owned_size(); ++k)
      factors.local_element(k) = 1. / std::sqrt(factors.local_element(k));
    return factors;
  }



  void
  FinerSolver::solve(Vector &x, const Vector &b, const double tolerance)
  {
    std::vector<double> g;
    solve_bordered(x, g, b, {}, Border(), tolerance);
  }



  void
  FinerSolver::solve_bordered(Vector                    &x,
                              std::vector<double>       &g,
                              const Vector              &b,
                              const std::vector<double> &c,
                              const Border              &border,
                              const double               tolerance)
  {
    AssertThrow(std::isfinite(bordered_vector(b, c).l2_norm()),
                ExcNotConverged("The residual on a finer mesh is not finite"));
    enrichment->factor();

    double largest = 0., volume = 0.;
    for (unsigned int i = 0; i < tangent->unknowns.n_cells(); ++i)
      {
        largest = std::max(largest, tangent->shear_modulus[i]);
        volume += tangent->pressure_mass(i)[0];
      }
    const MPI_Comm comm = tangent->space.communicator();
    largest             = dealii::Utilities::MPI::max(largest, comm);
    volume              = dealii::Utilities::MPI::sum(volume, comm);
    const Vector        factors = scale();
    std::vector<double> of_globals;
    for (const double size : border.scale)
      of_globals.push_back(std::sqrt(largest * volume) / size);

    const BorderedTangent system(*tangent, border);
    BorderedVector        right = bordered_vector(b, c);
    BorderedVector        left = right, solution = right;
    multiply(right, factors, of_globals, false);

    const auto apply = [&](BorderedVector &y, const BorderedVector &v) {
      system.vmult(y, v);
      multiply(y, factors, of_globals, false);
    };
    const auto precondition = [&](BorderedVector &y, const BorderedVector &v) {
      BorderedVector r = v;
      multiply(r, factors, of_globals, true);
      y = 0.;
      enrichment->correct(y.block(0), r.block(0));
      system.vmult(left, y);
      r -= left;

      Vector              on_large, correction, on_small;
      std::vector<double> of_border;
      cells->restrict_to(on_large, r.block(0));
      correction.reinit(on_large);
      on_large_cells(correction, of_border, on_large, globals_of(r));
      cells->prolongate(on_small, correction);
      y.block(0) += on_small;
      for (unsigned int k = 0; k < y.block(1).locally_owned_size(); ++k)
        y.block(1).local_element(k) += of_border[k];
    };
    FlexibleGmres<BorderedVector> gmres(n_iterations);
    gmres.solve(apply, precondition, solution, right, tolerance);
    count_iterations(gmres.n_iterations());
    ++counts.n_solves;
    x = solution.block(0);
    g = globals_of(solution);
  }



  std::vector<double>
  FinerSolver::contributions(const Vector              &b,
                             const Vector              &j,
                             const std::vector<double> &of_globals,
                             const Border              &border,
                             const OnLargeCells        &dual_on_large_cells) const
  {
    Vector              on_large, z, on_small;
    std::vector<double> z_of_globals;
    cells->restrict_to(on_large, j);
    z.reinit(on_large);
    dual_on_large_cells(z, z_of_globals, on_large, of_globals);
    cells->prolongate(on_small, z);

    const Border          turned = transposed(border);
    const BorderedTangent system(*tangent, turned);
    BorderedVector        residual = bordered_vector(j, of_globals);
    BorderedVector        product  = residual;
    system.vmult(product, bordered_vector(on_small, z_of_globals));
    residual -= product;

    Vector y;
    tangent->unknowns.reinit_vector(y);
    enrichment->correct(y, residual.block(0));
    return cells->products(b, y);
  }
} // namespace lumbricus
