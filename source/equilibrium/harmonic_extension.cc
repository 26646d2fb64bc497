// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/equilibrium/harmonic_extension.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <array>

#include "cell_laplacian.h"
#include "enclosed_liquid.h"

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_nodes;
    using cell_sizes::n_per_cell;

    // The Laplacian of the displacement inside the liquid, cell by cell; all
    // other unknowns have the rows of the identity.
    class LiquidLaplacian
    {
    public:
      explicit LiquidLaplacian(const CellUnknowns &unknowns)
        : unknowns(unknowns)
      {
        unknowns.reinit_vector(is_inside);
      }

      // The owned cell i of liquid, whose nodes on some faces are held.
      void
      add_cell(const unsigned int       i,
               const ShapeCache::Cell  &cell,
               const std::vector<bool> &is_held)
      {
        cells.push_back({i, CellLaplacian(cell)});
        for (unsigned int n = 0; n < n_nodes; ++n)
          for (unsigned int c = 0; c < dim; ++c)
            for (const auto &[place, weight] :
                 unknowns.row(i, CellUnknowns::displacement(c, n)))
              {
                (void)weight;
                // Once held, always held.
                is_inside.begin()[place] += is_held[n] ? n_cells_at_most : -1.;
              }
      }

      // After the last cell.
      void
      close()
      {
        is_inside.compress(dealii::VectorOperation::add);
        for (double &entry : is_inside)
          entry = entry < 0. ? 1. : 0.;
        is_inside.update_ghost_values();
      }

      // y += K x for what function(i, x_cell) says x is on a cell, in the rows
      // of the unknowns inside.
      template <typename Function>
      void
      add_product(Vector &y, const Function &read_cell) const
      {
        double x_cell[n_per_cell], y_cell[n_per_cell];
        for (const Cell &cell : cells)
          {
            read_cell(cell.index, x_cell);
            cell.K.vmult(x_cell, y_cell);
            unknowns.add(cell.index, y_cell, y);
          }
        y.compress(dealii::VectorOperation::add);
        y.scale(is_inside);
      }

      void
      vmult(Vector &y, const Vector &x) const
      {
        x.update_ghost_values();
        y = 0.;
        add_product(y, [&](const unsigned int i, double *x_cell) {
          unknowns.read_free(i, x, x_cell);
        });
        x.zero_out_ghost_values();
        for (unsigned int k = 0; k < y.locally_owned_size(); ++k)
          if (is_inside.local_element(k) == 0.)
            y.local_element(k) = x.local_element(k);
      }

      Vector
      inverse_diagonal() const
      {
        Vector diagonal;
        unknowns.reinit_vector(diagonal);
        for (const Cell &cell : cells)
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              for (const auto &[place, weight] :
                   unknowns.row(cell.index, CellUnknowns::displacement(c, n)))
                diagonal.begin()[place] += weight * weight * cell.K.diagonal(n);
        diagonal.compress(dealii::VectorOperation::add);
        for (unsigned int k = 0; k < diagonal.locally_owned_size(); ++k)
          diagonal.local_element(k) = is_inside.local_element(k) > 0. ?
                                        1. / diagonal.local_element(k) :
                                        1.;
        return diagonal;
      }

    private:
      struct Cell
      {
        unsigned int  index;
        CellLaplacian K;
      };

      static constexpr double n_cells_at_most = 1e6;

      const CellUnknowns &unknowns;
      std::vector<Cell>   cells;
      Vector              is_inside; // 1 or 0
    };



    // Which nodes of a cell of liquid are on its surface.
    std::vector<bool>
    nodes_on_surface(const Body &body, const OwnedCell &owned_cell)
    {
      const MixedSpace &space      = body.space;
      const Anatomy    &anatomy    = body.anatomy;
      const auto       &cell       = owned_cell.iterator;
      const auto        is_surface = [&](const unsigned int f) {
        return cell->face(f)->at_boundary() ?
                 is_outside(body, cell, f) :
                 !anatomy.is_liquid(
                   Region::of(cell->neighbor(f)->material_id()).tissue);
      };
      std::vector<bool> on_surface(n_nodes, false);
      for (const unsigned int f : cell->face_indices())
        if (is_surface(f))
          for (unsigned int n = 0; n < n_nodes; ++n)
            if (space.fe.has_support_on_face(space.displacement_dof[0][n], f))
              on_surface[n] = true;
      return on_surface;
    }
  } // namespace



  Vector
  harmonic_correction(const Body              &body,
                      const CellUnknowns      &unknowns,
                      const Vector            &relevant_solution,
                      const std::vector<bool> &in_segment)
  {
    LiquidLaplacian                              laplacian(unknowns);
    std::vector<std::array<double, n_per_cell>>  u_of_cells;
    ElementKernel                                kernel;
    std::vector<dealii::types::global_dof_index> indices(
      body.space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        if (!cell.is_liquid || !in_segment[cell.region.segment])
          continue;
        laplacian.add_cell(cell.index,
                           body.shapes.cell(cell.index),
                           nodes_on_surface(body, cell));
        kernel.read(body.space, cell.iterator, relevant_solution, indices);
        u_of_cells.emplace_back();
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            u_of_cells.back()[CellUnknowns::displacement(c, n)] =
              kernel.u[c][n];
      }
    laplacian.close();

    Vector right_hand_side, correction;
    unknowns.reinit_vector(right_hand_side);
    unknowns.reinit_vector(correction);
    auto next = u_of_cells.begin();
    laplacian.add_product(right_hand_side,
                          [&](const unsigned int /*i*/, double *u_cell) {
                            std::copy(next->begin(), next->end(), u_cell);
                            ++next;
                          });
    right_hand_side *= -1.;

    const double norm = right_hand_side.l2_norm();
    if (norm == 0.)
      return correction;
    const dealii::DiagonalMatrix<Vector> jacobi(laplacian.inverse_diagonal());
    dealii::SolverControl        control(10000, 1e-10 * norm);
    dealii::SolverCG<Vector>             cg(control);
    cg.solve(laplacian, correction, right_hand_side, jacobi);
    correction.update_ghost_values();
    return correction;
  }
} // namespace lumbricus
