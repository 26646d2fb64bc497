// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_slip_interface_h
#define lumbricus_discretization_slip_interface_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/interface_coupling.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The interface at which liquid slips along the wall. Both have nodes of
   * their own at the same places at rest; of each such pair the increments of
   * displacement satisfy
   *
   *   m . (du_liquid - du_wall) = 0,     m_b = int N_b cof(F) N dA,
   *
   * with the integral over the liquid's side. These are the normals for which
   * a hydrostatic liquid is in equilibrium exactly: the nodal forces of a
   * constant pressure p are p m_b. Where two or three surfaces meet (wall and
   * septum) each has its m, so that the liquid stays in the corner.
   *
   * Cells on the two sides of a face have to be of the same level.
   */
  class SlipInterface
  {
  public:
    /** Surfaces are told apart by the component of their normal at rest that
     * is largest. */
    static constexpr unsigned int n_surfaces = dim;

    /** A pair of nodes. */
    struct NodePair
    {
      /** The unknowns of the liquid, by component. */
      std::array<dealii::types::global_dof_index, dim> liquid;
      /** Those of the wall at the same place. */
      std::array<dealii::types::global_dof_index, dim> wall;
      /** Where both are at rest [mm]. */
      dealii::Point<dim> X;
      /** That of the liquid, from zero. */
      unsigned int segment;
      /** The surface each of the three is counted to here: where two meet at
       * a blunt angle they are one. */
      std::array<unsigned int, n_surfaces> surface;
    };

    /**
     * All of these are kept by reference; there are no pairs before reinit().
     */
    SlipInterface(const MixedSpace        &space,
                  const Anatomy           &anatomy,
                  const InterfaceCoupling &coupling);

    /** Whether liquid and wall have nodes of their own. */
    bool
    exists() const;

    /** Whether the normals follow the deformation. */
    bool
    follows_the_deformation() const;

    /** Find the pairs, after every change of the mesh. Collective. */
    void
    reinit();

    /** Compute the normals at @p solution. Collective. */
    void
    update_normals(const Vector &solution);

    /**
     * Add the constraints to those on hanging nodes and prescribed
     * displacements that are in @p constraints already. A direction in which
     * the liquid is prescribed is left alone.
     */
    void
    add_constraints(dealii::AffineConstraints<double> &constraints) const;

    /** The pairs this rank knows: all on its own cells, and more. */
    const std::vector<NodePair> &
    pairs() const;

    /** The sums m of the surfaces at a pair, as many as meet there. */
    std::vector<dealii::Tensor<1, dim>>
    normals(const NodePair &pair) const;

  private:
    /** Call function(liquid_cell, face number) for the faces between liquid and
     * wall of all cells that are not artificial. */
    template <typename Function>
    void
    for_each_face(const Function &function) const;

    void
    find_pairs();

    void
    merge_surfaces();

    const MixedSpace        &space;
    const Anatomy           &anatomy;
    const InterfaceCoupling &coupling;

    dealii::AffineConstraints<double> hanging_nodes;
    std::vector<NodePair>             node_pairs;
    std::array<Vector, n_surfaces>    m;
  };
} // namespace lumbricus

#endif
