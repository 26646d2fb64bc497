// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_mesh_parameters_h
#define lumbricus_program_mesh_parameters_h

#include <lumbricus/output/earlier_run.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * How much smaller the cells of one mesh are than those of another of the same
   * body: log2(h_coarse / h_fine) for each direction that has a number of cells,
   * all refinements included, and one more for cells that are refined locally.
   * 1 is half the size; never without elements.
   */
  using Refinement = std::vector<double>;

  /** That from the mesh of @p coarse to that of @p fine, which need not be finer;
   * none where a number of cells does not say how large they are. */
  std::optional<Refinement>
  refinement(const EarlierRun::Values &coarse, const EarlierRun::Values &fine);

  /** The element that is furthest from 0. */
  double
  main_element(const Refinement &refinement);

  /** Whether both go the same way, as far or not, or the way back. Neither is
   * where nothing changes. */
  bool
  same_way(const Refinement &one, const Refinement &other);

  /** The parameters, by path, that do not have the same value in both and of which
   * results hang in another way than through the size of cells. */
  std::vector<std::string>
  parameters_that_differ(const EarlierRun::Values &one,
                         const EarlierRun::Values &other);
} // namespace lumbricus

#endif
