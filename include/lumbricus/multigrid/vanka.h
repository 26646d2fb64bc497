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
   * One cell after the other sees what those before it did (multiplicative),
   * except for those of other ranks, whose part is seen by the next sweep. Or
   * no cell sees that (additive); an unknown then gets the mean of what its
   * cells give.
   */
  class Vanka
  {
  public:
    struct Options
    {
      bool   multiplicative = true;
      double damping        = 1.;
    };

    /** For the pattern of @p matrix, with patches of these of its cells. */
    void
    reinit(const LevelMatrix                            &matrix,
           const std::vector<std::vector<unsigned int>> &cells_of_patches,
           const Options                                &options);

    /** Invert the A_kk of what the matrix is now. */
    void
    invert();

    /**
     * One sweep on A x = b, over the cells from the first to the last or, for
     * the transposed of that, from the last to the first. Collective.
     * @param b owned entries
     */
    void
    sweep(CellVector   &x,
          const double *b,
          const bool    backward,
          const bool    x_is_zero) const;

    std::size_t
    memory() const;

  private:
    struct Patch
    {
      std::vector<unsigned int> places;
      std::vector<float>        inverse; // by rows
    };

    void
    add_correction(const Patch  &patch,
                   const double *r,
                   double       *x) const;

    const LevelMatrix         *matrix = nullptr;
    Options                    options;
    std::vector<Patch>         patches;
    std::vector<double>        weight; // of each unknown, additive only
    mutable std::vector<double> residual;
  };
} // namespace lumbricus

#endif
