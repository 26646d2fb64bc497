// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/body_motion.h>
#include <lumbricus/measures/section_measures.h>

#include <deal.II/base/mpi.h>

#include <array>

namespace lumbricus
{
  namespace
  {
    // A mass and its moments at rest and now. With the density 1 too.
    struct Mass
    {
      std::array<double, 2> rest = {}, now = {};
      dealii::Tensor<1, dim> rest_moment[2], moment[2];

      void
      add(const double              density,
          const double              volume_at_rest,
          const dealii::Point<dim> &X,
          const double              volume,
          const dealii::Point<dim> &x)
      {
        for (const unsigned int k : {0, 1})
          {
            const double rho = k == 0 ? density : 1.;
            rest[k] += rho * volume_at_rest;
            now[k] += rho * volume;
            rest_moment[k] += rho * volume_at_rest * X;
            moment[k] += rho * volume * x;
          }
      }
    };



    void
    sum_over_ranks(Mass &mass, const MPI_Comm comm)
    {
      std::vector<double> sums;
      const auto          for_each = [&](const auto &function) {
        for (const unsigned int k : {0, 1})
          {
            function(mass.rest[k]);
            function(mass.now[k]);
            for (unsigned int c = 0; c < dim; ++c)
              {
                function(mass.rest_moment[k][c]);
                function(mass.moment[k][c]);
              }
          }
      };
      for_each([&](const double value) { sums.push_back(value); });
      dealii::Utilities::MPI::sum(sums, comm, sums);
      const double *sum = sums.data();
      for_each([&](double &value) { value = *sum++; });
    }



    // That of the tissues, which is the one at rest.
    Mass
    mass_of_tissues(const Body &body, const Vector &relevant)
    {
      Mass          mass;
      ElementKernel kernel;
      std::vector<dealii::types::global_dof_index> indices(
        body.space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : body.owned_cells())
        {
          if (cell.is_liquid)
            continue;
          kernel.read(body.space, cell.iterator, relevant, indices);
          const ShapeCache::Cell shape = body.shapes.cell(cell.index);
          for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
            {
              const auto X = body.shapes.quadrature_point(cell.index, q);
              const auto x =
                X + kernel.displacement(body.shapes.node_values(q));
              mass.add(
                cell.tissue.density(), shape.JxW[q], X, shape.JxW[q], x);
            }
        }
      sum_over_ranks(mass, body.space.communicator());
      return mass;
    }



    dealii::Tensor<1, dim>
    forward(const BoundaryConditions &conditions)
    {
      for (const Contact *contact : contacts_of(conditions))
        if (contact != nullptr)
          return contact->friction().forward({});
      return -dealii::Point<dim>::unit_vector(0);
    }
  } // namespace



  BodyMotion
  body_motion(const Body               &body,
              const BoundaryConditions &conditions,
              LiquidWeight             &liquids,
              const Vector             &solution)
  {
    const Vector relevant = body.space.with_ghosts(solution);
    Mass         mass     = mass_of_tissues(body, relevant);
    const auto   at_rest  = liquids.chambers_at(nullptr);
    const auto   now      = liquids.chambers_at(&relevant);
    for (unsigned int s = 0; s < now.size(); ++s)
      mass.add(now[s].density,
               at_rest[s].volume,
               at_rest[s].centre,
               now[s].volume,
               now[s].centre);

    BodyMotion         motion;
    const unsigned int k = mass.now[0] > 0. ? 0 : 1;
    motion.centre        = dealii::Point<dim>(mass.moment[k] / mass.now[k]);
    motion.displacement =
      motion.centre -
      dealii::Point<dim>(mass.rest_moment[k] / mass.rest[k]);
    for (const SymmetryPlane &plane : body.anatomy.geometry().symmetry_planes())
      {
        motion.centre[plane.direction] =
          plane.position(body.space.triangulation);
        motion.displacement[plane.direction] = 0.;
      }
    motion.stride = motion.displacement * forward(conditions);

    const auto sections = section_measures(body, relevant);
    motion.head         = sections.front().begin;
    motion.tail         = sections.back().end;
    for (const SectionMeasures &section : sections)
      motion.length += section.length;
    return motion;
  }
} // namespace lumbricus
