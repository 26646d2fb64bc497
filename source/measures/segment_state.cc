// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/materials/cauchy_stress.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/segment_state.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lumbricus
{
  double
  SegmentState::mean_pressure() const
  {
    return liquid_volume > 0. ? pressure / liquid_volume : 0.;
  }



  double
  SegmentState::divergence(const double pressure_floor) const
  {
    return liquid_volume > 0. ?
             abs_deviator /
               std::max(abs_pressure, pressure_floor * liquid_volume) :
             0.;
  }



  std::vector<SegmentState>
  segment_states(const Body           &body,
                 const ReferenceField &references,
                 const Vector         &relevant_solution,
                 const Globals        &globals)
  {
    const MixedSpace         &space    = body.space;
    const ShapeCache         &shapes   = body.shapes;
    const Geometry           &geometry = body.anatomy.geometry();
    std::vector<SegmentState> states(geometry.n_segments());
    ElementKernel             kernel;
    MaterialResponse          response;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const ShapeCache::Cell shape = shapes.cell(cell.index);
        SegmentState          &state = states[cell.region.segment];

        kernel.read(space, cell.iterator, relevant_solution, indices);
        kernel.compute_deformation(shape);
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            const double J  = determinant(kernel.F[q]);
            const double dV = shape.JxW[q];
            if (!cell.is_liquid)
              {
                state.wall_volume += J * dV;
                continue;
              }
            cell.tissue.evaluate(kernel.F[q],
                                 kernel.pressure(shapes.pressure_modes(), q),
                                 references.cell(cell.index)[q],
                                 false,
                                 response);
            const auto   sigma    = cauchy_stress(response.P, kernel.F[q]);
            const double p        = -trace(sigma) / dim;
            const double deviator = dealii::deviator(sigma).norm();
            state.liquid_volume += J * dV;
            state.pressure += p * J * dV;
            state.abs_pressure += std::abs(p) * J * dV;
            state.abs_deviator += deviator * J * dV;
            state.largest_deviator = std::max(state.largest_deviator, deviator);
          }
      }

    // One reduction for all sums, one for all maxima.
    std::vector<double> sums, maxima;
    for (const SegmentState &state : states)
      {
        sums.insert(sums.end(),
                    {state.liquid_volume,
                     state.wall_volume,
                     state.pressure,
                     state.abs_pressure,
                     state.abs_deviator});
        maxima.push_back(state.largest_deviator);
      }
    const MPI_Comm comm = space.communicator();
    dealii::Utilities::MPI::sum(sums, comm, sums);
    dealii::Utilities::MPI::max(maxima, comm, maxima);

    const double whole = geometry.symmetry_factor();
    for (unsigned int s = 0; s < states.size(); ++s)
      {
        const double *sum          = &sums[5 * s];
        states[s].liquid_volume    = whole * sum[0];
        states[s].wall_volume      = whole * sum[1];
        states[s].pressure         = whole * sum[2];
        states[s].abs_pressure     = whole * sum[3];
        states[s].abs_deviator     = whole * sum[4];
        states[s].largest_deviator = maxima[s];
      }

    const auto cavities = geometry.cavities();
    const auto volumes  = cavity_volumes(body, relevant_solution);
    for (unsigned int k = 0; k < cavities.size(); ++k)
      {
        SegmentState &state = states[cavities[k].segment];
        const double  P     = globals.at(cavity_pressure)[k];
        state.liquid_volume = whole * volumes[k];
        state.pressure      = P * state.liquid_volume;
        state.abs_pressure  = std::abs(state.pressure);
      }
    return states;
  }



  namespace
  {
    // What a liquid cell adds to the mean pressure of its segment by the unknowns
    // of the pressure on it.
    using ByMode = std::array<double, MixedSpace::n_pressure_modes>;



    // Call f(cell, by_mode) for the liquid cells of segments in which someone is
    // interested.
    template <typename Interest, typename Function>
    void
    for_liquid_cells(const Body           &body,
                     const ReferenceField &references,
                     const Vector         &relevant_solution,
                     const Globals        &globals,
                     const Interest       &interest,
                     const Function       &f)
    {
      const MixedSpace &space  = body.space;
      const ShapeCache &shapes = body.shapes;
      const auto        states =
        segment_states(body, references, relevant_solution, globals);
      const double     whole = body.anatomy.geometry().symmetry_factor();
      ElementKernel    kernel;
      MaterialResponse response;
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : body.owned_cells())
        {
          const unsigned int s = cell.region.segment;
          if (!cell.is_liquid || !interest(s))
            continue;
          const ShapeCache::Cell shape = shapes.cell(cell.index);
          const double *const    modes = shapes.pressure_modes();
          kernel.read(space, cell.iterator, relevant_solution, indices);
          kernel.compute_deformation(shape);
          ByMode by_mode = {};
          for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
            {
              // Stress is linear in p.
              double p[2];
              for (unsigned int more = 0; more < 2; ++more)
                {
                  cell.tissue.evaluate(kernel.F[q],
                                       kernel.pressure(modes, q) + more,
                                       references.cell(cell.index)[q],
                                       false,
                                       response);
                  p[more] =
                    -trace(cauchy_stress(response.P, kernel.F[q])) / dim;
                }
              const double part = (p[1] - p[0]) * whole *
                                  determinant(kernel.F[q]) * shape.JxW[q] /
                                  states[s].liquid_volume;
              for (unsigned int m = 0; m < by_mode.size(); ++m)
                by_mode[m] += part * modes[by_mode.size() * q + m];
            }
          f(cell, by_mode);
        }
    }
  } // namespace



  std::vector<double>
  pressure_changes(const Body           &body,
                   const CellUnknowns   &unknowns,
                   const ReferenceField &references,
                   const Vector         &relevant_solution,
                   const Globals        &globals,
                   const Vector         &relevant_change,
                   const Globals        &change_of_globals)
  {
    std::vector<double> changes(body.anatomy.geometry().n_segments(), 0.);
    double              of_cell[CellUnknowns::n_per_cell];
    for_liquid_cells(
      body,
      references,
      relevant_solution,
      globals,
      [](const unsigned int /*segment*/) { return true; },
      [&](const OwnedCell &cell, const ByMode &by_mode) {
        unknowns.read(cell.index, relevant_change, of_cell);
        for (unsigned int m = 0; m < by_mode.size(); ++m)
          changes[cell.region.segment] +=
            by_mode[m] * of_cell[CellUnknowns::pressure(m)];
      });
    dealii::Utilities::MPI::sum(changes, body.space.communicator(), changes);
    const auto cavities = body.anatomy.geometry().cavities();
    for (unsigned int k = 0; k < cavities.size(); ++k)
      changes[cavities[k].segment] = change_of_globals.at(cavity_pressure)[k];
    return changes;
  }



  std::pair<Vector, Globals>
  pressure_derivative(const Body                &body,
                      const CellUnknowns        &unknowns,
                      const ReferenceField      &references,
                      const std::vector<double> &of_pressures,
                      const Vector              &relevant_solution,
                      const Globals             &globals)
  {
    std::pair<Vector, Globals> derivative;
    unknowns.reinit_vector(derivative.first);
    for_liquid_cells(
      body,
      references,
      relevant_solution,
      globals,
      [&](const unsigned int segment) { return of_pressures[segment] != 0.; },
      [&](const OwnedCell &cell, const ByMode &by_mode) {
        std::array<double, CellUnknowns::n_per_cell> of_cell = {};
        for (unsigned int m = 0; m < by_mode.size(); ++m)
          of_cell[CellUnknowns::pressure(m)] =
            of_pressures[cell.region.segment] * by_mode[m];
        unknowns.add(cell.index, of_cell.data(), derivative.first);
      });
    derivative.first.compress(dealii::VectorOperation::add);

    for (const auto &[name, values] : globals)
      derivative.second[name].assign(values.size(), 0.);
    const auto cavities = body.anatomy.geometry().cavities();
    for (unsigned int k = 0; k < cavities.size(); ++k)
      derivative.second.at(cavity_pressure)[k] =
        of_pressures[cavities[k].segment];
    return derivative;
  }
} // namespace lumbricus
