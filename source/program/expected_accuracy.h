// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_expected_accuracy_h
#define lumbricus_program_expected_accuracy_h

#include <lumbricus/output/earlier_run.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What errors a run with @p parameters on @p n_unknowns may be expected to
   * estimate, in words, from those that @p runs have estimated with the same
   * parameters on another mesh: with cells of h times the size
   *
   *   e(h) = e(1) h^p,
   *
   * where p is between 1 and 3, or what two earlier runs have found, on meshes
   * that were refined in the same way. @p folder is that of the results; of a run
   * there with other parameters these are named, and nothing is expected. Empty
   * where nothing can be said.
   */
  std::string
  expected_accuracy(const EarlierRun::Values      &parameters,
                    const std::uint64_t            n_unknowns,
                    const std::string             &folder,
                    const std::vector<EarlierRun> &runs);
} // namespace lumbricus

#endif
