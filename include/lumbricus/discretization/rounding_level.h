// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_rounding_level_h
#define lumbricus_discretization_rounding_level_h

#include <lumbricus/discretization/element_kernel.h>

#include <vector>

namespace lumbricus
{
  /**
   * How large a residual the rounding of numbers makes of an exact solution.
   * A nodal displacement is known to eps |u|, so Grad u to
   *
   *   e_F = eps |Grad N| |u|,   |Grad N|^2 = sum_nJ (dN_n/dX_J)^2,
   *
   * with |u|^2 the mean square over the nodes of the cell; the material's
   * response adds its own rounding, a few eps. With the stiffness S = mu
   * |G^(-1)|^2 + |p| |F| of the stress and |F|^2 that of det F, the nodal
   * forces of a cell and its violated volume are known to
   *
   *   e_f = S (n eps |F| + e_F) ( sum_q w_q^2 |Grad N|^2 )^(1/2),
   *
   *   e_V = |F|^2 (n eps |F| + e_F) ( sum_q w_q^2 )^(1/2).
   *
   * Errors of cells are independent, so that the squares of e_f add up (Higham,
   * Accuracy and stability of numerical algorithms, SIAM 2002, section 2.8);
   * the volumes are those of an l1 norm, of which the e_V add up.
   */
  class RoundingLevel
  {
  public:
    /** For the owned cells of @p shapes. */
    void
    reinit(const ShapeCache &shapes);

    /** Begin a sum over cells. */
    void
    clear();

    /** Add what cell @p i contributes, whose unknowns and F @p kernel has.
     * @param pressure_modes see ElementKernel::evaluate()
     * @param mu the shear modulus of its material [N/mm^2]
     * @param points one per quadrature point. */
    void
    add(const unsigned int   i,
        const ElementKernel &kernel,
        const double        *pressure_modes,
        const double         mu,
        const MaterialPoint *points);

    /** The sum of e_f^2 over the cells of this rank [N^2]. */
    double
    force_square() const;

    /** The sum of e_V over the cells of this rank [mm^3]. */
    double
    volume() const;

  private:
    /** Norms of a cell that never changes. */
    struct CellNorms
    {
      double gradient; ///< |Grad N|, root mean square [1/mm]
      double force;    ///< of w |Grad N| [mm^2]
      double volume;   ///< of w [mm^3]
    };

    std::vector<CellNorms> norms;
    double                 sum_force_square = 0.;
    double                 sum_volume       = 0.;
  };
} // namespace lumbricus

#endif
