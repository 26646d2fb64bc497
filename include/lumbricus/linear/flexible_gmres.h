// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_flexible_gmres_h
#define lumbricus_linear_flexible_gmres_h

#include <functional>

namespace lumbricus
{
  /**
   * FGMRES without restarts, with few reductions (Saad 1993; Giraud et al. 2005):
   * the Krylov basis V and the preconditioned vectors Z of
   *
   *   A Z = V H,  x = Z y,  |b - A x| = min
   *
   * are made orthogonal by classical Gram and Schmidt, w - V (V^T w), whose
   * products and the norm, by Pythagoras, are one reduction. What that loses is
   * foreseen from the norms, and where more than a small part would be lost it is
   * done a second time with one reduction more. The basis needs only be
   * orthogonal to a few digits: the residual is then known to as many.
   *
   * No vector is made that the solution does not use: as many applications of A
   * and of the preconditioner as iterations.
   */
  template <typename VectorType>
  class FlexibleGmres
  {
  public:
    /** (y, x): y = an operator times x. */
    using Operator = std::function<void(VectorType &, const VectorType &)>;

    /** With at most so many iterations, each of which keeps two vectors. */
    explicit FlexibleGmres(const unsigned int most_iterations)
      : most_iterations(most_iterations)
    {}

    /** Solve A x = b from x = 0, until |b - A x| <= @p tolerance |b|. What is in
     * @p x matters not. Collective.
     * @return whether that is reached. */
    bool
    solve(const Operator   &A,
          const Operator   &preconditioner,
          VectorType       &x,
          const VectorType &b,
          const double      tolerance);

    /** What the last solve() took. */
    unsigned int
    n_iterations() const
    {
      return n;
    }

    /** How often it went twice through Gram and Schmidt. */
    unsigned int
    n_repeated() const
    {
      return n_twice;
    }

  private:
    const unsigned int most_iterations;
    unsigned int       n       = 0;
    unsigned int       n_twice = 0;
  };
} // namespace lumbricus

#endif
