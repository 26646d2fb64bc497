// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/solvers/stability.h>

#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>

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
        sum += shapes.node_values()[n_nodes * q + n] *
               of_cell[CellUnknowns::displacement(c, n)];
      return sum;
    }



    // Call function(owned_index, region) for the owned cells of the wall.
    template <typename Function>
    void
    for_each_wall_cell(const MixedSpace &space,
                       const Anatomy    &anatomy,
                       const Function   &function)
    {
      unsigned int cell_index = 0;
      for (const auto &cell : space.dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          const unsigned int i      = cell_index++;
          const Region       region = Region::of(cell->material_id());
          if (!anatomy.is_liquid(region.tissue))
            function(i, region);
        }
    }
  } // namespace



  Stability::Stability(const MixedSpace &space,
                       const ShapeCache &shapes,
                       const Anatomy    &anatomy,
                       const Tangent    &tangent,
                       LinearSolver     &linear_solver)
    : space(space)
    , shapes(shapes)
    , anatomy(anatomy)
    , tangent(tangent)
    , linear_solver(linear_solver)
  {}



  CellVector
  Stability::mass(const CellVector &v) const
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    CellVector          result;
    unknowns.reinit_vector(result);
    double v_cell[n_per_cell], result_cell[n_per_cell];
    v.update_ghost_values();
    for_each_wall_cell(
      space, anatomy, [&](const unsigned int i, const Region & /*region*/) {
        unknowns.read_free(i, v, v_cell);
        std::fill(result_cell, result_cell + n_per_cell, 0.);
        for (unsigned int q = 0; q < n_q; ++q)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double v_dV =
                value(shapes, v_cell, q, c) * shapes.cell(i).JxW[q];
              for (unsigned int n = 0; n < n_nodes; ++n)
                result_cell[CellUnknowns::displacement(c, n)] +=
                  shapes.node_values()[n_nodes * q + n] * v_dV;
            }
        unknowns.add(i, result_cell, result);
      });
    result.compress(dealii::VectorOperation::add);
    v.zero_out_ghost_values();
    return result;
  }



  Stability::Motion
  Stability::softest_motion() const
  {
    // Begin with some force that has no symmetry.
    const CellUnknowns &unknowns = tangent.unknowns;
    CellVector          f;
    unknowns.reinit_vector(f);
    for_each_wall_cell(
      space, anatomy, [&](const unsigned int i, const Region & /*region*/) {
        double       f_cell[n_per_cell] = {};
        const double size = anatomy.geometry().characteristic_length();
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            const auto X = shapes.node(i, n) / size;
            for (unsigned int c = 0; c < dim; ++c)
              f_cell[CellUnknowns::displacement(c, n)] =
                std::sin(1. + 2. * c + 7. * X[0] + 11. * X[1] + 5. * X[2]);
          }
        unknowns.add(i, f_cell, f);
      });
    f.compress(dealii::VectorOperation::add);

    Motion motion = response(f);
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



  Stability::Motion
  Stability::follow(const Motion &before, const Motion &other) const
  {
    CellVector f = mass(before.v);
    f.add(-(before.v * mass(other.v)), mass(other.v));
    return response(f);
  }



  Stability::Motion
  Stability::response(const CellVector &f) const
  {
    Motion motion;
    tangent.unknowns.reinit_vector(motion.v);
    linear_solver.solve(motion.v, f, solve_tolerance);
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
    for_each_wall_cell(space,
                       anatomy,
                       [&](const unsigned int i, const Region &region) {
                         tangent.unknowns.read_free(i, motion.v, v_cell);
                         for (unsigned int q = 0; q < n_q; ++q)
                           {
                             double square = 0.;
                             for (unsigned int c = 0; c < dim; ++c)
                               square +=
                                 std::pow(value(shapes, v_cell, q, c), 2);
                             if (square > largest)
                               {
                                 largest = square;
                                 where   = region;
                               }
                           }
                       });
    motion.v.zero_out_ghost_values();

    const MPI_Comm comm    = space.communicator();
    const auto     global  = dealii::Utilities::MPI::min_max_avg(largest, comm);
    const std::string here = "segment " + std::to_string(where.segment + 1) +
                             ", " +
                             anatomy.geometry().tissues()[where.tissue].name;
    return dealii::Utilities::MPI::broadcast(comm, here, global.max_index);
  }
} // namespace lumbricus
