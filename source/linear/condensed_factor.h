// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_condensed_factor_h
#define lumbricus_linear_condensed_factor_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/mumps.h>

#include <array>

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
   * a material with 1/kappa + 1/(penalty mu) in place of 1/kappa. S has three
   * unknowns per node and no zeros on its diagonal.
   */
  class CondensedFactor : public ApproximateInverse
  {
  public:
    /** With more the volume is kept better, but in single precision the
     * rounding errors of the volume's stiffness drown that of the shape. */
    static constexpr double penalty = 1e3;

    /** How S is factored. */
    struct Accuracy
    {
      /** What to call it when speaking to the user. */
      const char *name;
      /** Whether rows are exchanged. */
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

    /** For the pattern of @p tangent, which MUMPS analyses. Collective. */
    CondensedFactor(const Tangent  &tangent,
                    const Accuracy &accuracy,
                    const MPI_Comm  comm);

    void
    factor() override;

    void
    vmult(Vector &y, const Vector &x) const override;

    double
    cost() const override;

    /** Operations that MUMPS will need, on all ranks. */
    double
    planned_flops() const
    {
      return mumps.planned_flops();
    }

    /** Memory that MUMPS will need, of the rank that needs most [MB]. */
    double
    planned_megabytes() const
    {
      return mumps.planned_megabytes();
    }

  private:
    static constexpr unsigned int n_private = CellUnknowns::n_private;

    const Tangent       &tangent;
    FreeNumbering        numbering;
    mutable Mumps<float> mumps;
    /** K_zz^(-1) and K_zz^(-1) K_zs of each owned cell, by rows. */
    std::vector<std::array<double, n_private * n_private>> inverses;
    std::vector<std::vector<float>>                        couplings;
    mutable std::vector<float>                             values;
    mutable Vector                                         reduced;
  };
} // namespace lumbricus

#endif
