// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_chain_problem_h
#define lumbricus_program_chain_problem_h

#include <lumbricus/core/log.h>
#include <lumbricus/discretization/assembler.h>
#include <lumbricus/output/results.h>
#include <lumbricus/program/run_parameters.h>
#include <lumbricus/solvers/equilibrium.h>

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>

namespace lumbricus
{
  /**
   * A run, put together from its parts: geometry, fibres, reference maps,
   * assembly, solvers, output. It composes and computes nothing itself.
   */
  class ChainProblem
  {
  public:
    ChainProblem(RunParameters &parameters, Log &log, const MPI_Comm comm);

    /** Make the mesh and number the unknowns. Throws ExcInput. */
    void
    setup();

    /** Say how many cells and unknowns there are. */
    void
    describe();

    /**
     * Compute the run and write its results to @p folder. Throws
     * ExcSolveFailed, with the last good state on disk.
     */
    void
    run(const RunFolder &folder);

  private:
    /** Take one load step, as long as converges. Throws ExcSolveFailed. */
    StepRecord
    advance(State &state, const unsigned int number);

    void
    log_step(const StepRecord &step);

    void
    log_where_time_went();

    RunParameters &parameters;
    Log           &log;
    const MPI_Comm comm;

    dealii::Timer       run_timer;
    dealii::TimerOutput timer;

    dealii::parallel::distributed::Triangulation<dim> triangulation;

    MixedSpace     space;
    ShapeCache     shapes;
    ReferenceField references;
    Supports       supports;
    Assembler      assembler;
    Equilibrium    equilibrium;
  };
} // namespace lumbricus

#endif
