// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_approximate_inverse_h
#define lumbricus_linear_approximate_inverse_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <memory>
#include <string>

namespace lumbricus
{
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
