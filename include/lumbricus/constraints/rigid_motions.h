// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_rigid_motions_h
#define lumbricus_constraints_rigid_motions_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Which of the six rigid motions u = v + w x (X - X0) / L the supports hold.
   * Holding the displacement along d at X is the row (d, (X - X0) x d / L);
   * the rows' span is kept as an orthonormal basis.
   */
  class RigidMotions
  {
  public:
    /** A force and its moment, (f, (X - X0) x f / L) [N]: what it does to the
     * six motions. */
    using Row = std::array<double, 2 * dim>;

    /** None is held yet. @p L is a length typical of the body [mm], which makes
     * turns comparable to shifts. */
    RigidMotions(const dealii::Point<dim> &X0, const double L);

    /** Add a support. @return whether it holds a motion not held before. */
    bool
    hold(const dealii::Point<dim> &X, const dealii::Tensor<1, dim> &d);

    /** Make the supports of all ranks known to all. Collective. */
    void
    merge(const MPI_Comm comm);

    /** Whether no motion is left. */
    bool
    all_held() const;

    /** The free motions in words: "translation along x, rotation about y". */
    std::string
    free_motions() const;

    /** The row of a force @p f at @p X. */
    Row
    row(const dealii::Point<dim> &X, const dealii::Tensor<1, dim> &f) const;

    /** What of @p row does work on motions that nothing holds. */
    Row
    unheld(const Row &row) const;

    /** Where moments are taken about. */
    const dealii::Point<dim> X0;
    /** A length typical of the body [mm]. */
    const double L;

  private:
    bool
    add(const Row &row);

    std::vector<Row> basis;
  };
} // namespace lumbricus

#endif
