// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_supports_h
#define lumbricus_constraints_supports_h

#include <lumbricus/constraints/minimal_support.h>
#include <lumbricus/constraints/rigid_motions.h>
#include <lumbricus/constraints/slip_interface.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * The constraints on the unknowns: hanging nodes, planes of symmetry,
   * prescribed displacements, the minimal support, and the interface at which
   * liquid slips. They are constraints on Newton's increments, whose
   * inhomogeneity is what is still missing to the prescribed displacement.
   */
  class Supports
  {
  public:
    /** What holds an unknown. */
    enum class By
    {
      condition,      ///< a prescribed displacement
      symmetry,       ///< a plane of mirror symmetry
      minimal_support ///< nothing but the minimal support
    };

    /** An unknown that is prescribed; without a condition it is held at 0. */
    struct Prescribed
    {
      dealii::types::global_dof_index index;     ///< the unknown
      unsigned int                    component; ///< of the displacement
      unsigned int                    body;      ///< see body_of()
      dealii::Point<dim>              X;         ///< its node [mm]
      const PrescribedDisplacement   *condition; ///< or nullptr
      By                              by;        ///< what holds it
      /** Which boundary condition, which plane of the geometry, or which of
       * minimal_support(). */
      unsigned int number;
      /** The displacement of its node. */
      std::array<dealii::types::global_dof_index, dim> node;
    };

    /** All arguments are kept by reference; there are no constraints before
     * reinit(). */
    Supports(const MixedSpace         &space,
             const Anatomy            &anatomy,
             const InterfaceCoupling  &coupling,
             const BoundaryConditions &conditions);

    /**
     * Make the constraints, after every change of the mesh. Throws ExcInput
     * where the body can still move rigidly, naming the motions. Collective.
     */
    void
    reinit();

    /** Whether liquid slips along normals that follow the deformation, so that
     * the constraints are others at every state. */
    bool
    follow_the_deformation() const;

    /**
     * Where normals follow the deformation, let the normals of the interface be
     * those at @p solution and the slip be that since @p start. Collective.
     */
    void
    update_interface(const Vector &solution, const Vector &start);

    /** What the liquid is off the wall by, along the normals, as compared with
     * the start of the solve: the largest on any rank [mm]. */
    double
    gap() const;

    /** See SlipInterface::is_liquid_side(); false where normals do not follow
     * the deformation. */
    bool
    is_sliding_face(
      const dealii::DoFHandler<dim>::active_cell_iterator &cell,
      const unsigned int                                   f) const;

    /**
     * Set the inhomogeneities to what @p solution lacks of the displacements
     * prescribed at time @p t.
     * @return the largest of them on any rank. Collective.
     */
    double
    set_increments(const Vector &solution, const LoadTime &t);

    /** Set all inhomogeneities to zero. */
    void
    set_increments_to_zero();

    /** The unknowns that are prescribed, of owned and ghost cells. */
    const std::vector<Prescribed> &
    prescribed_unknowns() const;

    /** What the minimal support holds, equal on all ranks. */
    const std::vector<MinimalSupport::HeldPoint> &
    minimal_support() const;

    /** The constraints that do not hold anything but pass forces on: hanging
     * nodes and the interface, closed. Collective. */
    dealii::AffineConstraints<double>
    links() const;

    /** What holds the wall, and all that does not slip, besides the minimal
     * support. */
    const RigidMotions &
    held_without_minimal_support() const;

    /** All constraints on the unknowns of the space, closed, with the
     * inhomogeneities set last. */
    const dealii::AffineConstraints<double> &
    constraints() const;

  private:
    /** The body a cell is part of that can move by itself: 0, or segment + 1
     * for liquid that slips. */
    unsigned int
    body_of(const dealii::types::material_id id) const;

    void
    prescribe_boundaries();

    /** What holds each body so far. */
    std::vector<RigidMotions>
    held_motions() const;

    /** Where the minimal support may hold the liquid of a segment. */
    dealii::Point<dim>
    vertex_in_liquid(const unsigned int segment) const;

    /** Hold the displacements of some vertices of a body. */
    void
    hold(const std::vector<MinimalSupport::HeldPoint> &points,
         const unsigned int                            body);

    /** Hold the displacement of the vertex at @p X of a body at zero. */
    void
    hold_vertex(const dealii::Point<dim> &X,
                const unsigned int        direction,
                const unsigned int        body);

    /** Make the constraints, of the base and the interface. */
    void
    close();

    /** Close constraints that have all their lines. */
    void
    close(dealii::AffineConstraints<double> &constraints) const;

    /** The unknowns whose constraints this rank has to know. */
    dealii::IndexSet
    known_unknowns() const;

    const MixedSpace         &space;
    const Anatomy            &anatomy;
    const Geometry           &geometry;
    const BoundaryConditions &conditions;
    SlipInterface             interface;
    const MinimalSupport      least;

    /** All but the interface, open. */
    dealii::AffineConstraints<double> base;
    dealii::AffineConstraints<double> increments;
    std::vector<Prescribed>           prescribed;
    std::unique_ptr<RigidMotions>     held;
    double                            largest_gap = 0.;

    std::vector<MinimalSupport::HeldPoint> held_points;
  };
} // namespace lumbricus

#endif
