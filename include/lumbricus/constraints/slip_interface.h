// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_slip_interface_h
#define lumbricus_constraints_slip_interface_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/constraints/interface_coupling.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The interface at which liquid slips along the wall. Both have nodes of
   * their own at the same places at rest; each such pair b satisfies
   *
   *   m_b(u) . ( (u_liquid - u_wall) - (u_liquid - u_wall)_0 ) = 0,
   *
   *   m_b(u) = int N_b cof(F) N dA,
   *
   * where 0 is the state that the solve for u began with, and the integral is
   * over the liquid's side. These are the normals for which a hydrostatic
   * liquid is in equilibrium exactly: the nodal forces of a constant pressure p
   * are p m_b. Where two or three surfaces meet (wall and septum) each has its
   * m, so that the liquid stays in the corner. With normals that do not follow
   * the deformation m_b is that at rest.
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
      /** The unknowns of the wall at the same place. */
      std::array<dealii::types::global_dof_index, dim> wall;
      /** Where the two nodes are at rest [mm]. */
      dealii::Point<dim> X;
      /** The segment of the liquid, from zero. */
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

    /** Compute the normals at @p solution, and what pairs have slipped since
     * @p start. Collective. */
    void
    update(const Vector &solution, const Vector &start);

    /**
     * Add the constraints on increments to those on hanging nodes and
     * prescribed displacements that are in @p constraints already; their
     * inhomogeneity is what the pairs are off the condition by. A direction in
     * which the liquid is prescribed is left alone.
     * @return the largest inhomogeneity that this rank has added [mm].
     */
    double
    add_constraints(dealii::AffineConstraints<double> &constraints) const;

    /** Whether face @p f of @p cell, which is not artificial, is the liquid's
     * side of the interface. */
    bool
    is_liquid_side(
      const dealii::DoFHandler<dim>::active_cell_iterator &cell,
      const unsigned int                                   f) const;

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

    /** m of all surfaces at @p solution. */
    void
    update_normals(const Vector &solution);

    void
    merge_surfaces();

    const MixedSpace        &space;
    const Anatomy           &anatomy;
    const InterfaceCoupling &coupling;

    dealii::AffineConstraints<double> hanging_nodes;
    std::vector<NodePair>             node_pairs;
    std::array<Vector, n_surfaces>    m;
    Vector                            moved; // since the start of the solve
  };
} // namespace lumbricus

#endif
