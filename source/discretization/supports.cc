// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/local_constraints.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/supports.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

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
  {}



  void
  Supports::reinit()
  {
    const auto n_unknowns = space.dof_handler.n_dofs();
    // Under slip an unknown may hang on others that this rank does not know.
    base = local_constraints(space.locally_owned,
                             interface.exists() ?
                               dealii::complete_index_set(n_unknowns) :
                               space.locally_relevant);
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler, base);
    prescribed.clear();
    prescribe_boundaries();
    interface.reinit();

    auto motions = held_motions();
    hold_wall(motions[0]);
    for (unsigned int s = 0; s + 1 < motions.size(); ++s)
      hold_liquid(motions[s + 1], s);
    close();
  }



  bool
  Supports::renew_interface(const Vector &solution)
  {
    if (!interface.follows_the_deformation())
      return false;
    interface.update_normals(solution);
    close();
    return true;
  }



  void
  Supports::close()
  {
    // Closing eliminates what hangs on other constrained unknowns, so it is to
    // be done anew with every change.
    increments.clear();
    increments.copy_from(base);
    if (interface.exists())
      {
        interface.add_constraints(increments);
        // Chains over nodes of other ranks are made complete.
        increments.make_consistent_in_parallel(space.locally_owned,
                                               space.locally_relevant,
                                               space.communicator());
      }
    increments.close();
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
            std::vector<std::pair<unsigned int, const BoundaryCondition *>> who;
            for (const SymmetryPlane &plane : planes)
              if (plane.boundary == id)
                who.emplace_back(plane.direction, nullptr);
            for (const BoundaryCondition *condition :
                 conditions.on_boundary(id))
              for (unsigned int c = 0; c < dim; ++c)
                if (condition->prescribed_components()[c])
                  who.emplace_back(c, condition);

            for (const auto &[c, condition] : who)
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
                     condition});
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

    dealii::FEFaceValues<dim> face_values(space.mapping,
                                          space.fe,
                                          space.face_quadrature,
                                          dealii::update_quadrature_points |
                                            dealii::update_normal_vectors);
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const BoundaryCondition *condition :
               conditions.on_boundary(face->boundary_id()))
            {
              face_values.reinit(mesh_cell(cell), face);
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                for (const auto &direction : condition->elastic_directions(
                       face_values.normal_vector(q)))
                  motions[body_of(cell->material_id())].hold(
                    face_values.quadrature_point(q), direction);
            }
    for (RigidMotions &of_body : motions)
      of_body.merge(space.communicator());
    return motions;
  }



  void
  Supports::hold_wall(RigidMotions &motions)
  {
    if (conditions.minimal_support())
      {
        // The statically determinate support: A in x, y, z; B in y, z; C in y,
        // as far as nothing holds these motions yet. The same on all ranks.
        const auto points = geometry.support_points();
        const std::pair<unsigned int, unsigned int> candidates[] = {
          {0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 1}};
        for (const auto &[point, direction] : candidates)
          if (motions.hold(points[point], unit_vector(direction)))
            hold_vertex(points[point], direction, 0);
      }

    AssertThrow(motions.all_held(),
                ExcInput(
                  "The body can still move rigidly: " + motions.free_motions() +
                  ". Set 'Boundary conditions/Minimal support' to true, "
                  "or add a condition of type 'displacement' or "
                  "'spring' that holds it."));
  }



  void
  Supports::hold_liquid(RigidMotions &motions, const unsigned int segment)
  {
    // What the wall leaves free of a liquid that slips is a spin about the
    // axis of a full cross-section, and to move out of an open tube. One
    // vertex inside holds both; which one is the same on any number of ranks.
    std::set<dealii::types::global_dof_index> on_interface;
    for (const SlipInterface::NodePair &pair : interface.pairs())
      on_interface.insert(pair.liquid[0]);

    std::vector<dealii::Point<dim>> candidates(1);
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      if (body_of(cell->material_id()) == segment + 1)
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto i =
              cell->vertex_dof_index(v, 0, cell->active_fe_index());
            const auto &X    = cell->vertex(v);
            const auto &best = candidates[0];
            if (on_interface.count(i) == 0 && !base.is_constrained(i) &&
                std::make_tuple(X[1], X[2], X[0]) >
                  std::make_tuple(best[1], best[2], best[0]))
              candidates[0] = X;
          }
    candidates =
      dealii::Utilities::MPI::all_gather(space.communicator(), candidates[0]);
    const auto X =
      *std::max_element(candidates.begin(),
                        candidates.end(),
                        [](const auto &a, const auto &b) {
                          return std::make_tuple(a[1], a[2], a[0]) <
                                 std::make_tuple(b[1], b[2], b[0]);
                        });

    if (conditions.minimal_support())
      for (unsigned int direction = 0; direction < dim; ++direction)
        if (motions.hold(X, unit_vector(direction)))
          hold_vertex(X, direction, segment + 1);

    AssertThrow(motions.all_held(),
                ExcInput("The liquid of segment " +
                         std::to_string(segment + 1) +
                         ", which slips along the wall, can still move "
                         "rigidly: " +
                         motions.free_motions() +
                         ". Set 'Boundary conditions/Minimal support' to true, "
                         "or add a condition of type 'displacement' or "
                         "'spring' that holds it."));
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
          const auto i =
            cell->vertex_dof_index(v, direction, cell->active_fe_index());
          if (base.is_constrained(i))
            continue;
          base.add_line(i);
          prescribed.push_back({i, direction, body, X, nullptr});
        }
  }



  double
  Supports::set_increments(const Vector &solution, const double t)
  {
    const Vector relevant = space.with_ghosts(solution);

    double largest = 0.;
    for (const Prescribed &entry : prescribed)
      {
        if (entry.condition == nullptr)
          continue;
        const double missing =
          entry.condition->prescribed_displacement(entry.component,
                                                   entry.X,
                                                   t) -
          relevant(entry.index);
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
