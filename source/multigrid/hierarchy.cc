// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <set>

#include "coarse_level.h"

namespace lumbricus
{
  void
  Hierarchy::reinit(const MixedSpace   &space,
                    const CellUnknowns &unknowns,
                    const unsigned int  n_coarsest,
                    const double        thin)
  {
    const MPI_Comm comm  = space.communicator();
    const auto     cells = cell_lineages(space);
    const auto     split = split_cells(cells, comm);
    const auto     me    = dealii::Utilities::MPI::this_mpi_process(comm);

    levels.clear();
    levels.emplace_back();
    levels[0].unknowns      = &unknowns;
    levels[0].n_cells       = cells.size();
    levels[0].n_owned_cells = cells.size();
    levels[0].n_unknowns    = space.dof_handler.n_dofs();

    // From fine to coarse, and turned round at the end.
    for (unsigned int l = space.triangulation.n_global_levels() - 1;
         l > 0 && levels.back().n_unknowns > n_coarsest;
         --l)
      {
        CoarseLevel coarse =
          make_coarse_level(space, unknowns, cells, split, l - 1);
        Level &fine = levels.back();
        fine.parent.assign(fine.n_owned_cells,
                           dealii::numbers::invalid_unsigned_int);
        fine.child.assign(fine.n_owned_cells, -1);
        std::set<CellKey>                done;
        std::map<PatchKey, unsigned int> patch_with;
        for (unsigned int i = 0, next = 0; i < cells.size(); ++i)
          {
            const CellLineage &cell  = cells[i];
            const unsigned int here  = std::min(l, cell.level());
            const unsigned int there = std::min(l - 1, cell.level());
            const CellKey     &key   = cell.keys[here];
            const auto         found = split.find(key);
            const bool         mine =
              found == split.end() || found->second.front() == me;
            if (!mine || !done.insert(key).second)
              continue;
            fine.parent[next] = coarse.cell_of.at(cell.keys[there]);
            if (here != there)
              fine.child[next] = cell.child[there];
            const auto patch = patch_with.emplace(patch_key(cell, here, thin),
                                                  patch_with.size());
            fine.patches.resize(patch_with.size());
            fine.patches[patch.first->second].push_back(next);
            ++next;
          }
        levels.push_back(std::move(coarse.level));
      }
    std::reverse(levels.begin(), levels.end());
  }
} // namespace lumbricus
