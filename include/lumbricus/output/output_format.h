// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_output_format_h
#define lumbricus_output_output_format_h

#include <lumbricus/output/cell_fields.h>
#include <lumbricus/output/obstacle_surfaces.h>
#include <lumbricus/output/run_folder.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A way to write pictures, the fields of some states: one of the files of
   * each picture stands for it, and is what checkpoints note.
   */
  class OutputFormat : public ParameterOwner
  {
  public:
    /** The pictures of a run: time and file_name() of each. */
    using Pictures = std::vector<std::pair<double, std::string>>;

    /** In the section of its name in Output; none, unless a format says so. */
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** The name of the picture @p number, from 0, in the folder: without
     * blanks. */
    virtual std::string
    file_name(const unsigned int number) const = 0;

    /**
     * Claim all files it will write in @p folder, which is kept by reference;
     * nothing is written before write(). Before RunFolder::begin(). Throws
     * ExcInput, see RunFolder::claim(). Collective.
     */
    virtual void
    claim(RunFolder &folder) = 0;

    /** Write the picture of @p state with @p fields, which are computed at that
     * state, and the surfaces of obstacles beside the body, the same on all
     * ranks. Throws ExcSolveFailed. Collective. */
    virtual void
    write(const State                          &state,
          const CellFields                     &fields,
          const std::vector<Obstacle::Surface> &obstacles) = 0;

    /** The pictures so far. */
    virtual const Pictures &
    pictures() const = 0;

    /** Go on after these; those of the run that came after them are removed.
     * After RunFolder::begin(). Collective. */
    virtual void
    continue_after(const Pictures &pictures) = 0;
  };
} // namespace lumbricus

#endif
