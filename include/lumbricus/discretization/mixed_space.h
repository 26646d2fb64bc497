// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_mixed_space_h
#define lumbricus_discretization_mixed_space_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/nested_shape.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/iterator_range.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_collection.h>

#include <array>
#include <functional>
#include <memory>

namespace lumbricus
{
  /**
   * The discrete spaces on the mesh: Q2 displacements and discontinuous P1
   * pressures (one FESystem), and discontinuous Q2 for the rest
   * displacements u_ref and u_vol of the liquid, so that a reset stays in its
   * cell. Q2 mapping.
   *
   * On a cell, all of these are addressed by node (0..26, the order of
   * FE_Q(2)) and component, and by pressure mode (0..3).
   *
   * Where the liquid has displacements of its own (it may slip along the
   * wall), wall and liquid do not share unknowns: the cells have the elements
   * [Q2^3, Nothing^3, P1] and [Nothing^3, Q2^3, P1]. On a cell both number
   * their unknowns as the element without the nothing does, so whoever works
   * on one cell need not know.
   */
  class MixedSpace
  {
  public:
    static constexpr unsigned int degree = 2; ///< of displacements
    /** Of displacements on a cell. */
    static constexpr unsigned int n_nodes = cell_sizes::n_nodes;
    /** Of the pressure on a cell. */
    static constexpr unsigned int n_pressure_modes = cell_sizes::n_modes;
    /** On a cell. */
    static constexpr unsigned int n_q_points = cell_sizes::n_q;

    /** On @p triangulation, which is kept by reference and may be coarse or
     * empty still. Numbers nothing: see distribute_dofs(). */
    explicit MixedSpace(const dealii::Triangulation<dim> &triangulation);

    /** Which cells, by their material id, have displacements that they do not
     * share with the others. */
    using Separate = std::function<bool(const dealii::types::material_id)>;

    /**
     * Number the unknowns and compute the mapping, after every change of the
     * mesh. Without @p separate all cells share the displacements of their
     * common nodes. Collective.
     */
    void
    distribute_dofs(const Separate &separate = {});

    /** Cells finer than @p level inherit their shape at rest. To be set before
     * unknowns are numbered. */
    void
    set_finest_curved_level(const unsigned int level);

    /** A state of rest at time zero, with the histories that all runs have. */
    State
    initial_state() const;

    /** A state that consists of what @p outline says, all of it zero. */
    State
    zero_state(const StateOutline &outline) const;

    /** @p solution, which has owned entries, with those that the owned cells
     * need, to be read only. Collective. */
    Vector
    with_ghosts(const Vector &solution) const;

    /** Make @p x zero, with places for the ghost entries that this rank's cells
     * and the ghosts around have. (Assignment may keep those of an old mesh.)
     */
    void
    reinit_vector(Vector &x) const;

    /** A range of the cells of dof_handler that this rank owns. */
    dealii::IteratorRange<
      dealii::FilteredIterator<dealii::DoFHandler<dim>::active_cell_iterator>>
    owned_cells() const;

    /** The communicator of the mesh. */
    MPI_Comm
    communicator() const;

    /** The mesh at rest, which never moves. */
    const dealii::Triangulation<dim> &triangulation;

    /** The element of a cell, without the nothing. */
    const dealii::FESystem<dim>              fe;
    const dealii::FESystem<dim>              rest_fe;    ///< of u_ref and u_vol
    const dealii::QGauss<dim>                quadrature; ///< 3 x 3 x 3
    const dealii::QGauss<dim - 1>            face_quadrature; ///< 3 x 3
    const dealii::FEValuesExtractors::Vector displacement;    ///< of fe
    const dealii::FEValuesExtractors::Scalar pressure;        ///< of fe

    /** The triquadratic shape of the cells at rest. */
    dealii::MappingQCache<dim> mapping;
    /** Numbers u and p. */
    dealii::DoFHandler<dim> dof_handler;
    /** Numbers u_ref and u_vol. */
    dealii::DoFHandler<dim> rest_dof_handler;
    /** The unknowns of dof_handler that this rank owns. */
    dealii::IndexSet locally_owned;
    /** The unknowns of dof_handler on this rank's own cells and on the ghosts
     * around, owned or not. */
    dealii::IndexSet locally_relevant;

    /** Index on the cell of displacement component c at node n: [c][n]. */
    std::array<std::array<unsigned int, n_nodes>, dim> displacement_dof;
    /** Index on the cell of pressure mode m. */
    std::array<unsigned int, n_pressure_modes> pressure_dof;
    /** Index on the cell of component c of u_ref at node n: [c][n]. */
    std::array<std::array<unsigned int, n_nodes>, dim> rest_dof;

  private:
    using Partitioner = dealii::Utilities::MPI::Partitioner;

    NestedShape shape;
    /** How vectors are spread over the ranks: of unknowns without and with
     * ghost entries, and of u_ref and u_vol. Vectors share them. */
    std::shared_ptr<const Partitioner> owned, relevant, rest_owned;
    /** The elements of wall and liquid where these are separate. */
    const dealii::hp::FECollection<dim> separate_fes;
  };
} // namespace lumbricus

#endif
