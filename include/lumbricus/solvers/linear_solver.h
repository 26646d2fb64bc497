// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_linear_solver_h
#define lumbricus_solvers_linear_solver_h

#include <lumbricus/core/parameter_owner.h>
#include <lumbricus/core/state.h>

#include <memory>

namespace lumbricus
{
  /** What a linear solver did since it was made, for tables and logs. */
  struct LinearSolverStatistics
  {
    unsigned int n_solves         = 0;
    unsigned int n_iterations     = 0;
    unsigned int n_factorisations = 0;
    double       factor_seconds   = 0.;
    double       solve_seconds    = 0.;
  };



  /**
   * Solves A x = b for the tangent of the mixed problem (indefinite; symmetric
   * where the loads are). One matrix at a time: set_matrix(), then solve() as
   * often as wanted. All functions are collective.
   */
  class LinearSolver : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** Called when the mesh or the constraints are new: forget the old. */
    virtual void
    reinit(const bool symmetric) = 0;

    /** The values of the matrix are new. It must live until the next call. */
    virtual void
    set_matrix(const Matrix &A) = 0;

    /**
     * Solve to the relative residual @p tolerance or better. Throws
     * ExcNotConverged where that is not possible.
     */
    virtual void
    solve(Vector &x, const Vector &b, const double tolerance) = 0;

    const LinearSolverStatistics &
    statistics() const
    {
      return counts;
    }

  protected:
    LinearSolverStatistics counts;
  };
} // namespace lumbricus

#endif
