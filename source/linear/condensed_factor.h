// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_condensed_factor_h
#define lumbricus_linear_condensed_factor_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/divided_factor.h>
#include <lumbricus/linear/mumps.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "global_rows.h"

namespace lumbricus
{
  /**
   * An approximate inverse of the tangent, for Krylov methods: a factorisation
   * in single precision of what is left when every cell's private unknowns
   * (the displacement in its middle and its pressures) are eliminated,
   *
   *   S = K_ss - K_sz K_zz^(-1) K_zs.
   *
   * So that this is possible for incompressible materials too, K_zz is that of
   * a material with 1/kappa + 1/(penalty sqrt(mu mu_max)) in place of 1/kappa,
   * with the shear modulus mu there and the largest one of the body. S has three
   * unknowns per node and no zeros on its diagonal.
   *
   * A border that hangs on what S hangs on is factored with it, as further rows
   * and columns. They are as sparse as the border, so that a chain of cavities
   * costs per cavity what one of them does.
   */
  class CondensedFactor : public ApproximateInverse
  {
  public:
    /** With more the volume is kept better, but in single precision the
     * rounding errors of the volume's stiffness drown that of the shape, which a
     * long body needs to be bent. What is soft, as a liquid, has to keep its
     * volume against what is not. */
    static constexpr double penalty = 1e2;

    /** Stiffnesses of tissues that differ by more, and L U, take pivoting from the
     * first: what rounding does to soft tissue in factors without grows with the
     * ratio, and FGMRES, which looks at residuals, does not see it. */
    static constexpr double most_contrast = 10.;

    /** How S is factored. */
    struct Accuracy
    {
      /** What to call it when speaking to the user. */
      const char *name;
      /** Whether rows are exchanged in any case. */
      bool pivoting;
      /** What of S is neglected, relative to its entries, where blocks of it
       * far from its diagonal are compressed to low rank. */
      double compression;
    };

    /** From fast to robust. The first does for most bodies; a mesh of 300,000
     * unknowns, fine enough to be badly conditioned, takes the second; without
     * pivoting S must not be singular or close to it on the way. */
    static constexpr std::array<Accuracy, 3> accuracies = {
      {{"factors", false, 1e-3},
       {"less compressed factors", false, 1e-5},
       {"factors with pivoting", true, 0.}}};

    /** For the pattern of @p tangent. Collective. */
    CondensedFactor(const Tangent  &tangent,
                    const Accuracy &accuracy,
                    const MPI_Comm  comm);

    void
    factor() override;

    bool
    factor_bordered(const Border &border) override;

    void
    vmult(Vector &y, const Vector &x) const override;

    void
    vmult_bordered(BorderedVector &y, const BorderedVector &x) const override;

    double
    cost() const override;

    /** Operations that factors will need without a border, on all ranks.
     * Collective. */
    double
    planned_flops()
    {
      plan({});
      return factors->planned_flops();
    }

    /** Memory that they will need then, of the rank that needs most [MB].
     * Collective. */
    double
    planned_megabytes()
    {
      plan({});
      return factors->planned_megabytes();
    }

  private:
    static constexpr unsigned int n_private = CellUnknowns::n_private;

    /** The least and the largest shear modulus of the body [N/mm^2]. Collective. */
    std::pair<double, double>
    shear_moduli() const;

    /** Analyse the pattern with @p more, where it has not done so. */
    void
    plan(const MoreEntries &more);

    /** Factor S with @p more. */
    void
    factor_with(const MoreEntries &more);

    /** As vmult(), with the right-hand side and then the solution @p globals of
     * the border, on the first rank, as the matrix has them. */
    void
    solve(Vector &y, const Vector &x, std::vector<float> &globals) const;

    const Tangent                 &tangent;
    const Accuracy                &accuracy;
    const MPI_Comm                 comm;
    FreeNumbering                  numbering;
    std::unique_ptr<DividedFactor> factors;
    MoreEntries                    planned;
    /** Of the border that is factored. */
    std::vector<double> row_scale;
    /** K_zz^(-1) and K_zz^(-1) K_zs of each owned cell, by rows. */
    std::vector<std::array<double, n_private * n_private>> inverses;
    std::vector<std::vector<float>>                        couplings;
    mutable Vector                                         reduced;
  };
} // namespace lumbricus

#endif
