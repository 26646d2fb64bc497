// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_kept_preconditioner_h
#define lumbricus_linear_kept_preconditioner_h

#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/factor_age.h>
#include <lumbricus/linear/linear_solver.h>

#include <deal.II/base/types.h>

#include <functional>
#include <memory>
#include <vector>

namespace lumbricus
{
  class BorderedInverse;



  /**
   * FGMRES, preconditioned by an approximate inverse of an earlier tangent,
   * which is kept across Newton iterations, resets and load steps for as long
   * as the iterations it costs are fewer than a new one is worth (FactorAge).
   *
   * Where even a new one does not do, the next more robust kind of inverse is
   * taken, and used until the number of unknowns is another one. Whatever
   * solve() throws, the next solve() begins with a new inverse of the kind it
   * has come to.
   */
  class KeptPreconditioner : public LinearSolver
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    reinit(const Tangent &tangent) override;

    using LinearSolver::solve;

    void
    solve(Vector &x, const Vector &b, const double wanted_tolerance) override;

    KeptPreconditioner();
    ~KeptPreconditioner() override;

  protected:
    void
    solve_bordered(Vector                    &x,
                   std::vector<double>       &g,
                   const Vector              &b,
                   const std::vector<double> &c,
                   const Border              &border,
                   const double               wanted_tolerance) override;

    /** The inverse of kind @p kind for the pattern of @p tangent: the fastest
     * is 0, each one more is more robust; without an inverse where there is
     * none left. Collective. */
    virtual InverseKind
    make(const Tangent &tangent, const unsigned int kind) = 0;

  private:
    /** Let go of the inverse. */
    void
    drop();

    /** Call @p iterate, which says whether it has solved the system with the
     * inverse there is, of the tangent or of it with @p border, with better and
     * better ones until it has. */
    void
    solve_by(const std::function<bool()> &iterate, const Border *border);

    /** @return whether it can be done for what the tangent, and @p border if it
     * is one, are now. */
    bool
    factor(const Border *border);

    /** Solve @p system by FGMRES, preconditioned by @p inverse.
     * @return whether it converged. */
    template <typename System, typename Inverse, typename VectorType>
    bool
    iterate(const System     &system,
            const Inverse    &inverse,
            VectorType       &x,
            const VectorType &b,
            const double      tolerance);

    /** Let the next kind follow. Throws ExcNotConverged where there is none. */
    void
    give_up_kind();

    unsigned int                    most_iterations = 60;
    double                          least_accuracy  = 1.;
    bool                            keep            = true;
    const Tangent                  *tangent         = nullptr;
    dealii::types::global_dof_index n_unknowns      = 0;
    unsigned int                    kind            = 0;
    InverseKind                     current;
    /** Whether there is an inverse. */
    bool factored = false;
    /** The size of the border it is of, too. */
    unsigned int n_factored_globals = 0;
    FactorAge    age;
    /** The inverse with a border around it, where it is not of one. */
    std::unique_ptr<BorderedInverse> bordered;
  };
} // namespace lumbricus

#endif
