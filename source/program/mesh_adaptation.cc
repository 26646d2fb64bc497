// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_adaptation.h"

#include <lumbricus/adaptivity/mesh_record.h>
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/discretization/state_beside.h>
#include <lumbricus/discretization/state_record.h>
#include <lumbricus/measures/rest_volume.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "estimated_model.h"

namespace lumbricus
{
  namespace
  {
    // A mesh and the state on it, to go back to.
    class Backup
    {
    public:
      Backup(const ChainModel &model, const State &state)
        : refined(refined_cells(model.triangulation))
        , outline(state.outline())
      {
        std::ostringstream out;
        write_cells(model.space, state, out);
        cells = out.str();
      }

      void
      restore(ChainModel &model, State &state) const
      {
        coarsen_completely(model.triangulation);
        refine_cells(model.triangulation, refined);
        model.number_unknowns();
        model.reinit();

        state = model.space.zero_state(outline);
        // Cells may have come to other ranks.
        CellReader reader(model.space, state);
        for (const std::string &of_rank :
             dealii::Utilities::MPI::all_gather(model.space.communicator(),
                                                cells))
          {
            std::istringstream in(of_rank);
            reader.read(in);
          }
        model.references.update(state);
      }

      const std::set<CellKey> refined;

    private:
      const StateOutline outline;
      std::string        cells;
    };



    std::size_t
    n_not_in(const std::set<CellKey> &others, const std::set<CellKey> &cells)
    {
      return std::count_if(cells.begin(), cells.end(), [&](const auto &cell) {
        return others.count(cell) == 0;
      });
    }



    double
    relative_change(const double before, const double after)
    {
      const double larger = std::max(std::abs(before), std::abs(after));
      return larger > 0. ? std::abs(after - before) / larger : 0.;
    }



    void
    compare(const std::vector<SegmentState> &before,
            const std::vector<SegmentState> &after,
            AdaptationRecord                &record)
    {
      for (unsigned int s = 0; s < before.size(); ++s)
        {
          record.volume_change = std::max(
            {record.volume_change,
             relative_change(before[s].liquid_volume, after[s].liquid_volume),
             relative_change(before[s].wall_volume, after[s].wall_volume)});
          record.pressure_change =
            std::max(record.pressure_change,
                     relative_change(before[s].mean_pressure(),
                                     after[s].mean_pressure()));
        }
    }



    // Estimate the error of a state and mark cells.
    void
    mark(ChainModel                  &model,
         const State                 &state,
         const ResetIteration::Solve &solve,
         AdaptationRecord            &record)
    {
      const Adaptivity   &adaptivity = model.parameters.adaptivity;
      EstimatedModel      estimated(model, state, solve);
      const ErrorEstimate estimate = adaptivity.estimator().estimate(estimated);
      record.estimated_error = estimate.relative;
      record.any             = adaptivity.mark(estimate,
                                   model.space.dof_handler.n_dofs(),
                                   model.is_slip_interface(),
                                   model.triangulation);
    }



    // Refine and coarsen what is marked, and take the state along.
    void
    change_mesh(ChainModel &model, State &state)
    {
      const IsSlipInterface slips       = model.is_slip_interface();
      const auto            volumes     = rest_volumes(model.body, state);
      const bool            has_beside  = has_state_beside(state);
      const auto            of_beside   = [&]() {
        return state_beside(model.space, state);
      };
      const auto volumes_beside = has_beside ?
                                    rest_volumes(model.body, of_beside()) :
                                    std::vector<double>();
      do
        change_mesh(
          model.triangulation,
          model.space,
          [&]() { model.number_unknowns(); },
          state);
      while (mark_where(model.triangulation, [&](const auto &cell) {
        return coarser_across_interface(cell, slips);
      }));
      model.reinit();
      // Where cells were merged, the liquid's stress-free shape is another one.
      set_rest_volumes(volumes, model.body, state);
      if (!has_beside)
        return;
      State beside = of_beside();
      set_rest_volumes(volumes_beside, model.body, beside);
      put_beside(model.space, beside, state);
    }
    // What keeps an action from being done, if anything does: no convergence, an
    // expression without a value at a new point, too little memory for so many
    // unknowns.
    template <typename Action>
    std::string
    trouble_of(const Action &action)
    {
      try
        {
          action();
        }
      catch (const dealii::ExceptionBase &exception)
        {
          if (!is_thrown_on_all_ranks(exception))
            throw;
          return plain_message(exception);
        }
      return "";
    }
  } // namespace



  AdaptationRecord
  adapt_mesh(ChainModel                  &model,
             State                       &state,
             const ResetIteration::Solve &last,
             Log                         &log)
  {
    // A safe point is where the step is done, on one mesh.
    const Uninterrupted uninterrupted;
    AdaptationRecord    record;
    std::string         trouble = trouble_of([&]() {
      dealii::TimerOutput::Scope scope(model.timer, "error estimate");
      with_memory_message(model.space.communicator(),
                          [&]() { mark(model, state, last, record); });
    });
    if (record.any)
      {
        const Backup backup(model, state);
        trouble = trouble_of([&]() {
          {
            dealii::TimerOutput::Scope scope(model.timer, "new mesh");
            with_memory_message(model.space.communicator(),
                                [&]() { change_mesh(model, state); });
          }
          with_memory_message(model.space.communicator(), [&]() {
            record.report = model.solve(state);
          });
          record.converged = true;
          compare(last.segments, record.report.solves.back().segments, record);
          const auto refined = refined_cells(model.triangulation);
          record.n_refined   = n_not_in(backup.refined, refined);
          record.n_coarsened = n_not_in(refined, backup.refined);
        });
        if (!trouble.empty())
          backup.restore(model, state);
      }
    if (!trouble.empty())
      log << "        the mesh stays as it was: " << trouble << "\n";
    record.n_cells    = model.triangulation.n_global_active_cells();
    record.n_unknowns = model.space.dof_handler.n_dofs();
    return record;
  }
} // namespace lumbricus
