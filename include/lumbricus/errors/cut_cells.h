// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_cut_cells_h
#define lumbricus_errors_cut_cells_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/multigrid/embedding.h>

#include <map>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A mesh and the one that has eight cells in place of each of its cells, all
   * eight on one rank, which need not be that of the large one. Functions on the
   * large cells are functions on the small ones, u_small = P u, and residuals on
   * the small cells are residuals on the large ones, r = P^T r_small.
   */
  class CutCells
  {
  public:
    /** All of these are kept by reference, and have to be set up. */
    CutCells(const Body         &large,
             const CellUnknowns &large_unknowns,
             const Body         &small,
             const CellUnknowns &small_unknowns);

    /** Write @p state on the large cells to @p on_small, a state on the small
     * ones with the same outline: the same functions and global unknowns.
     * Collective. */
    void
    prolongate(const State &state, State &on_small) const;

    /** @p y = P @p x in the free unknowns. Collective. */
    void
    prolongate(Vector &y, const Vector &x) const;

    /** @p y = P^T @p x in the free unknowns. Collective. */
    void
    restrict_to(Vector &y, const Vector &x) const;

    /** For each owned large cell |sum| of products of the entries of @p x and @p y,
     * free unknowns of the small cells, inside of it: of those of several cells in
     * equal shares. Collective. */
    std::vector<double>
    products(const Vector &x, const Vector &y) const;

    /** The number, on this rank, of the eight that small cell @p i is one of. */
    unsigned int
    family(const unsigned int i) const
    {
      return members[i].family;
    }

    /** Which of the eight it is, as the parent numbers them. */
    unsigned int
    child(const unsigned int i) const
    {
      return members[i].child;
    }

  private:
    /** Where a small cell belongs. */
    struct Member
    {
      unsigned int family; ///< number on this rank
      unsigned int child;  ///< which of it
    };

    /** Numbers of cells, one for each other rank that they go to or come from. */
    using OfRanks = std::map<unsigned int, std::vector<unsigned int>>;

    /** Numbers of the owned large cells, @p width each, as those of families.
     * Collective. */
    std::vector<double>
    to_families(const std::vector<double> &of_large,
                const unsigned int         width) const;

    /** The opposite. Collective. */
    std::vector<double>
    to_large(const std::vector<double> &of_families,
             const unsigned int         width) const;

    const Body          large, small;
    const CellUnknowns &large_unknowns;
    const CellUnknowns &small_unknowns;
    const Embedding     embedding;
    std::vector<Member> members; ///< of each owned small cell
    unsigned int        n_families = 0;
    /** Families whose parent is here: their number and the owned large cell. */
    std::vector<std::pair<unsigned int, unsigned int>> here;
    OfRanks large_for; ///< owned large cells whose families others have
    OfRanks from;      ///< families whose parents others have
    Vector  shares;    ///< 1 / number of small cells of an unknown
  };
} // namespace lumbricus

#endif
