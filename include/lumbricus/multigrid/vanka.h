// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_vanka_h
#define lumbricus_multigrid_vanka_h

#include <lumbricus/multigrid/level_matrix.h>

#include <vector>

namespace lumbricus
{
  /**
   * A smoother for saddle points: cell by cell, solve for the displacements and
   * pressures of the cell as if all others were known,
   *
   *   x_k += omega A_kk^(-1) (b - A x)_k.
   *
   * One cell after the other sees what those before it did (multiplicative).
   * What the cells of other ranks do is seen by the next sweep, and an unknown
   * that ranks share gets the mean of what they give. Or no cell sees what
   * others do (additive), and an unknown gets the mean of what cells give.
   */
  class Vanka
  {
  public:
    /** How a sweep is done. */
    struct Options
    {
      bool   multiplicative = true; ///< else additive
      double damping        = 1.;   ///< omega
    };

    /** For the pattern of @p matrix, with patches of these of its cells. */
    void
    reinit(const LevelMatrix                            &matrix,
           const std::vector<std::vector<unsigned int>> &cells_of_patches,
           const Options                                &options);

    /** Invert the A_kk of what the matrix is now. Throws ExcNotConverged where
     * one is singular. Collective. */
    void
    invert();

    /**
     * One sweep on A x = b, over the cells from the first to the last or, for
     * the transposed of that, from the last to the first. Collective.
     * @p b has its ghost values, @p x has none before and after.
     */
    void
    sweep(Vector       &x,
          const Vector &b,
          const bool    backward,
          const bool    x_is_zero) const;

  private:
    struct Patch
    {
      std::vector<unsigned int> places;
      std::vector<float>        inverse; // by rows
    };

    void
    add_correction(const Patch &patch, const double *r, double *x) const;

    const LevelMatrix *matrix = nullptr;
    Options            options;
    std::vector<Patch> patches;
    /** Of the unknowns of patches, owned or not: place, 1 / number of ranks
     * that have it, and 1 / number of patches here that have it. */
    std::vector<unsigned int>   touched;
    std::vector<double>         rank_weight;
    std::vector<double>         patch_weight; // by place
    mutable std::vector<double> before;
    mutable Vector              frozen;
  };
} // namespace lumbricus

#endif
