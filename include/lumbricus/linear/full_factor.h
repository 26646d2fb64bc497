// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_full_factor_h
#define lumbricus_linear_full_factor_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/mumps.h>

namespace lumbricus
{
  /**
   * The inverse of the tangent up to rounding: a factorisation of all free
   * unknowns in double precision, with pivoting.
   */
  class FullFactor : public ApproximateInverse
  {
  public:
    /** What to call it when speaking to the user. */
    static constexpr const char *name = "factors in double precision";

    /** For the pattern of @p tangent, which MUMPS analyses. Collective. */
    FullFactor(const Tangent &tangent, const MPI_Comm comm);

    void
    factor() override;

    void
    vmult(Vector &y, const Vector &x) const override;

    double
    cost() const override;

  private:
    const Tangent              &tangent;
    FreeNumbering               numbering;
    mutable Mumps<double>       mumps;
    mutable std::vector<double> values;
  };
} // namespace lumbricus

#endif
