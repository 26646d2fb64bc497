// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_approximate_inverse_h
#define lumbricus_linear_approximate_inverse_h

#include <lumbricus/discretization/border.h>
#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/la_parallel_block_vector.h>

#include <memory>
#include <string>

namespace lumbricus
{
  /** The free unknowns, and the global ones, which the first rank owns. */
  using BorderedVector = dealii::LinearAlgebra::distributed::BlockVector<double>;



  /**
   * An approximate inverse of the tangent as a preconditioner of Krylov
   * methods. It is made for a pattern, which is expensive, and then computed
   * from what the tangent is as often as needed. All functions are collective.
   */
  class ApproximateInverse
  {
  public:
    virtual ~ApproximateInverse() = default;

    /**
     * Compute it from what the tangent is now. Throws ExcNotConverged where
     * that is singular, ExcSolveFailed when memory ends.
     */
    virtual void
    factor() = 0;

    /** y = an approximation of K^(-1) x. */
    virtual void
    vmult(Vector &y, const Vector &x) const = 0;

    /**
     * As factor(), but of the tangent with @p border around it, where this kind
     * can do that with a border like this one; else nothing is done. From then
     * on vmult_bordered() is to be used.
     * @return whether it is done.
     */
    virtual bool
    factor_bordered(const Border & /*border*/)
    {
      return false;
    }

    /** After factor_bordered(): y = an approximation of [K B; C D]^(-1) x. */
    virtual void
    vmult_bordered(BorderedVector & /*y*/, const BorderedVector & /*x*/) const
    {
      Assert(false, dealii::ExcPureFunctionCalled());
    }

    /** What factor() costs, in applications of vmult(): from counts of
     * operations, so that it is the same in every run. */
    virtual double
    cost() const = 0;
  };



  /** A kind of inverse, and what to call it when speaking to the user. */
  struct InverseKind
  {
    /** As the user is to read it. */
    std::string name;
    /** Empty where there is no such kind. */
    std::unique_ptr<ApproximateInverse> inverse;
  };
} // namespace lumbricus

#endif
