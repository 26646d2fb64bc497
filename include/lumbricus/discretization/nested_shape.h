// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_nested_shape_h
#define lumbricus_discretization_nested_shape_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace lumbricus
{
  /**
   * The triquadratic shape of cells at rest. Up to a level it is that of the
   * manifolds; finer cells are pieces of their ancestor of that level. So
   * refinement beyond it leaves the body as it is, volume and all, and there
   * are no gaps at hanging nodes.
   */
  class NestedShape
  {
  public:
    /** Of cells with maps of @p degree in every direction. */
    explicit NestedShape(const unsigned int degree);

    /** The level up to which cells follow the manifolds. */
    void
    set_finest_curved_level(const unsigned int level);

    /** The support points of @p cell, in the order of FE_Q [mm]. */
    std::vector<dealii::Point<dim>>
    points(const dealii::Triangulation<dim>::cell_iterator &cell);

  private:
    const dealii::FE_Q<dim>     fe;
    const dealii::MappingQ<dim> on_manifolds;
    dealii::FEValues<dim>       at_support_points;
    unsigned int                finest_curved_level = 0;
  };
} // namespace lumbricus

#endif
