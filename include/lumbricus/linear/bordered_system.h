// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_bordered_system_h
#define lumbricus_linear_bordered_system_h

#include <lumbricus/discretization/border.h>
#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace lumbricus
{
  /** Make a vector of the free unknowns like @p b with the global ones @p c. */
  BorderedVector
  bordered_vector(const Vector &b, const std::vector<double> &c);

  /** The global unknowns of @p x, for all ranks. Collective. */
  std::vector<double>
  globals_of(const BorderedVector &x);



  /** The tangent with its border, y = [K B; C D] x. */
  class BorderedTangent
  {
  public:
    /** Both are kept by reference. */
    BorderedTangent(const Tangent &tangent, const Border &border);

    /** Collective. */
    void
    vmult(BorderedVector &y, const BorderedVector &x) const;

    /** Whether the residual of @p x is about @p tolerance times @p b or a term of
     * B g, or less. Where the tangent alone is singular rounding may let a method
     * end with another one. Collective. */
    bool
    is_solved(const BorderedVector &x,
              const BorderedVector &b,
              const double          tolerance) const;

  private:
    const Tangent &tangent;
    const Border  &border;
  };



  /**
   * An approximate inverse M of the tangent with a border around it, for as long
   * as M is used, whatever becomes of the border:
   *
   *   Z = M B,  S = D - C Z,
   *   y = M r,  g = S^(-1) (s - C y),  x = y - Z g,
   *
   * with the small S dense and the same on all ranks. Each global unknown costs
   * one application of M, once, and one vector; where
   * ApproximateInverse::factor_bordered() does as well, it costs neither. M need
   * not be good where K is nearly singular, as close to a limit point, while the
   * whole is not.
   */
  class BorderedInverse
  {
  public:
    /** @p inverse is kept by reference; @p like is any vector of the free
     * unknowns. Throws ExcNotConverged where S is singular. Collective. */
    BorderedInverse(const ApproximateInverse &inverse,
                    const Border             &border,
                    const Vector             &like);

    /** x = the approximate solution for @p r. Collective. */
    void
    vmult(BorderedVector &x, const BorderedVector &r) const;

    /** The number of global unknowns. */
    unsigned int
    size() const
    {
      return Z.size();
    }

  private:
    /** S^(-1) c. */
    std::vector<double>
    solve_globals(const std::vector<double> &c) const;

    const ApproximateInverse        &inverse;
    std::vector<Vector>              Z;
    std::vector<BorderVector>        rows;
    std::vector<double>              row_scale;
    dealii::LAPACKFullMatrix<double> S;
  };
} // namespace lumbricus

#endif
