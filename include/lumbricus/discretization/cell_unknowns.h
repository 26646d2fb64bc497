// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_unknowns_h
#define lumbricus_discretization_cell_unknowns_h

#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * How the unknowns of the locally owned cells hang together with the free
   * unknowns of the problem: u_cell = C x (+ inhomogeneity), where C is the
   * identity for most cells and carries the constraints of the others.
   *
   * On a cell the unknowns are ordered such that those which no other cell
   * shares come first: the displacement of the node in the middle (0, 1, 2),
   * the pressure modes (3 to 6), then component c of node n at 7 + 3 n + c.
   */
  class CellUnknowns
  {
  public:
    /** Unknowns of a cell: 81 displacements and 4 pressures. */
    static constexpr unsigned int n_per_cell = cell_sizes::n_per_cell;
    /** Unknowns that a cell shares with no other one. */
    static constexpr unsigned int n_private =
      dim + MixedSpace::n_pressure_modes;

    /** Place on the cell of component @p c at node @p n. */
    static constexpr unsigned int
    displacement(const unsigned int c, const unsigned int n)
    {
      return n == MixedSpace::n_nodes - 1 ? c : n_private + dim * n + c;
    }

    /** Place on the cell of pressure mode @p m. */
    static constexpr unsigned int
    pressure(const unsigned int m)
    {
      return dim + m;
    }

    /** For the cells of @p space, which is kept by reference; empty before
     * reinit(). */
    explicit CellUnknowns(const MixedSpace &space);

    /** Anew after every change of the mesh or the constraints. Collective. */
    void
    reinit(const dealii::AffineConstraints<double> &constraints);

    /**
     * Take unknowns that are not those of the space, as on a coarser mesh:
     * @p of_cells has n_per_cell of them for each cell, and this rank
     * owns those in @p owned, a range. Collective.
     */
    void
    reinit(const dealii::IndexSet                             &owned,
           const std::vector<dealii::types::global_dof_index> &of_cells,
           const dealii::AffineConstraints<double>            &constraints);

    /**
     * Only the weights and inhomogeneities of @p constraints have changed, as
     * far as it knows: if so, take them over; then vectors, numberings and
     * patterns stay what they are.
     * @return whether it was so on all ranks. If not, nothing is changed:
     * reinit() has to follow. Collective.
     */
    bool
    update_weights(const dealii::AffineConstraints<double> &constraints);

    /** Only the inhomogeneities of @p constraints have changed. */
    void
    update_inhomogeneities(
      const dealii::AffineConstraints<double> &constraints);

    /** Make @p x zero, with places for the ghost entries that the owned cells
     * need. (Assignment keeps those that a vector has.) */
    void
    reinit_vector(Vector &x) const;

    /** Read the entries of owned cell @p i as they are. */
    void
    read(const unsigned int i, const Vector &x, double *values) const;

    /** values = C x. */
    void
    read_free(const unsigned int i, const Vector &x, double *values) const;

    /** Set values to the inhomogeneity; @return whether there is any. */
    bool
    read_inhomogeneity(const unsigned int i, double *values) const;

    /** x += C^T values. */
    void
    add(const unsigned int i, const double *values, Vector &x) const;

    /** The free unknowns that owned cell @p i hangs on, as places in a vector;
     * its private unknowns come first. */
    dealii::ArrayView<const unsigned int>
    free_unknowns(const unsigned int i) const;

    /** The places of the unknowns of owned cell @p i, constrained or not. */
    const unsigned int *
    places(const unsigned int i) const
    {
      return place.data() + std::size_t(i) * n_per_cell;
    }

    /** Whether unknown @p k of owned cell @p i is constrained. */
    bool
    is_constrained(const unsigned int i, const unsigned int k) const;

    /** Row @p k of C of owned cell @p i: places of free unknowns, weights. */
    std::vector<std::pair<unsigned int, double>>
    row(const unsigned int i, const unsigned int k) const;

    /** Replace a square matrix in the unknowns of the cell, by rows, by
     * C^T matrix C in its free unknowns. */
    void
    apply_constraints(const unsigned int i, std::vector<double> &matrix) const;

    /** Whether the owned entry at a place is a constrained unknown. */
    const std::vector<bool> &
    is_constrained() const
    {
      return constrained;
    }

    /** How many cells there are: the owned ones or, on a coarser mesh, those
     * given to reinit(). */
    unsigned int
    n_cells() const
    {
      return of_constrained_cell.size();
    }

  private:
    /** C of a cell that has constrained unknowns, by rows. */
    struct Constrained
    {
      std::vector<unsigned int> free_unknowns;
      std::vector<unsigned int> row_begin;
      std::vector<unsigned int> column;
      std::vector<double>       weight;
      /** Constrained unknowns: place on the cell, index, inhomogeneity. */
      std::vector<unsigned int>                    rows;
      std::vector<dealii::types::global_dof_index> indices;
      std::vector<double>                          inhomogeneities;
    };

    /** Whether nothing but weights and inhomogeneities differs. */
    bool
    is_like(const CellUnknowns &other) const;

    const MixedSpace &space;

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    std::vector<unsigned int>                                  place;
    std::vector<bool>                                          constrained;
    std::vector<Constrained> constrained_cells;
    std::vector<int>         of_constrained_cell; // -1: C is the identity
  };
} // namespace lumbricus

#endif
