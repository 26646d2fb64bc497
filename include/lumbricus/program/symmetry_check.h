// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_symmetry_check_h
#define lumbricus_program_symmetry_check_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/terms/body_forces.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <vector>

namespace lumbricus
{
  /**
   * Whether planes of mirror symmetry may stand for the other half of the body.
   * With the mirror R = I - 2 e x e, at a plane with normal e:
   *
   *   R G R = G,   so that e . ln G t = 0 for every t in the plane,
   *   R f x R f = f x f   for the elastic fibres f, or as stiff ones,
   *   T . e = 0    where a surface with the traction T ends at the plane,
   *   u . e = 0    where a prescribed displacement does.
   *
   * Symmetry is asked for on the plane only: what depends on the distance from
   * the plane is taken for the computed half, whose mirror image the other one
   * is.
   */
  class SymmetryCheck : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /**
     * Look at every plane of symmetry, at @p times. Throws ExcInput, which
     * names the fibres or the load, the plane, the place and how much it is.
     * Collective.
     */
    void
    check(const MixedSpace          &space,
          const Anatomy             &anatomy,
          const BoundaryConditions  &conditions,
          const BodyForces          &forces,
          const std::vector<double> &times) const;

  private:
    bool required = true;
  };
} // namespace lumbricus

#endif
