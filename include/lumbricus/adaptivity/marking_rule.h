// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_marking_rule_h
#define lumbricus_adaptivity_marking_rule_h

#include <lumbricus/parameters/parameter_owner.h>

#include <cstddef>
#include <vector>

namespace lumbricus
{
  /**
   * How many cells to refine, those of the largest estimated error, and how
   * many families of eight cells to merge, those of the smallest.
   */
  class MarkingRule : public ParameterOwner
  {
  public:
    /** How many, on all ranks. */
    struct Counts
    {
      std::size_t refined = 0; ///< cells to cut into eight
      std::size_t merged  = 0; ///< families to make one cell of
    };

    /** The mesh there is. */
    struct Mesh
    {
      std::size_t n_cells    = 0; ///< active, on all ranks
      std::size_t n_unknowns = 0; ///< free or not, on all ranks
    };

    /**
     * @param of_cells eta_K^2 of the cells that may be refined, the largest
     * first.
     * @param of_families the sums of eta_K^2 of the families that may be
     * merged, the smallest first.
     */
    virtual Counts
    counts(const std::vector<double> &of_cells,
           const std::vector<double> &of_families,
           const Mesh                &mesh) const = 0;
  };
} // namespace lumbricus

#endif
