// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/step_work.h>

#include <deal.II/base/mpi.h>

#include <map>

namespace lumbricus
{
  namespace
  {
    using Entry = StepWork::Entry;

    // What is needed of a state in a cell.
    struct Deformation
    {
      ElementKernel        kernel;
      const MaterialPoint *points = nullptr;

      void
      read(const Body                                   &body,
           const OwnedCell                              &cell,
           const Vector                                 &relevant,
           const ReferenceField                         &references,
           std::vector<dealii::types::global_dof_index> &indices)
      {
        kernel.read(body.space, cell.iterator, relevant, indices);
        kernel.compute_deformation(body.shapes.cell(cell.index));
        points = references.cell(cell.index);
      }

      // psi at a quadrature point, with another reference map.
      double
      energy(const Body           &body,
             const Tissue         &tissue,
             const unsigned int    q,
             const ReferencePoint &reference) const
      {
        return tissue.energy(
          kernel.F[q],
          kernel.pressure(body.shapes.pressure_modes(), q),
          reference);
      }
    };



    // What a muscle adds to the stress.
    dealii::Tensor<2, dim>
    active_stress(const Muscle                 &muscle,
                  const dealii::Tensor<2, dim> &F,
                  const MuscleFibre            &fibre)
    {
      MaterialResponse response;
      response.P = 0.;
      muscle.action().add_stress(F, fibre, false, response);
      return response.P;
    }
  } // namespace



  double
  StepWork::imbalance() const
  {
    double sum = -stored_more;
    for (const Entry &muscle : muscles)
      sum += muscle.work;
    for (const ExternalForce &load : loads)
      sum += load.work;
    for (const Entry &tissue : viscosity)
      sum -= tissue.work;
    return sum;
  }



  double
  stored_energy(const Body           &body,
                const ReferenceField &references,
                const State          &state)
  {
    const MixedSpace &space    = body.space;
    const Vector      relevant = space.with_ghosts(state.solution);
    Deformation       here;
    double            sum = 0.;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        here.read(body, cell, relevant, references, indices);
        const auto JxW = body.shapes.cell(cell.index).JxW;
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          sum +=
            JxW[q] *
            (here.energy(body, cell.tissue, q, here.points[q].reference) +
             cell.tissue.viscous_energy(here.kernel.F[q], here.points[q]));
      }
    return dealii::Utilities::MPI::sum(sum, space.communicator());
  }



  std::vector<Entry>
  work_of_muscles(const Body          &body,
                  const StateWithMaps &a,
                  const StateWithMaps &b)
  {
    const MixedSpace   &space   = body.space;
    const Anatomy      &anatomy = body.anatomy;
    std::vector<double> works(anatomy.n_muscles(), 0.);
    const bool          at_end_alone = muscles_feel_speed(anatomy);
    std::map<const Muscle *, unsigned int> numbers;
    for (unsigned int i = 0; i < works.size(); ++i)
      numbers[&anatomy.muscle(i)] = i;

    const Vector relevant_a = space.with_ghosts(a.state.solution);
    const Vector relevant_b = space.with_ghosts(b.state.solution);
    Deformation  at_a, at_b;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const Tissue &tissue  = cell.tissue;
        const auto   &muscles = tissue.muscles();
        if (muscles.empty())
          continue;
        at_a.read(body, cell, relevant_a, a.references, indices);
        at_b.read(body, cell, relevant_b, b.references, indices);
        const auto JxW = body.shapes.cell(cell.index).JxW;
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            // By how much psi is more with the other activation of a muscle.
            const auto with_other = [&](const Deformation &here,
                                        const Deformation &other,
                                        const unsigned int k) {
              const MaterialPoint &point  = here.points[q];
              auto                 fibres = point.fibres;
              fibres[k]                   = other.points[q].fibres[k];
              const auto other_map =
                tissue.reference_map(fibres, point.elastic_fibres);
              return here.energy(body, tissue, q, other_map) -
                     here.energy(body, tissue, q, point.reference);
            };
            const auto way = at_b.kernel.F[q] - at_a.kernel.F[q];
            for (unsigned int k = 0; k < muscles.size(); ++k)
              {
                const MuscleFibre &before = at_a.points[q].fibres[k];
                const MuscleFibre &after  = at_b.points[q].fibres[k];
                double             work   = 0.;
                if (before.activation != after.activation)
                  work = with_other(at_a, at_b, k) - with_other(at_b, at_a, k);
                // An active stress has no energy.
                const auto P_b =
                  active_stress(*muscles[k], at_b.kernel.F[q], after);
                // At the end of the last step nothing knows how fast it was.
                const auto P_a =
                  at_end_alone ?
                    P_b :
                    active_stress(*muscles[k], at_a.kernel.F[q], before);
                work -= scalar_product(P_a + P_b, way);
                works[numbers.at(muscles[k])] += 0.5 * JxW[q] * work;
              }
          }
      }
    dealii::Utilities::MPI::sum(works, space.communicator(), works);
    std::vector<Entry> all;
    for (unsigned int i = 0; i < works.size(); ++i)
      all.push_back({anatomy.muscle(i).name(), works[i]});
    return all;
  }



  std::vector<Entry>
  work_of_viscosity(const Body &body, const State &a, const StateWithMaps &b)
  {
    std::map<std::string, double> works;
    const MixedSpace             &space   = body.space;
    const auto                    tissues = body.anatomy.geometry().tissues();
    for (unsigned int i = 0; i < tissues.size(); ++i)
      if (body.anatomy.tissue(i).viscous_branches().size() > 0)
        works[tissues[i].name] = 0.;
    if (works.empty())
      return {};
    const Vector relevant_a = space.with_ghosts(a.solution);
    const Vector relevant_b = space.with_ghosts(b.state.solution);
    Deformation  at_a, at_b;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const Tissue &tissue = cell.tissue;
        if (tissue.viscous_branches().size() == 0)
          continue;
        at_a.read(body, cell, relevant_a, b.references, indices);
        at_b.read(body, cell, relevant_b, b.references, indices);
        const auto JxW = body.shapes.cell(cell.index).JxW;
        double    &sum = works.at(tissue.name());
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          sum += JxW[q] * tissue.dissipated(at_a.kernel.F[q],
                                            at_b.kernel.F[q],
                                            at_b.points[q]);
      }
    std::vector<Entry> all;
    for (const auto &[name, work] : works)
      all.push_back(
        {name, dealii::Utilities::MPI::sum(work, space.communicator())});
    return all;
  }



  std::vector<Entry>
  work_of_friction(const Body               &body,
                   const BoundaryConditions &conditions,
                   SurfaceTerms             &terms,
                   const State              &a,
                   const State              &b)
  {
    std::vector<Entry> all;
    if (!has_contact(conditions))
      return all;
    const auto          contacts = contacts_of(conditions);
    std::vector<double> works(contacts.size(), 0.);
    const MixedSpace   &space = body.space;
    Vector              way   = b.solution;
    way -= a.solution;
    const Vector  moves = space.with_ghosts(way);
    ElementKernel kernel, moving;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const State *state : {&a, &b})
      {
        terms.set_to(*state);
        const Vector relevant = space.with_ghosts(state->solution);
        for (const OwnedCell cell : body.owned_cells())
          {
            if (!cell.iterator->at_boundary())
              continue;
            kernel.read(space, cell.iterator, relevant, indices);
            moving.read(space, cell.iterator, moves, indices);
            terms.visit_points(
              cell,
              kernel.u,
              state->time,
              [&](const unsigned int i, const SurfacePoint &at) {
                if (contacts[i] == nullptr)
                  return;
                const SurfaceKernel &point    = terms.point();
                const auto           x0       = at.X + at.history;
                const Obstacle      &obstacle = contacts[i]->obstacle();
                // The obstacle goes there by itself.
                const auto w = moving.displacement(point.values) -
                               (obstacle.carried(x0, b.time) -
                                obstacle.carried(x0, a.time));
                works[i] -= 0.5 * point.JxW *
                            (contacts[i]->standing(at).friction.T * w);
              });
          }
      }
    dealii::Utilities::MPI::sum(works, space.communicator(), works);
    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (contacts[i] != nullptr)
        all.push_back({conditions.condition(i).name, works[i]});
    return all;
  }
} // namespace lumbricus
