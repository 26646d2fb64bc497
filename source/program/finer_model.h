// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_finer_model_h
#define lumbricus_program_finer_model_h

#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/finer_solver.h>
#include <lumbricus/errors/segment_error.h>
#include <lumbricus/program/chain_model.h>

#include <deal.II/base/timer.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * The body of a run on a mesh that has eight cells in place of each, with all
   * its loads, obstacles and chambers, and one increment of Newton's method there:
   * what the run's mesh lacks.
   */
  class FinerModel
  {
  public:
    /** The shape of the small cells. */
    enum class Shape
    {
      true_one, ///< of a mesh that is refined once more everywhere
      same      ///< of cells that are refined some time
    };

    /** For @p model as it is, which is kept by reference. Collective. */
    FinerModel(ChainModel &model, const Shape shape);

    /** What the numbers of all segments lack at @p state, an equilibrium where the
     * model has found @p solve, to first order. Leaves the model linearised there.
     * Throws what a load step may throw. Collective. */
    std::vector<SegmentError>
    errors(const State &state, const ResetIteration::Solve &solve);

    /** Where the error of a number comes from, after errors(): for each owned cell
     * of the model see FinerSolver::contributions(), for the number
     *
     *   sum_s f_s . (length_s, mid_radius_s, pressure_s)
     *
     * with factors @p f of all segments. Collective. */
    std::vector<double>
    contributions(const std::vector<SegmentError> &f);

  private:
    ChainModel         &model;
    const Shape         shape;
    dealii::TimerOutput timer; ///< whose times nobody asks for
    FinerSolver         solver;
    ChainModel          finer;

    std::unique_ptr<CutCells> cells;
    State                     prolongated; ///< the last one, on the small cells
  };
} // namespace lumbricus

#endif
