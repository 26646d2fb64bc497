// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_coarse_level_h
#define lumbricus_multigrid_coarse_level_h

#include <lumbricus/multigrid/hierarchy.h>

#include <map>
#include <vector>

#include "cell_lineage.h"

namespace lumbricus
{
  /** A level below the finest, and which of its cells is which. */
  struct CoarseLevel
  {
    /** Its unknowns and cells; parents are still missing. */
    Level level;
    /** From a cell to its number in the level, of all that this rank knows. */
    std::map<CellKey, unsigned int> cell_of;
  };

  /** Make level @p l of the mesh of @p space with the active cells @p cells and
   * @p unknowns on the finest. Collective. */
  CoarseLevel
  make_coarse_level(const MixedSpace               &space,
                    const CellUnknowns             &unknowns,
                    const std::vector<CellLineage> &cells,
                    const SplitCells               &split,
                    const unsigned int              l);
} // namespace lumbricus

#endif
