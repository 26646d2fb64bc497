// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cell_lineage.h"

#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  std::vector<CellLineage>
  cell_lineages(const MixedSpace &space)
  {
    std::vector<CellLineage> cells;
    for (const auto &active : space.owned_cells())
      {
        CellLineage line;
        auto        cell = mesh_cell(active);
        line.keys.push_back(cell_key(cell));
        for (; cell->level() > 0; cell = cell->parent())
          {
            line.child.push_back(child_number(cell));
            line.keys.push_back(cell_key(cell->parent()));
          }
        for (unsigned int d = 0; d < dim; ++d)
          {
            line.extent[d] = 0.;
            for (const unsigned int v : cell->vertex_indices())
              if (((v >> d) & 1) == 0)
                line.extent[d] +=
                  cell->vertex(v).distance(cell->vertex(v | (1u << d)));
          }
        std::reverse(line.keys.begin(), line.keys.end());
        std::reverse(line.child.begin(), line.child.end());
        cells.push_back(line);
      }
    return cells;
  }



  // All-gathers the cells of which a rank owns only a part. Ranks own
  // stretches of a space-filling curve, so these are few on each rank.
  SplitCells
  split_cells(const std::vector<CellLineage> &cells, const MPI_Comm comm)
  {
    std::map<CellKey, double> owned_part;
    for (const CellLineage &cell : cells)
      for (unsigned int l = 0; l < cell.level(); ++l)
        owned_part[cell.keys[l]] +=
          std::ldexp(1., -int(dim * (cell.level() - l)));
    std::vector<CellKey> split;
    for (const auto &[key, part] : owned_part)
      if (part < 1.)
        split.push_back(key);

    SplitCells ranks;
    const auto all = dealii::Utilities::MPI::all_gather(comm, split);
    for (unsigned int rank = 0; rank < all.size(); ++rank)
      for (const CellKey &key : all[rank])
        ranks[key].push_back(rank);
    return ranks;
  }



  int
  node_of_ancestor(const CellLineage &cell,
                   const unsigned int level,
                   const unsigned int v)
  {
    static const auto hierarchic =
      dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(
        MixedSpace::degree);
    const unsigned int half = 1u << (cell.level() - level - 1);
    unsigned int       node = 0;
    for (unsigned int d = dim; d-- > 0;)
      {
        unsigned int x = 0;
        for (unsigned int l = level; l < cell.level(); ++l)
          x = 2 * x + ((cell.child[l] >> d) & 1);
        x += (v >> d) & 1;
        if (x % half != 0)
          return -1;
        node = (MixedSpace::degree + 1) * node + x / half;
      }
    return hierarchic[node];
  }



  PatchKey
  patch_key(const CellLineage &cell,
            const unsigned int level,
            const double       thin)
  {
    // Patches have at most so many cells in a thin direction.
    constexpr unsigned int log_one_direction = 3, log_two_directions = 2;

    const double largest =
      *std::max_element(cell.extent.begin(), cell.extent.end());
    std::array<bool, dim> is_thin;
    unsigned int          n_thin = 0;
    for (unsigned int d = 0; d < dim; ++d)
      n_thin += is_thin[d] = thin * cell.extent[d] < largest;

    PatchKey key{cell.keys[0], {}};
    for (unsigned int d = 0; d < dim; ++d)
      {
        unsigned int x = 0;
        for (unsigned int l = 0; l < level; ++l)
          x = 2 * x + ((cell.child[l] >> d) & 1);
        key.second[d] = !is_thin[d] ? x :
                                      x >> (n_thin == 1 ? log_one_direction :
                                                          log_two_directions);
      }
    key.second[dim] = level;
    return key;
  }
} // namespace lumbricus
