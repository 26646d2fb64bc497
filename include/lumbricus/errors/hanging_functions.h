// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_hanging_functions_h
#define lumbricus_errors_hanging_functions_h

#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/family_functions.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * Functions of the Enrichment where large cells of two sizes meet, in place of
   * FamilyFunctions, which would end on one side: those of single nodes of small
   * cells, each 1 there and what the hanging nodes make of it that follow it. They
   * are at all nodes that some other follows, but for those that the large cells
   * have too.
   */
  class HangingFunctions
  {
  public:
    /** An entry of E. */
    struct Entry
    {
      unsigned int child;  ///< which of the eight
      unsigned int row;    ///< its unknown
      unsigned int column; ///< function, of those of the eight
      double       weight; ///< its value there
    };

    /** What there is of them on eight small cells. */
    struct OfFamily
    {
      std::vector<unsigned int> places; ///< free unknown of each function
      std::vector<Entry>        entries; ///< of E
    };

    /** For the small cells @p body; everything is kept by reference. Collective. */
    HangingFunctions(const Body            &body,
                     const CellUnknowns    &unknowns,
                     const CutCells        &cells,
                     const FamilyFunctions &functions);

    /** Those on @p children, the numbers of owned cells. */
    OfFamily
    of_family(const std::array<unsigned int, FamilyFunctions::n_children>
                &children) const;

    /** Whether other nodes follow the free unknown at a place, or it is that of a
     * function. */
    bool
    leads(const unsigned int place) const
    {
      return followers.local_element(place) > 0.;
    }

  private:
    const CellUnknowns &unknowns;
    Vector              followers;      ///< more than 0: there are some
    Vector              of_large_cells; ///< more than 0: these have it too
  };
} // namespace lumbricus

#endif
