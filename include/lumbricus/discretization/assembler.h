// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_assembler_h
#define lumbricus_discretization_assembler_h

#include <lumbricus/constraints/supports.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/liquid_weight.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/rounding_level.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/discretization/surface_terms.h>
#include <lumbricus/discretization/tangent.h>
#include <lumbricus/discretization/volume_terms.h>

#include <memory>

namespace lumbricus
{
  /**
   * The weak form of equilibrium and of the volume constraint,
   *
   *   r_u = int P : Grad du dV - int b . du dV - int T . du dA,
   *   r_p = int c dp dV,
   *
   * and its exact linearisation. It sees F, p, material points and a tissue;
   * whether a cell is muscle or liquid it never asks.
   */
  class Assembler
  {
  public:
    /** What there is to say about a residual besides the vector. */
    struct Report
    {
      /** Root of the sum of squares of the nodal forces of all cells: the
       * level of the internal forces before they balance [N]. */
      double force_level = 0.;
      /** What rounding makes of the norm of r_u [N] and of the l1 norm of r_p
       * [mm^3] of an exact solution: RoundingLevel. */
      double force_rounding = 0.;
      /** See force_rounding. */
      double volume_rounding = 0.;
      /** The smallest det F at any quadrature point, and where it is. Where
       * it is not positive the vector is not to be used. */
      double min_J = 1.;
      /** The segment of min_J, from zero. */
      unsigned int min_J_segment = 0;
      /** How many points of the boundary stick, see SurfaceResponse::sticks. */
      double n_sticking = 0.;

      /** Whether no cell is folded: det F > 0 at all quadrature points. */
      bool
      valid() const
      {
        return min_J > 0.;
      }
    };

    /** All of these are kept by reference, and have to be up to date when they
     * are used: @p references at the time, @p terms at the last state,
     * @p supports at the solution. */
    Assembler(const Body           &body,
              SurfaceTerms         &terms,
              const VolumeTerms    &volume_terms,
              LiquidWeight         &liquid_weight,
              const ReferenceField &references,
              const Supports       &supports);

    /** Set up vectors and the tangent, after every change of the mesh or the
     * constraints. Collective. */
    void
    reinit();

    /**
     * The constraints are others, of the same unknowns as far as is known.
     * @return whether they are: if not, reinit() has to follow. Collective.
     */
    bool
    update_constraints();

    /** Compute the residual r at @p solution and time @p t; r may be any vector
     * before. Collective. */
    Report
    residual(const Vector &solution, const LoadTime &t, Vector &r);

    /**
     * Compute the tangent and the right-hand side -r, with the
     * inhomogeneities of the supports brought to it. The tangent is exact but
     * where no point stuck at the last residual: then it is stabilised, see
     * SurfaceResponse::stabilisation. Collective.
     */
    Report
    linearise(const Vector &solution, const LoadTime &t);

    /** The tangent that linearise() computed. */
    const Tangent &
    tangent() const;

    /** For what borders equilibrium, to add to it. */
    Tangent &
    tangent();

    /** That of linearise(): -r, and what the inhomogeneities of the constraints
     * add to it [N and mm^3]. */
    const Vector &
    right_hand_side() const;

  private:
    /** Compute the residual @p sum and, if asked for, the tangent. */
    Report
    assemble(const Vector   &solution,
             const LoadTime &t,
             const bool      with_tangent,
             Vector         &sum);

    /**
     * Subtract the boundary tractions of @p cell, at the displacements that the
     * kernel has, from its residual and add to its tangent.
     */
    void
    add_surface_terms(const OwnedCell &cell,
                      const LoadTime  &t,
                      const bool       with_tangent,
                      double          *residual);

    /** The same with the body forces in the cell. */
    void
    add_volume_terms(const OwnedCell &cell,
                     const LoadTime  &t,
                     const bool       with_tangent,
                     double          *residual);

    /** The same with the weight of liquids at the cell. */
    void
    add_liquid_weight(const OwnedCell &cell,
                      const bool       with_tangent,
                      double          *residual);

    /**
     * Where the liquid of @p cell slips, the wall holds it by a normal traction
     * that turns with the surface: add
     *
     *   -int p N_b . d(cof(F) N) dA
     *
     * to the tangent, symmetrised, with the p that the kernel has. The sum over
     * the surface of a hydrostatic liquid is the exact derivative.
     */
    void
    add_interface_tangent(const OwnedCell &cell);

    const Body            body;
    SurfaceTerms         &terms;
    const VolumeTerms    &volume_terms;
    LiquidWeight         &liquid_weight;
    const ReferenceField &references;
    const Supports       &supports;

    CellUnknowns unknowns;
    Tangent      linearisation;
    Vector       u; // the solution with ghost entries
    Vector       rhs;
    /** Points that stick: of the cells so far, and of the body at the last
     * residual. */
    double n_sticking = 0., n_stuck = 0.;

    RoundingLevel rounding;

    std::unique_ptr<ElementKernel> kernel;
    SurfaceKernel                  surface;
  };
} // namespace lumbricus

#endif
