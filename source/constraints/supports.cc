// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/constraints/supports.h>
#include <lumbricus/discretization/loaded_points.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lumbricus
{
  namespace
  {
    dealii::Tensor<1, dim>
    unit_vector(const unsigned int direction)
    {
      dealii::Tensor<1, dim> e;
      e[direction] = 1.;
      return e;
    }
  } // namespace



  Supports::Supports(const MixedSpace         &space,
                     const Anatomy            &anatomy,
                     const InterfaceCoupling  &coupling,
                     const BoundaryConditions &conditions)
    : space(space)
    , anatomy(anatomy)
    , geometry(anatomy.geometry())
    , conditions(conditions)
    , interface(space, anatomy, coupling)
    , least(geometry, conditions)
  {}



  void
  Supports::reinit()
  {
    base = local_constraints(space.locally_owned, known_unknowns());
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler, base);
    prescribed.clear();
    held_points.clear();
    prescribe_boundaries();
    interface.reinit();

    auto motions = held_motions();
    held         = std::make_unique<RigidMotions>(motions[0]);
    hold(least.of_wall(motions[0]), 0);
    // What the wall leaves free of a liquid that slips is a spin about the
    // axis of a full cross-section, and to move out of an open tube. One
    // vertex inside holds both motions.
    std::set<unsigned int> bodies;
    for (const auto &cell : space.triangulation.cell_iterators_on_level(0))
      bodies.insert(body_of(cell->material_id()));
    for (unsigned int s = 0; s + 1 < motions.size(); ++s)
      if (bodies.count(s + 1) > 0)
        hold(least.of_liquid(motions[s + 1], s, vertex_in_liquid(s)), s + 1);
    close();
  }



  bool
  Supports::follow_the_deformation() const
  {
    return interface.follows_the_deformation();
  }



  void
  Supports::update_interface(const Vector &solution, const Vector &start)
  {
    if (!follow_the_deformation())
      return;
    interface.update(solution, start);
    close();
  }



  double
  Supports::gap() const
  {
    return largest_gap;
  }



  bool
  Supports::is_sliding_face(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const unsigned int                                   f) const
  {
    return follow_the_deformation() && interface.is_liquid_side(cell, f);
  }



  void
  Supports::close()
  {
    // Closing eliminates what hangs on other constrained unknowns, so it is to
    // be done anew with every change.
    increments.clear();
    increments.copy_from(base);
    if (interface.exists())
      largest_gap =
        dealii::Utilities::MPI::max(interface.add_constraints(increments),
                                    space.communicator());
    close(increments);
  }



  dealii::IndexSet
  Supports::known_unknowns() const
  {
    // Under slip an unknown may hang on others that this rank does not know.
    return interface.exists() ?
             dealii::complete_index_set(space.dof_handler.n_dofs()) :
             space.locally_relevant;
  }



  void
  Supports::close(dealii::AffineConstraints<double> &constraints) const
  {
    // Chains over nodes of other ranks are made complete.
    if (interface.exists())
      constraints.make_consistent_in_parallel(space.locally_owned,
                                              space.locally_relevant,
                                              space.communicator());
    constraints.close();
  }



  dealii::AffineConstraints<double>
  Supports::links() const
  {
    // What is prescribed decides which unknowns of the interface hang on which.
    dealii::AffineConstraints<double> all;
    all.copy_from(base);
    if (interface.exists())
      interface.add_constraints(all);
    std::set<dealii::types::global_dof_index> held_unknowns;
    for (const Prescribed &entry : prescribed)
      held_unknowns.insert(entry.index);

    dealii::AffineConstraints<double> constraints =
      local_constraints(space.locally_owned, known_unknowns());
    for (const auto &line : all.get_lines())
      if (held_unknowns.count(line.index) == 0)
        {
          constraints.add_line(line.index);
          constraints.add_entries(line.index, line.entries);
        }
    close(constraints);
    return constraints;
  }



  const std::vector<Supports::Prescribed> &
  Supports::prescribed_unknowns() const
  {
    return prescribed;
  }



  const std::vector<MinimalSupport::HeldPoint> &
  Supports::minimal_support() const
  {
    return held_points;
  }



  const RigidMotions &
  Supports::held_without_minimal_support() const
  {
    Assert(held != nullptr, dealii::ExcNotInitialized());
    return *held;
  }



  unsigned int
  Supports::body_of(const dealii::types::material_id id) const
  {
    const Region region = Region::of(id);
    return interface.exists() && anatomy.is_liquid(region.tissue) ?
             region.segment + 1 :
             0;
  }



  void
  Supports::prescribe_boundaries()
  {
    const auto planes = geometry.symmetry_planes();

    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial() || !cell->at_boundary())
          continue;
        cell->get_dof_indices(indices);
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            const auto id = cell->face(f)->boundary_id();

            // Which components, by whom.
            struct Holder
            {
              unsigned int                  component;
              const PrescribedDisplacement *condition; // or nullptr
              unsigned int                  number;
            };
            std::vector<Holder> who;
            for (unsigned int p = 0; p < planes.size(); ++p)
              if (planes[p].boundary == id)
                who.push_back({planes[p].direction, nullptr, p});
            for (const unsigned int i :
                 conditions.prescribed_displacements_on(id))
              {
                const auto *condition =
                  conditions.condition(i).prescribed_displacement();
                for (unsigned int c = 0; c < dim; ++c)
                  if (condition->components()[c])
                    who.push_back({c, condition, i});
              }

            for (const auto &[c, condition, number] : who)
              for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                {
                  const unsigned int i = space.displacement_dof[c][n];
                  if (!space.fe.has_support_on_face(i, f) ||
                      base.is_constrained(indices[i]))
                    continue;
                  base.add_line(indices[i]);
                  prescribed.push_back(
                    {indices[i],
                     c,
                     body_of(cell->material_id()),
                     space.mapping.transform_unit_to_real_cell(
                       cell, space.fe.unit_support_point(i)),
                     condition,
                     condition == nullptr ? By::symmetry : By::condition,
                     number,
                     {{indices[space.displacement_dof[0][n]],
                       indices[space.displacement_dof[1][n]],
                       indices[space.displacement_dof[2][n]]}}});
                }
          }
      }
  }



  std::vector<RigidMotions>
  Supports::held_motions() const
  {
    const auto                points = geometry.support_points();
    const double              L      = geometry.characteristic_length();
    std::vector<RigidMotions> motions(interface.exists() ?
                                        geometry.n_segments() + 1 :
                                        1,
                                      RigidMotions(points[0], L));

    for (const Prescribed &entry : prescribed)
      motions[entry.body].hold(entry.X, unit_vector(entry.component));
    for (const SlipInterface::NodePair &pair : interface.pairs())
      for (const auto &normal : interface.normals(pair))
        motions[pair.segment + 1].hold(pair.X, normal / normal.norm());

    for (const LoadedPoint &point : loaded_points(space, conditions))
      for (const auto &direction : conditions.condition(point.condition)
                                     .surface_term()
                                     ->elastic_directions(point.at_rest()))
        motions[body_of(point.material)].hold(point.X, direction);
    for (RigidMotions &of_body : motions)
      of_body.merge(space.communicator());
    return motions;
  }



  dealii::Point<dim>
  Supports::vertex_in_liquid(const unsigned int segment) const
  {
    std::set<dealii::types::global_dof_index> on_interface;
    for (const SlipInterface::NodePair &pair : interface.pairs())
      on_interface.insert(pair.liquid[0]);
    return MinimalSupport::outermost_vertex(
      space, [&](const auto &cell, const dealii::types::global_dof_index i) {
        return body_of(cell->material_id()) == segment + 1 &&
               on_interface.count(i) == 0 && !base.is_constrained(i);
      });
  }



  void
  Supports::hold(const std::vector<MinimalSupport::HeldPoint> &points,
                 const unsigned int                            body)
  {
    for (const auto &[X, direction] : points)
      {
        held_points.push_back({X, direction});
        hold_vertex(X, direction, body);
      }
  }



  void
  Supports::hold_vertex(const dealii::Point<dim> &X,
                        const unsigned int        direction,
                        const unsigned int        body)
  {
    const double tolerance = 1e-8 * geometry.characteristic_length();
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          if (cell->is_artificial() || body_of(cell->material_id()) != body ||
              cell->vertex(v).distance(X) > tolerance)
            continue;
          std::array<dealii::types::global_dof_index, dim> node;
          for (unsigned int c = 0; c < dim; ++c)
            node[c] = cell->vertex_dof_index(v, c, cell->active_fe_index());
          const auto i = node[direction];
          if (base.is_constrained(i))
            continue;
          base.add_line(i);
          prescribed.push_back({i,
                                direction,
                                body,
                                X,
                                nullptr,
                                By::minimal_support,
                                static_cast<unsigned int>(held_points.size() -
                                                          1),
                                node});
        }
  }



  double
  Supports::set_increments(const Vector &solution, const LoadTime &t)
  {
    const Vector relevant = space.with_ghosts(solution);

    double largest = 0.;
    for (const Prescribed &entry : prescribed)
      {
        if (entry.condition == nullptr)
          continue;
        const double wanted = t.take(
          [&](const double at) {
            return entry.condition->value(entry.component, entry.X, at);
          },
          0.);
        const double missing = wanted - relevant(entry.index);
        base.set_inhomogeneity(entry.index, missing);
        largest = std::max(largest, std::abs(missing));
      }
    close();
    return dealii::Utilities::MPI::max(largest, space.communicator());
  }



  void
  Supports::set_increments_to_zero()
  {
    for (const Prescribed &entry : prescribed)
      base.set_inhomogeneity(entry.index, 0.);
    close();
  }



  const dealii::AffineConstraints<double> &
  Supports::constraints() const
  {
    return increments;
  }
} // namespace lumbricus
