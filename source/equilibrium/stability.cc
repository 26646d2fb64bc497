// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/equilibrium/stability.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_nodes;
    using cell_sizes::n_per_cell;
    using cell_sizes::n_q;

    // Of linear solves, and of the stiffness that inverse iteration finds.
    constexpr double       solve_tolerance = 1e-5;
    constexpr double       tolerance       = 1e-3;
    constexpr unsigned int most_iterations = 40;

    // Component c of a motion at quadrature point q of a cell.
    double
    value(const ShapeCache  &shapes,
          const double      *of_cell,
          const unsigned int q,
          const unsigned int c)
    {
      double sum = 0.;
      for (unsigned int n = 0; n < n_nodes; ++n)
        sum += shapes.node_values(q)[n] *
               of_cell[CellUnknowns::displacement(c, n)];
      return sum;
    }



    // Call function(cell) for the owned cells of the wall.
    template <typename Function>
    void
    for_each_wall_cell(const Body &body, const Function &function)
    {
      for (const OwnedCell cell : body.owned_cells())
        if (!cell.is_liquid)
          function(cell);
    }
  } // namespace



  Stability::Stability(const Body    &body,
                       const Tangent &tangent,
                       const Border  &border,
                       LinearSolver  &linear_solver)
    : body(body)
    , tangent(tangent)
    , border(border)
    , linear_solver(linear_solver)
  {}



  Vector
  Stability::mass(const Vector &v) const
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    const ShapeCache   &shapes   = body.shapes;
    Vector              result;
    unknowns.reinit_vector(result);
    double v_cell[n_per_cell], result_cell[n_per_cell];
    v.update_ghost_values();
    for_each_wall_cell(body, [&](const OwnedCell &cell) {
      unknowns.read_free(cell.index, v, v_cell);
      std::fill(result_cell, result_cell + n_per_cell, 0.);
      for (unsigned int q = 0; q < n_q; ++q)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double v_dV =
              value(shapes, v_cell, q, c) * shapes.cell(cell.index).JxW[q];
            for (unsigned int n = 0; n < n_nodes; ++n)
              result_cell[CellUnknowns::displacement(c, n)] +=
                shapes.node_values(q)[n] * v_dV;
          }
      unknowns.add(cell.index, result_cell, result);
    });
    result.compress(dealii::VectorOperation::add);
    v.zero_out_ghost_values();
    return result;
  }



  Vector
  Stability::any_force() const
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    Vector              f;
    unknowns.reinit_vector(f);
    const double size = body.anatomy.geometry().characteristic_length();
    for_each_wall_cell(body, [&](const OwnedCell &cell) {
      double f_cell[n_per_cell] = {};
      for (unsigned int n = 0; n < n_nodes; ++n)
        {
          const auto X = body.shapes.node(cell.index, n) / size;
          for (unsigned int c = 0; c < dim; ++c)
            f_cell[CellUnknowns::displacement(c, n)] =
              std::sin(1. + 2. * c + 7. * X[0] + 11. * X[1] + 5. * X[2]);
        }
      unknowns.add(cell.index, f_cell, f);
    });
    f.compress(dealii::VectorOperation::add);
    return f;
  }



  Stability::Motion
  Stability::softest_motion() const
  {
    Motion motion = response(any_force());
    for (unsigned int n = 0; n < most_iterations; ++n)
      {
        const double before = motion.stiffness;
        motion              = response(mass(motion.v));
        if (std::abs(motion.stiffness - before) <=
            tolerance * std::abs(motion.stiffness))
          break;
      }
    return motion;
  }



  Stability::Ends
  Stability::ends() const
  {
    // Where 1/k is a smaller part of the largest one than this it is not told from
    // what is left of the linear systems.
    constexpr double       least_part = 1e-3;
    constexpr unsigned int fewest     = 12;

    // A basis with v_i . M v_j = delta_ij, and in it the inverse.
    std::vector<Vector>        basis, masses;
    dealii::FullMatrix<double> inverse(most_iterations, most_iterations);
    Vector                     next = response(any_force()).v;
    // 1/k, in ascending order, and the coordinates of their motions.
    std::vector<double>              values, before;
    std::vector<std::vector<double>> vectors;
    for (unsigned int n = 0; n < most_iterations; ++n)
      {
        // Twice is enough.
        for (unsigned int twice = 0; twice < 2; ++twice)
          for (unsigned int i = 0; i < n; ++i)
            next.add(-(next * masses[i]), basis[i]);
        const Vector mass_of_next = mass(next);
        const double size         = std::sqrt(next * mass_of_next);
        // Of less the basis has all there is.
        if (n > 0 && size < least_part * solve_tolerance * values.back())
          break;
        basis.push_back(next);
        basis.back() *= 1. / size;
        masses.push_back(mass_of_next);
        masses.back() *= 1. / size;

        next = solve(masses.back());
        for (unsigned int i = 0; i <= n; ++i)
          inverse(i, n) = inverse(n, i) = next * masses[i];

        dealii::LAPACKFullMatrix<double> part(n + 1);
        for (unsigned int i = 0; i <= n; ++i)
          for (unsigned int j = 0; j <= n; ++j)
            part(i, j) = inverse(i, j);
        dealii::Vector<double>     eigenvalues;
        dealii::FullMatrix<double> eigenvectors;
        const double               bound = 2. * part.frobenius_norm();
        part.compute_eigenvalues_symmetric(
          -bound, bound, 0., eigenvalues, eigenvectors);
        before = std::exchange(values,
                               std::vector<double>(eigenvalues.begin(),
                                                   eigenvalues.end()));
        vectors.clear();
        for (unsigned int k = 0; k < values.size(); ++k)
          {
            vectors.emplace_back();
            for (unsigned int i = 0; i <= n; ++i)
              vectors.back().push_back(eigenvectors(i, k));
          }
        const auto same = [&](const double one, const double other) {
          return std::abs(one - other) <=
                 tolerance * std::max(std::abs(values.front()),
                                      std::abs(values.back()));
        };
        if (n + 1 >= fewest && same(values.front(), before.front()) &&
            same(values.back(), before.back()))
          break;
      }

    Ends         ends;
    const double largest =
      std::max(std::abs(values.front()), std::abs(values.back()));
    if (values.back() > 0.)
      ends.softest = 1. / values.back();
    for (unsigned int k = 0; k < values.size(); ++k)
      if (values[k] < -least_part * largest)
        {
          Motion motion;
          tangent.unknowns.reinit_vector(motion.v);
          // To the side that the method began with, on any number of ranks.
          const double side = vectors[k][0] < 0. ? -1. : 1.;
          for (unsigned int i = 0; i < vectors[k].size(); ++i)
            motion.v.add(side * vectors[k][i], basis[i]);
          motion.stiffness = 1. / values[k];
          ends.unstable.push_back(motion);
        }
    return ends;
  }



  Stability::Motion
  Stability::follow(const Motion &before, const Motion &other) const
  {
    Vector f = mass(before.v);
    f.add(-(before.v * mass(other.v)), mass(other.v));
    return response(f);
  }



  Vector
  Stability::solve(const Vector &f) const
  {
    Vector v;
    tangent.unknowns.reinit_vector(v);
    std::vector<double>       of_globals;
    const std::vector<double> none(border.size(), 0.);
    linear_solver.solve(v, of_globals, f, none, border, solve_tolerance);
    return v;
  }



  Stability::Motion
  Stability::response(const Vector &f) const
  {
    Motion motion;
    motion.v          = solve(f);
    const double work = motion.v * f;
    const double size = std::sqrt(motion.v * mass(motion.v));
    motion.v /= size;
    // v . K v = v . f, as the motion keeps all volumes.
    motion.stiffness = work / (size * size);
    return motion;
  }



  double
  Stability::likeness(const Motion &one, const Motion &other) const
  {
    return std::abs(one.v * mass(other.v));
  }



  std::string
  Stability::place(const Motion &motion) const
  {
    double largest = 0.;
    Region where{0, 0};
    double v_cell[n_per_cell];
    motion.v.update_ghost_values();
    for_each_wall_cell(body, [&](const OwnedCell &cell) {
      tangent.unknowns.read_free(cell.index, motion.v, v_cell);
      for (unsigned int q = 0; q < n_q; ++q)
        {
          double square = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            square += std::pow(value(body.shapes, v_cell, q, c), 2);
          if (square > largest)
            {
              largest = square;
              where   = cell.region;
            }
        }
    });
    motion.v.zero_out_ghost_values();

    const MPI_Comm comm    = body.space.communicator();
    const auto     global  = dealii::Utilities::MPI::min_max_avg(largest, comm);
    const auto     tissues = body.anatomy.geometry().tissues();
    const std::string here = "segment " + std::to_string(where.segment + 1) +
                             ", " + tissues[where.tissue].name;
    return dealii::Utilities::MPI::broadcast(comm, here, global.max_index);
  }
} // namespace lumbricus
