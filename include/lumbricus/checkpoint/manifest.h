// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_manifest_h
#define lumbricus_checkpoint_manifest_h

#include <lumbricus/core/fingerprint.h>

#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** The files of a checkpoint, and what has to be in them. Where there is a
   * whole one, with the right checksum, the checkpoint is complete. */
  struct Manifest
  {
    std::string version; ///< of the program that wrote it
    std::string run_id;  ///< RunRecord::run_id()

    std::map<std::string, Fingerprint> files;         ///< by name
    std::vector<unsigned int>          cells_of_rank; ///< in the file of each
    unsigned int                       cell_size = 0; ///< [bytes]

    static const std::string file_name;  ///< MANIFEST
    static const std::string mesh;       ///< the cells that are refined
    static const std::string progress;   ///< RunProgress
    static const std::string inputs;     ///< InputFile, of all
    static const std::string parameters; ///< parameters.prm

    /** The file with the cells of a rank. */
    static std::string
    cells(const unsigned int rank);

    /** Whether the program writes files of this name into a checkpoint. */
    static bool
    is_name_of_a_file(const std::string &name);

    /** The line of a file with @p content. */
    static std::string
    line_of_file(const std::string &name, const Fingerprint &content);

    /** The line that says how many cells of how many bytes there are in the
     * file of a rank. */
    static std::string
    line_of_cells(const unsigned int rank,
                  const unsigned int n_cells,
                  const unsigned int cell_size);

    /** A manifest with @p lines of all ranks, and its checksum. */
    static std::string
    text(const std::string &run_id, const std::string &lines);

    /** Read what text() gave. Throws ExcDamaged where it is not whole, or not
     * that of all the files there have to be, of the sizes they have to have;
     * ExcUnknownItem. */
    static Manifest
    read(const std::string &text);
  };
} // namespace lumbricus

#endif
