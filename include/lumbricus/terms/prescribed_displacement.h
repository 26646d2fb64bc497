// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_prescribed_displacement_h
#define lumbricus_terms_prescribed_displacement_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/terms/boundary_condition.h>

#include <deal.II/base/point.h>

#include <array>

namespace lumbricus
{
  /** Displacements that are known on a part of the boundary, u_i = g_i(t, X):
   * what the constraints of the body ask. */
  class PrescribedDisplacement : public virtual BoundaryCondition
  {
  public:
    /** Which components i are known. */
    virtual std::array<bool, dim>
    components() const = 0;

    /** g_i at rest position @p X and time @p t [mm]. */
    virtual double
    value(const unsigned int        component,
          const dealii::Point<dim> &X,
          const double              t) const = 0;
  };
} // namespace lumbricus

#endif
