// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/cavity_volume.h>
#include <lumbricus/measures/external_forces.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    // One entry for everything that can act, without forces.
    std::vector<ExternalForce>
    everything_that_acts(const Geometry           &geometry,
                         const BoundaryConditions &conditions,
                         const BodyForces         &body_forces,
                         const Supports           &supports)
    {
      std::vector<ExternalForce> all;
      const auto                 add = [&](const ExternalForce::Kind kind,
                           const std::string        &name) {
        ExternalForce entry;
        entry.kind = kind;
        entry.name = name;
        all.push_back(entry);
      };
      for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
        add(ExternalForce::Kind::condition, conditions.condition(i).name);
      for (const SymmetryPlane &plane : geometry.symmetry_planes())
        add(ExternalForce::Kind::symmetry,
            std::string("symmetry ") + "xyz"[plane.direction]);
      for (const MinimalSupport::HeldPoint &point : supports.minimal_support())
        {
          add(ExternalForce::Kind::minimal_support, "minimal support");
          all.back().X         = point.X;
          all.back().direction = point.direction;
        }
      for (unsigned int i = 0; i < body_forces.n_forces(); ++i)
        add(ExternalForce::Kind::body_force, body_forces.force(i).name);
      if (!geometry.cavities().empty())
        add(ExternalForce::Kind::cavities, "cavities");
      return all;
    }



    // A vector to which this rank's cells may add through these links, which
    // under slip may lead to unknowns that are none of the cells around.
    Vector
    vector_of(const dealii::AffineConstraints<double> &links,
              const MixedSpace                        &space)
    {
      dealii::IndexSet reached = space.locally_relevant;
      for (const auto &line : links.get_lines())
        for (const auto &entry : line.entries)
          reached.add_index(entry.first);
      return Vector(space.locally_owned, reached, space.communicator());
    }



    void
    sum_over_ranks(std::vector<ExternalForce> &all, const MPI_Comm comm)
    {
      std::vector<double> sums;
      for (const ExternalForce &entry : all)
        {
          for (unsigned int c = 0; c < dim; ++c)
            sums.insert(sums.end(), {entry.force[c], entry.moment[c]});
          sums.insert(sums.end(), {entry.magnitude, entry.work});
        }
      dealii::Utilities::MPI::sum(sums, comm, sums);
      const double *sum = sums.data();
      for (ExternalForce &entry : all)
        {
          for (unsigned int c = 0; c < dim; ++c)
            {
              entry.force[c]  = *sum++;
              entry.moment[c] = *sum++;
            }
          entry.magnitude = *sum++;
          entry.work      = *sum++;
        }
    }
  } // namespace



  std::string
  ExternalForce::kind_name() const
  {
    switch (kind)
      {
        case Kind::condition:
          return "boundary condition";
        case Kind::body_force:
          return "body force";
        case Kind::cavities:
          return "cavities";
        case Kind::symmetry:
          return "symmetry plane";
        case Kind::minimal_support:
          return "minimal support";
      }
    Assert(false, dealii::ExcInternalError());
    return "";
  }



  void
  ExternalForce::add(const dealii::Point<dim>     &x,
                     const dealii::Tensor<1, dim> &f,
                     const dealii::Tensor<1, dim> &w)
  {
    work += f * w;
    force += f;
    moment += dealii::cross_product_3d(x, f);
    magnitude += f.norm();
  }



  ExternalForce &
  ExternalForce::operator+=(const ExternalForce &other)
  {
    force += other.force;
    moment += other.moment;
    magnitude += other.magnitude;
    work += other.work;
    return *this;
  }



  std::vector<ExternalForce>
  external_forces(const Body               &body,
                  const BoundaryConditions &conditions,
                  SurfaceTerms             &terms,
                  const BodyForces         &body_forces,
                  const VolumeTerms        &volume_terms,
                  LiquidWeight             &liquid_weight,
                  const ReferenceField     &references,
                  const Supports           &supports,
                  const Vector             &solution,
                  const Globals            &globals,
                  const double              t,
                  const Vector             *way)
  {
    const MixedSpace &space    = body.space;
    const ShapeCache &shapes   = body.shapes;
    const Geometry   &geometry = body.anatomy.geometry();
    auto all =
      everything_that_acts(geometry, conditions, body_forces, supports);
    const unsigned int n_conditions = conditions.n_conditions();
    const unsigned int n_planes     = geometry.symmetry_planes().size();

    const auto         walls = geometry.cavities();
    const CavityFaces  cavities(geometry);
    const bool         has_cavities = cavities.size() > 0;
    const unsigned int first_body_force =
      all.size() - has_cavities - body_forces.n_forces();
    SurfaceKernel surface(space);

    const Vector      relevant = space.with_ghosts(solution);
    const Vector      moves =
      way != nullptr ? space.with_ghosts(*way) : Vector();
    const auto        links    = supports.links();
    std::vector<bool> held(space.locally_relevant.n_elements(), false);
    for (const Supports::Prescribed &entry : supports.prescribed_unknowns())
      held[space.locally_relevant.index_within_set(entry.index)] = true;

    Vector                 nodal  = vector_of(links, space);
    const unsigned int     n_dofs = space.fe.n_dofs_per_cell();
    dealii::Vector<double> of_cell(n_dofs);
    std::vector<dealii::types::global_dof_index> indices(n_dofs);
    ElementKernel                                kernel, moving;
    for (const OwnedCell cell : body.owned_cells())
      {
        cell.iterator->get_dof_indices(indices);
        const bool supported =
          std::any_of(indices.begin(), indices.end(), [&](const auto index) {
            return held[space.locally_relevant.index_within_set(index)] ||
                   links.is_constrained(index);
          });
        const bool is_pulled = volume_terms.act_in(cell);
        const bool is_pressed = liquid_weight.acts_on(cell);
        if (!supported && !is_pulled && !is_pressed &&
            !cell.iterator->at_boundary())
          continue;

        kernel.read(space, cell.iterator, relevant, indices);
        if (way != nullptr)
          moving.read(space, cell.iterator, moves, indices);
        of_cell = 0.;
        if (supported)
          {
            kernel.evaluate(shapes.cell(cell.index),
                            shapes.pressure_modes(),
                            cell.tissue,
                            references.cell(cell.index),
                            nullptr);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                of_cell(space.displacement_dof[c][n]) = kernel.force[c][n];
          }
        const auto pull = [&](ExternalForce                &entry,
                              const dealii::Point<dim>     &x,
                              const dealii::Tensor<1, dim> &f,
                              const double                 *N) {
          entry.add(x,
                    f,
                    way != nullptr ? moving.displacement(N) :
                                     dealii::Tensor<1, dim>());
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
              of_cell(space.displacement_dof[c][n]) -= N[n] * f[c];
        };
        terms.visit(
          cell,
          kernel.u,
          t,
          [&](const unsigned int condition, const SurfaceResponse &response) {
            const SurfaceKernel &point = terms.point();
            pull(all[condition],
                 point.X + point.u,
                 point.JxW * response.T,
                 point.values);
          });
        for (const unsigned int f : cell.iterator->face_indices())
          {
            const unsigned int k = cavities.at(cell, f);
            if (k == CavityFaces::none)
              continue;
            surface.reinit(cell.iterator, f);
            double of_face[CellUnknowns::n_per_cell] = {};
            for (unsigned int q = 0; q < surface.n_points(); ++q)
              {
                surface.set(q, kernel.u);
                add_volume_derivative(surface, walls[k], of_face);
              }
            // Also on the rims of pistons: forces on nodes, not on points.
            for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
              {
                dealii::Point<dim>     x = shapes.node(cell.index, n);
                dealii::Tensor<1, dim> force, w;
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    x[c] += kernel.u[c][n];
                    force[c] = globals.at(cavity_pressure)[k] *
                               of_face[CellUnknowns::displacement(c, n)];
                    of_cell(space.displacement_dof[c][n]) -= force[c];
                    w[c] = moving.u[c][n];
                  }
                all.back().add(x, force, w);
              }
          }
        if (is_pressed)
          liquid_weight.visit(cell,
                              kernel.u,
                              [&](const unsigned int force,
                                  const dealii::Tensor<1, dim> & /*gravity*/,
                                  const double q,
                                  const double sign) {
                                const SurfaceKernel &point =
                                  liquid_weight.point();
                                pull(all[first_body_force + force],
                                     point.X + point.u,
                                     sign * q * point.JxW *
                                       (cofactor(point.F) * point.N),
                                     point.values);
                              });
        if (is_pulled)
          volume_terms.visit(cell,
                             kernel.u,
                             t,
                             [&](const unsigned int        force,
                                 const VolumeTerms::Point &point,
                                 const VolumeResponse     &response) {
                               pull(all[first_body_force + force],
                                    point.x,
                                    point.JxW * response.b,
                                    point.values);
                             });
        if (supported)
          links.distribute_local_to_global(of_cell, indices, nodal);
      }
    nodal.compress(dealii::VectorOperation::add);

    for (const Supports::Prescribed &entry : supports.prescribed_unknowns())
      {
        if (!space.locally_owned.is_element(entry.index))
          continue;
        dealii::Point<dim>     x = entry.X;
        dealii::Tensor<1, dim> r, w;
        for (unsigned int c = 0; c < dim; ++c)
          {
            x[c] += relevant(entry.node[c]);
            w[c] = way != nullptr ? moves(entry.node[c]) : 0.;
          }
        r[entry.component] = nodal(entry.index);
        if (entry.by == Supports::By::condition)
          all[entry.number].add(x, r, w);
        else if (entry.by == Supports::By::symmetry)
          all[n_conditions + entry.number].add(x, r, w);
        else
          all[n_conditions + n_planes + entry.number].add(x, r, w);
      }
    sum_over_ranks(all, space.communicator());
    return all;
  }
} // namespace lumbricus
