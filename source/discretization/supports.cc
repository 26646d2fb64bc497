// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/rigid_motions.h>
#include <lumbricus/discretization/supports.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
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
                     const Geometry           &geometry,
                     const BoundaryConditions &conditions)
    : space(space)
    , geometry(geometry)
    , conditions(conditions)
  {}



  void
  Supports::reinit()
  {
    increments.reinit(space.locally_relevant);
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler,
                                                    increments);
    prescribed.clear();
    prescribe_boundaries();
    hold_rigid_motions();
    increments.close();
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
                      increments.is_constrained(indices[i]))
                    continue;
                  increments.add_line(indices[i]);
                  prescribed.push_back(
                    {indices[i],
                     c,
                     space.mapping.transform_unit_to_real_cell(
                       cell, space.fe.unit_support_point(i)),
                     condition});
                }
          }
      }
  }



  void
  Supports::hold_rigid_motions()
  {
    const auto   points = geometry.support_points();
    const double L      = geometry.characteristic_length();
    RigidMotions motions(points[0], L);

    for (const Prescribed &entry : prescribed)
      motions.hold(entry.X, unit_vector(entry.component));

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
              face_values.reinit(cell, face);
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                for (const auto &direction : condition->elastic_directions(
                       face_values.normal_vector(q)))
                  motions.hold(face_values.quadrature_point(q), direction);
            }
    motions.merge(space.communicator());

    if (conditions.minimal_support())
      {
        // The statically determinate support: A in x, y, z; B in y, z; C in y,
        // as far as nothing holds these motions yet. The same on all ranks.
        const std::pair<unsigned int, unsigned int> candidates[] = {
          {0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 1}};
        for (const auto &[point, direction] : candidates)
          {
            if (!motions.hold(points[point], unit_vector(direction)))
              continue;
            for (const auto &cell : space.dof_handler.active_cell_iterators())
              for (const unsigned int v : cell->vertex_indices())
                {
                  if (cell->is_artificial() ||
                      cell->vertex(v).distance(points[point]) > 1e-8 * L)
                    continue;
                  const auto i = cell->vertex_dof_index(v, direction);
                  if (increments.is_constrained(i))
                    continue;
                  increments.add_line(i);
                  prescribed.push_back({i, direction, points[point], nullptr});
                }
          }
      }

    AssertThrow(motions.all_held(),
                ExcInput(
                  "The body can still move rigidly: " + motions.free_motions() +
                  ". Set 'Boundary conditions/Minimal support' to true, "
                  "or add a condition of type 'displacement' or "
                  "'spring' that holds it."));
  }



  double
  Supports::set_increments(const Vector &solution, const double t)
  {
    Vector relevant(space.locally_owned,
                    space.locally_relevant,
                    space.communicator());
    relevant = solution;

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
        increments.set_inhomogeneity(entry.index, missing);
        largest = std::max(largest, std::abs(missing));
      }
    return dealii::Utilities::MPI::max(largest, space.communicator());
  }



  void
  Supports::set_increments_to_zero()
  {
    for (const Prescribed &entry : prescribed)
      increments.set_inhomogeneity(entry.index, 0.);
  }



  const dealii::AffineConstraints<double> &
  Supports::constraints() const
  {
    return increments;
  }
} // namespace lumbricus
