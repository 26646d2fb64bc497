// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_finer_model_h
#define lumbricus_program_finer_model_h

#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/finer_solver.h>
#include <lumbricus/program/chain_model.h>

#include <deal.II/base/timer.h>

#include <memory>

namespace lumbricus
{
  /**
   * The body of a run on a mesh that has eight cells in place of each, with all
   * its loads, obstacles and chambers, and one increment of Newton's method there:
   * what the run's mesh lacks. Its cells have the true curved shape where those of
   * a mesh that is refined once more everywhere would have it.
   */
  class FinerModel
  {
  public:
    /** For @p model as it is, which is kept by reference. Collective. */
    explicit FinerModel(ChainModel &model);

    /** What @p state, an equilibrium of the model, would be like on the finer
     * mesh. Leaves the model linearised there. Throws what a load step may
     * throw. Collective. */
    ResetIteration::Solve
    measure(const State &state);

  private:
    ChainModel         &model;
    dealii::TimerOutput timer; ///< whose times nobody asks for
    FinerSolver         solver;
    ChainModel          finer;

    std::unique_ptr<CutCells> cells;
  };
} // namespace lumbricus

#endif
