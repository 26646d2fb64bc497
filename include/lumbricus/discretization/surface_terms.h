// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_terms_h
#define lumbricus_discretization_surface_terms_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace lumbricus
{
  /**
   * Every SurfaceTerm on the mesh: T and its derivatives at the points of the
   * boundary, where what the skin remembers is that of a State.
   */
  class SurfaceTerms
  {
  public:
    /** Called with the number of a condition, and its response. */
    using Listener =
      std::function<void(const unsigned int, const SurfaceResponse &)>;

    /** Called with the number of a condition, and what it may depend on. */
    using PointListener =
      std::function<void(const unsigned int, const SurfacePoint &)>;

    /** Both arguments are kept by reference. */
    SurfaceTerms(const Body &body, const BoundaryConditions &conditions);

    /** All there are on the mesh. */
    const BoundaryConditions &
    boundary_conditions() const
    {
      return conditions;
    }

    /** Remember what the skin does in @p state: before visit(), and after every
     * change of the mesh. */
    void
    set_to(const State &state);

    /** Whether all of them together keep the matrix symmetric: each does at its
     * points, or is a uniform pressure on a closed surface, whose unsymmetric parts
     * add up to zero. Every rank looks at the coarse mesh. */
    bool
    symmetric() const;

    /** The names of the histories that a state has to have for this. */
    std::set<std::string>
    histories() const;

    /** Whether the traction of any is bounded: SurfaceTerm::may_slide(). */
    bool
    may_slide() const;

    /** Part of the increment @p dx of @p solution that is so long that what slides
     * pulls back with @p most, see SurfaceTerm::pull_back(); 1 where all of it
     * pulls back less. In N mm per unit of the part. Collective. */
    double
    part_of_slide(const Vector   &solution,
                  const Vector   &dx,
                  const LoadTime &t,
                  const double    most);

    /** The load step that ended with @p state is complete: let the skin remember
     * what it has to. Before State::last_time is changed. Collective. */
    void
    end_step(State &state) const;

    /** Augment what the skin remembers where the solution in @p state at time
     * @p t is not yet good enough, see SurfaceTerm::is_augmented(), and set
     * @p way to how far the nodes there will move then, about. @return whether
     * there was any. Collective. */
    bool
    augment(State &state, const LoadTime &t, Vector &way) const;

    /** Called with a cell, one of its nodes, the number of a condition and what
     * that may depend on. */
    using CellNodeListener = std::function<void(const OwnedCell &,
                                                const unsigned int,
                                                const unsigned int,
                                                const SurfacePoint &)>;

    /** Call @p listener at all nodes of this rank's cells where conditions act that
     * remember, for the solution, time and histories of @p state. A node comes
     * once for each cell; N and F are not there. Collective. */
    void
    visit_cell_nodes(const State            &state,
                     const CellNodeListener &listener) const;

    /**
     * Call @p listener at the quadrature points of all faces at the boundary of
     * @p cell, for every term that acts there, at the displacements @p u,
     * [i][n], and time @p t. point() is there then.
     */
    void
    visit(const OwnedCell &cell,
          const double (&u)[dim][ShapeCache::padded_nodes],
          const LoadTime &t,
          const Listener &listener);

    /** Call @p listener there with what the terms are asked with. */
    void
    visit_points(const OwnedCell &cell,
                 const double (&u)[dim][ShapeCache::padded_nodes],
                 const LoadTime      &t,
                 const PointListener &listener);

    /** The same for all of this rank's cells, at @p solution. Collective. */
    void
    visit_points(const Vector        &solution,
                 const LoadTime      &t,
                 const PointListener &listener);

    /** Where the listener is called, with the nodes around. */
    const SurfaceKernel &
    point() const;

  private:
    /** What the nodes of a cell remember: [n]. */
    using AtNodes =
      std::array<dealii::Tensor<1, dim>, MixedSpace::n_nodes>;

    /** Call @p function(condition, term, point) where visit() says. */
    template <typename Function>
    void
    for_each_point(const OwnedCell &cell,
                   const double (&u)[dim][ShapeCache::padded_nodes],
                   const LoadTime &t,
                   const Function &function);

    /** Call @p function(cell, node, condition, point, history) at all nodes that
     * remember, where the last is what the state has, to read or to change. */
    template <typename StateType, typename Function>
    void
    for_each_node(StateType      &state,
                  const Vector   &solution,
                  const LoadTime &t,
                  const Function &function) const;

    /** How the State calls what condition @p i remembers. */
    std::string
    history_of(const unsigned int i) const;

    const Body                body;
    const BoundaryConditions &conditions;

    SurfaceKernel  inside; ///< at points of Gauss
    SurfaceKernel  at_nodes;
    SurfaceKernel *current = &inside;

    /** When the last load step ended. */
    double last_time = 0.;
    /** symmetric(), once it has been asked for. */
    mutable std::optional<bool> keep_symmetry;
    /** By the numbers of conditions and of owned cells. */
    std::map<std::pair<unsigned int, unsigned int>, AtNodes> memories;
  };
} // namespace lumbricus

#endif
