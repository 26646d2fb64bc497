// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_checkpoint_h
#define lumbricus_checkpoint_checkpoint_h

#include <lumbricus/adaptivity/mesh_record.h>
#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/discretization/state_record.h>
#include <lumbricus/output/run_folder.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Write all that a run needs to go on to checkpoints/STEP in its folder:
   * mesh, cells.RANK, progress, parameters.prm, and last a MANIFEST with
   * their checksums, read back from disk. Without a manifest a checkpoint does
   * not count. Of older ones the newest is kept. Throws ExcSolveFailed, and
   * leaves the older ones as they are, where that is not possible (the disk is
   * full). Collective.
   */
  void
  write_checkpoint(const RunFolder    &folder,
                   const ParallelMesh &triangulation,
                   const MixedSpace   &space,
                   const State        &state,
                   const RunProgress  &progress,
                   const std::string  &parameters);



  /** A checkpoint that is complete. */
  class Checkpoint
  {
  public:
    /**
     * Find the newest in the folder of a run whose checksums are right;
     * @p skipped says which newer ones are damaged, and how. Throws ExcInput
     * where there is none. Collective.
     */
    static Checkpoint
    newest(const std::string &run_folder,
           std::string       &skipped,
           const MPI_Comm     comm);

    /** Its parameters.prm. */
    std::string
    parameter_file() const;

    /** The version of the program that wrote it. */
    const std::string &
    program_version() const;

    /** What a run has to remember besides its State. */
    const RunProgress &
    progress() const;

    /** Make the mesh of it out of the coarse mesh. Collective. */
    void
    refine(ParallelMesh &triangulation) const;

    /** Read the state, on as many ranks as there are. Collective. */
    State
    read_state(const MixedSpace &space) const;

  private:
    /** Read MANIFEST and progress, and check all files against it where
     * @p check_files. @return what is wrong, or "". */
    std::string
    read_manifest(const bool check_files);

    std::string               path;
    std::string               version;
    RunProgress               run_progress;
    std::vector<unsigned int> cells_of_rank;
  };
} // namespace lumbricus

#endif
