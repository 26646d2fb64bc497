// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/shape_cache.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_modes;
    using cell_sizes::n_nodes;
    using cell_sizes::n_q;

    constexpr unsigned int cell_stride = n_q * dim * ShapeCache::padded_nodes;
  } // namespace



  ShapeCache::ShapeCache(const MixedSpace &space)
    : space(space)
  {
    for (unsigned int q = 0; q < n_q; ++q)
      {
        for (unsigned int m = 0; m < n_modes; ++m)
          psi.push_back(space.fe.shape_value(space.pressure_dof[m],
                                             space.quadrature.point(q)));
        for (unsigned int n = 0; n < n_nodes; ++n)
          N.push_back(space.fe.shape_value(space.displacement_dof[0][n],
                                           space.quadrature.point(q)));
      }
  }



  void
  ShapeCache::reinit()
  {
    unsigned int n_cells = 0;
    for (const auto &cell : space.owned_cells())
      {
        (void)cell;
        ++n_cells;
      }

    gradients.clear();
    gradients.resize(n_cells * cell_stride, 0.);
    JxW.resize(n_cells * n_q);
    points.resize(n_cells * n_q);
    nodes.resize(n_cells * n_nodes);

    dealii::FEValues<dim>           fe_values(space.mapping,
                                    space.fe,
                                    space.quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values |
                                      dealii::update_quadrature_points);
    std::vector<dealii::Point<dim>> unit_nodes;
    for (unsigned int n = 0; n < n_nodes; ++n)
      unit_nodes.push_back(
        space.fe.unit_support_point(space.displacement_dof[0][n]));
    dealii::FEValues<dim> at_nodes(space.mapping,
                                   space.fe,
                                   dealii::Quadrature<dim>(unit_nodes),
                                   dealii::update_quadrature_points);
    unsigned int          i = 0;
    for (const auto &cell : space.owned_cells())
      {
        fe_values.reinit(mesh_cell(cell));
        at_nodes.reinit(mesh_cell(cell));
        for (unsigned int n = 0; n < n_nodes; ++n)
          nodes[i * n_nodes + n] = at_nodes.quadrature_point(n);
        for (unsigned int q = 0; q < n_q; ++q)
          {
            JxW[i * n_q + q]    = fe_values.JxW(q);
            points[i * n_q + q] = fe_values.quadrature_point(q);
            for (unsigned int n = 0; n < n_nodes; ++n)
              {
                const auto gradient =
                  fe_values.shape_grad(space.displacement_dof[0][n], q);
                for (unsigned int J = 0; J < dim; ++J)
                  gradients[i * cell_stride + (dim * q + J) * padded_nodes +
                            n] = gradient[J];
              }
          }
        ++i;
      }
  }



  ShapeCache::Cell
  ShapeCache::cell(const unsigned int owned_index) const
  {
    AssertIndexRange(owned_index, n_owned_cells());
    return {gradients.data() + owned_index * cell_stride,
            JxW.data() + owned_index * n_q};
  }



  const double *
  ShapeCache::pressure_modes() const
  {
    return psi.data();
  }



  const double *
  ShapeCache::node_values(const unsigned int q) const
  {
    return N.data() + MixedSpace::n_nodes * q;
  }



  const dealii::Point<dim> &
  ShapeCache::quadrature_point(const unsigned int owned_index,
                               const unsigned int q) const
  {
    return points[owned_index * n_q + q];
  }



  const dealii::Point<dim> &
  ShapeCache::node(const unsigned int owned_index, const unsigned int n) const
  {
    return nodes[owned_index * n_nodes + n];
  }



  unsigned int
  ShapeCache::n_owned_cells() const
  {
    return JxW.size() / n_q;
  }
} // namespace lumbricus
