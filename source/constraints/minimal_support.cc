// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/constraints/minimal_support.h>
#include <lumbricus/core/exceptions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // Let @p point hold a motion that is still free, if it does.
    void
    hold_if_free(const MinimalSupport::HeldPoint        &point,
                 RigidMotions                           &motions,
                 std::vector<MinimalSupport::HeldPoint> &held)
    {
      dealii::Tensor<1, dim> direction;
      direction[point.direction] = 1.;
      if (motions.hold(point.X, direction))
        held.push_back(point);
    }



    void
    check_that_all_is_held(const RigidMotions &motions, const std::string &what)
    {
      AssertThrow(motions.all_held(),
                  ExcInput(what + " can still move rigidly: " +
                           motions.free_motions() +
                           ". Set 'Boundary conditions/Minimal support' to "
                           "true, or add a condition of type 'displacement' or "
                           "'spring', or a 'contact' with friction, that holds "
                           "it."));
    }
  } // namespace



  MinimalSupport::MinimalSupport(const Geometry           &geometry,
                                 const BoundaryConditions &conditions)
    : geometry(geometry)
    , conditions(conditions)
  {}



  std::vector<MinimalSupport::HeldPoint>
  MinimalSupport::of_wall(RigidMotions &motions) const
  {
    std::vector<HeldPoint> held;
    if (conditions.minimal_support())
      {
        // The statically determinate support: A in x, y, z; B in y, z; C in y,
        // as far as nothing holds these motions yet.
        const auto points = geometry.support_points();
        const std::pair<unsigned int, unsigned int> candidates[] = {
          {0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 1}};
        for (const auto &[point, direction] : candidates)
          hold_if_free({points[point], direction}, motions, held);
      }
    check_that_all_is_held(motions, "The body");
    return held;
  }



  std::vector<MinimalSupport::HeldPoint>
  MinimalSupport::of_liquid(RigidMotions             &motions,
                            const unsigned int        segment,
                            const dealii::Point<dim> &X) const
  {
    std::vector<HeldPoint> held;
    if (conditions.minimal_support())
      for (unsigned int direction = 0; direction < dim; ++direction)
        hold_if_free({X, direction}, motions, held);
    check_that_all_is_held(motions,
                           "The liquid of segment " +
                             std::to_string(segment + 1) +
                             ", which slips along the wall,");
    return held;
  }



  dealii::Point<dim>
  MinimalSupport::outermost_vertex(const MixedSpace &space,
                                   const MayHold    &may_hold)
  {
    const auto is_less = [](const auto &a, const auto &b) {
      return std::make_tuple(a[1], a[2], a[0]) <
             std::make_tuple(b[1], b[2], b[0]);
    };
    dealii::Point<dim> own;
    for (const auto &cell : space.owned_cells())
      for (const unsigned int v : cell->vertex_indices())
        if (is_less(own, cell->vertex(v)) &&
            may_hold(cell,
                     cell->vertex_dof_index(v, 0, cell->active_fe_index())))
          own = cell->vertex(v);
    const auto of_ranks =
      dealii::Utilities::MPI::all_gather(space.communicator(), own);
    return *std::max_element(of_ranks.begin(), of_ranks.end(), is_less);
  }
} // namespace lumbricus
