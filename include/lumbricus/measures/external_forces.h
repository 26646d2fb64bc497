// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_external_forces_h
#define lumbricus_measures_external_forces_h

#include <lumbricus/constraints/supports.h>
#include <lumbricus/discretization/liquid_weight.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/surface_terms.h>
#include <lumbricus/discretization/volume_terms.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What one load or support does to the part of the body that is computed:
   *
   *   f = int T dA + int b dV + sum_i r_i,
   *   m = int x X T dA + int x X b dV + sum_i x_i X r_i,
   *
   * with the tractions T, the body forces b, and the nodal forces r_i that the residual lacks of
   * balance at the displacements that are held; x = X + u, and moments are
   * about the origin. In equilibrium those of all loads and supports add up to
   * zero, to what the residual still is.
   */
  struct ExternalForce
  {
    /** What acts. */
    enum class Kind
    {
      condition,      ///< a section of Boundary conditions
      body_force,     ///< a section of Body forces
      cavities,       ///< the pressures of chambers without cells
      symmetry,       ///< the other half, at a plane of mirror symmetry
      minimal_support ///< one displacement that it holds
    };

    Kind                   kind;           ///< what acts
    std::string            name;           ///< of the section or the plane
    dealii::Tensor<1, dim> force;          ///< f on the body [N]
    dealii::Tensor<1, dim> moment;         ///< m on the body [N mm]
    double                 magnitude = 0.; ///< int |T| dA + sum_i |r_i| [N]
    /** int T . w dA + int b . w dV + sum_i r_i . w_i, where a displacement w is
     * given [N mm]. */
    double work = 0.;
    /** The node that the minimal support holds, at rest [mm]. */
    dealii::Point<dim> X;
    /** The direction in which it does. */
    unsigned int direction = 0;

    /** What tables call its kind. */
    std::string
    kind_name() const;

    /** Add a force @p f at @p x, which moves by @p w. */
    void
    add(const dealii::Point<dim>     &x,
        const dealii::Tensor<1, dim> &f,
        const dealii::Tensor<1, dim> &w);

    /** Add all of another one, whatever that is. */
    ExternalForce &
    operator+=(const ExternalForce &other);
  };

  /**
   * The forces of all loads and supports at @p solution and time @p t: those
   * with a name in the order of the names, the planes of symmetry, what the
   * minimal support holds, the body forces, and the cavities under the pressures
   * in @p globals. @p references and @p terms have to be up to date. Their work
   * is that along the displacement @p way, if there is one. Collective.
   */
  std::vector<ExternalForce>
  external_forces(const Body               &body,
                  const BoundaryConditions &conditions,
                  SurfaceTerms             &terms,
                  const BodyForces         &body_forces,
                  const VolumeTerms        &volume_terms,
                  LiquidWeight             &liquid_weight,
                  const ReferenceField     &references,
                  const Supports           &supports,
                  const Vector             &solution,
                  const Globals            &globals,
                  const double              t,
                  const Vector             *way = nullptr);
} // namespace lumbricus

#endif
