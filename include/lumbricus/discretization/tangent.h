// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_tangent_h
#define lumbricus_discretization_tangent_h

#include <lumbricus/discretization/cell_linearisation.h>
#include <lumbricus/discretization/surface_matrix.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The linearisation of equilibrium at a state, as linear solvers see it: an
   * operator K on vectors, and its matrix cell by cell for those who want to
   * factor it. In the free unknowns it is C^T K C (CellUnknowns); the rows of
   * constrained unknowns are those of the identity.
   */
  class Tangent
  {
  public:
    /** Rows and columns of a cell's matrix. */
    static constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;

    /**
     * All of these are kept by reference; there are no cells before reinit().
     */
    Tangent(const MixedSpace   &space,
            const ShapeCache   &shapes,
            const CellUnknowns &unknowns);

    /** After every change of the mesh. */
    void
    reinit();

    /** y = K x. Collective. */
    void
    vmult(Vector &y, const Vector &x) const;

    /** y_cell = K_cell x_cell for owned cell @p i, without constraints. */
    void
    vmult_cell(const unsigned int i, const double *x, double *y) const;

    /** Set @p K to the matrix of owned cell @p i, by rows, without constraints:
     * what preconditioners are made of, which is stiffer than the operator where
     * liquid flows. */
    void
    cell_matrix(const unsigned int i, std::vector<double> &K) const;

    /** The same of the operator itself, for those who factor it in double
     * precision. */
    void
    exact_cell_matrix(const unsigned int i, std::vector<double> &K) const;

    /** The diagonal of cell_matrix(). */
    std::array<double, n_per_cell>
    diagonal(const unsigned int i) const;

    /** M_nm = int psi_n psi_m dV of owned cell @p i, by rows. */
    std::array<double,
               MixedSpace::n_pressure_modes * MixedSpace::n_pressure_modes>
    pressure_mass(const unsigned int i) const;

    /** For the assembler: the linearisation of owned cell @p i. */
    CellLinearisation &
    cell(const unsigned int i);

    /** For the assembler: that cell @p i has no boundary tractions. */
    void
    clear_surface_matrices();

    /** For the assembler: what the tractions on the boundary of cell @p i add
     * to its matrix, by rows, zero at first; valid until the next call of any
     * other function. */
    std::vector<double> &
    surface_matrix(const unsigned int i);

    /** The shear modulus at zero strain of each owned cell [N/mm^2]. */
    std::vector<double> shear_modulus;

    /** Whether K is symmetric under the loads there are. */
    bool symmetric = true;

    /** What its unknowns are, for solvers. */
    const MixedSpace &space;
    /** The shape functions on its cells. */
    const ShapeCache &shapes;
    /** Its unknowns on cells, with constraints. */
    const CellUnknowns &unknowns;

  private:
    void
    cell_matrix(const unsigned int   i,
                const bool           for_preconditioner,
                std::vector<double> &K) const;

    dealii::AlignedVector<CellLinearisation> cells;
    std::vector<int>                         of_surface_cell; // -1: none
    std::vector<SurfaceMatrix>               surface_matrices;
  };
} // namespace lumbricus

#endif
