// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_vtu_series_h
#define lumbricus_output_vtu_series_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/cell_fields.h>
#include <lumbricus/output/run_folder.h>

#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * The pictures of a run, for ParaView: for every time a VTU file per rank
   * and a PVTU that joins them, and solution.pvd over all times. The geometry
   * is the reference configuration; warp by the displacement.
   */
  class VtuSeries
  {
  public:
    /**
     * All of these are kept by reference; nothing is written before write().
     * Before RunFolder::begin(). Throws ExcInput, see RunFolder::claim().
     * Collective.
     */
    VtuSeries(RunFolder        &folder,
              const MixedSpace &space,
              const Anatomy    &anatomy);

    /** Write @p state with the fields of @p cell_fields, which are computed
     * at that state. Collective. */
    void
    write(const State &state, const CellFields &cell_fields);

    /** The times and names of the files so far. */
    const std::vector<std::pair<double, std::string>> &
    files() const;

    /** The name of the picture @p number, from 0, in the folder: that which
     * files() has. */
    static std::string
    file_name(const unsigned int number);

    /** Go on after these files; those of the run that came after them are
     * removed. After RunFolder::begin(). Collective. */
    void
    continue_after(const std::vector<std::pair<double, std::string>> &files);

  private:
    const RunFolder  &folder;
    const MixedSpace &space;
    const Anatomy    &anatomy;

    std::vector<std::pair<double, std::string>> times_and_names;
  };
} // namespace lumbricus

#endif
