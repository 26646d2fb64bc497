// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_v_cycle_h
#define lumbricus_multigrid_v_cycle_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/mumps.h>
#include <lumbricus/multigrid/embedding.h>
#include <lumbricus/multigrid/hierarchy.h>
#include <lumbricus/multigrid/vanka.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** How a V-cycle is done. */
  struct VCycleParameters : public ParameterOwner
  {
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** A mesh with at most so many unknowns is factored. */
    unsigned int n_coarsest = 10000;
    /** Sweeps over the cells before and after the coarse correction. */
    unsigned int n_sweeps = 1;
    /** Coarse corrections in a cycle: 1 is a V-cycle, 2 a W-cycle. */
    unsigned int n_coarse_cycles = 1;
    /** omega of Vanka: which part of a correction is taken. */
    double damping = 0.7;
    /** See Hierarchy::reinit(). */
    double thin = 3.;
    /** "multiplicative" or "additive", see Vanka. */
    std::string vanka = "multiplicative";
  };



  /**
   * An approximate inverse of the tangent, for Krylov methods: one cycle of
   * geometric multigrid for displacement and pressure together,
   *
   *   x += S (b - A_l x),   x += P A_(l-1)^(-1) P^T (b - A_l x),
   *   x += S^T (b - A_l x),
   *
   * with sweeps S over the cells (Vanka) and MUMPS on the coarsest mesh. The
   * coarse matrices are computed cell by cell from those of the finest mesh,
   * A_(l-1) = sum P_c^T A_c P_c (Embedding), so that they carry whatever state
   * and material there is.
   */
  class VCycle : public ApproximateInverse
  {
  public:
    /** What to call it when speaking to the user. */
    static constexpr const char *name = "multigrid";

    /** For the mesh of @p tangent. Collective. */
    VCycle(const Tangent &tangent, const VCycleParameters &parameters);

    /** Compute all matrices. */
    void
    factor() override;

    void
    vmult(Vector &y, const Vector &x) const override;

    double
    cost() const override;

    /** The meshes and their unknowns. */
    const Hierarchy &
    meshes() const
    {
      return hierarchy;
    }

    /** x_(l+1) += P x_l, with x_l in @p coarse. Collective. */
    void
    prolongate_and_add(const unsigned int l,
                       const Vector      &coarse,
                       Vector            &fine) const;

    /** x_l = P^T x_(l+1), with x_l in @p coarse. Collective. */
    void
    restrict_to(const unsigned int l, const Vector &fine, Vector &coarse) const;

    /** The matrix of cell @p i on a level below the finest, by rows, without
     * constraints. */
    const std::vector<double> &
    cell_matrix(const unsigned int l, const unsigned int i) const
    {
      return coarse_matrices[l][i];
    }

  private:
    /** What is needed on a level above the coarsest. */
    struct Smoothed
    {
      LevelMatrix        matrix;
      Vanka              smoother;
      mutable Vector     x, b, defect, work;
      /** Of the correction by the next coarser level. */
      mutable Vector coarse_x, coarse_b;
      /** 1 / number of cells of each owned unknown; 0 where constrained. */
      Vector weight;
    };

    void
    cycle(const unsigned int l, Vector &x, const Vector &b) const;

    void
    solve_coarsest(Vector &x, const Vector &b) const;

    void
    gather_split(const unsigned int l);

    const Tangent          &tangent;
    const VCycleParameters &parameters;
    const MPI_Comm          comm;

    const Embedding                        embedding;
    Hierarchy                              hierarchy;
    std::vector<std::unique_ptr<Smoothed>> smoothed; // [0] is empty
    /** Of each level but the finest and cell of it. */
    std::vector<std::vector<std::vector<double>>> coarse_matrices;

    FreeNumbering                          numbering;
    mutable std::unique_ptr<Mumps<double>> mumps;
    mutable std::vector<double>            values;
  };
} // namespace lumbricus

#endif
