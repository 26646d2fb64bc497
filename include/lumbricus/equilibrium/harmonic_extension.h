// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_harmonic_extension_h
#define lumbricus_equilibrium_harmonic_extension_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>

#include <vector>

namespace lumbricus
{
  /**
   * What the displacement of the liquid of some segments lacks to be the
   * harmonic extension of what it is on the liquid's surface,
   *
   *   Laplace(u) = 0 in the reference configuration,
   *
   * component by component. The surface is where the liquid touches the wall
   * or the outside; in planes of symmetry nodes slide. A homogeneous
   * deformation of the surface extends to the inside as that deformation.
   *
   * @return corrections of the free unknowns in @p unknowns, zero but inside
   * the liquid of the segments. Collective.
   */
  Vector
  harmonic_correction(const Body              &body,
                      const CellUnknowns      &unknowns,
                      const Vector            &relevant_solution,
                      const std::vector<bool> &in_segment);
} // namespace lumbricus

#endif
