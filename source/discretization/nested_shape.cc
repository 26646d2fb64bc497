// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/nested_shape.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature.h>

namespace lumbricus
{
  NestedShape::NestedShape(const unsigned int degree)
    : fe(degree)
    , on_manifolds(degree)
    , at_support_points(on_manifolds,
                        fe,
                        dealii::Quadrature<dim>(fe.get_unit_support_points()),
                        dealii::update_quadrature_points)
  {}



  void
  NestedShape::set_finest_curved_level(const unsigned int level)
  {
    finest_curved_level = level;
  }



  std::vector<dealii::Point<dim>>
  NestedShape::points(const dealii::Triangulation<dim>::cell_iterator &cell)
  {
    std::vector<dealii::Point<dim>> in_ancestor = fe.get_unit_support_points();
    auto                            ancestor    = cell;
    while (static_cast<unsigned int>(ancestor->level()) > finest_curved_level)
      {
        const unsigned int c = child_number(ancestor);
        for (auto &point : in_ancestor)
          point =
            dealii::GeometryInfo<dim>::child_to_cell_coordinates(point, c);
        ancestor = ancestor->parent();
      }

    at_support_points.reinit(ancestor);
    const auto &nodes = at_support_points.get_quadrature_points();
    if (ancestor == cell)
      return nodes;
    std::vector<dealii::Point<dim>> result(in_ancestor.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      for (unsigned int n = 0; n < nodes.size(); ++n)
        result[i] += fe.shape_value(n, in_ancestor[i]) * nodes[n];
    return result;
  }
} // namespace lumbricus
