// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_checkpoint_h
#define lumbricus_checkpoint_checkpoint_h

#include <lumbricus/adaptivity/mesh_record.h>
#include <lumbricus/checkpoint/manifest.h>
#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/discretization/state_record.h>
#include <lumbricus/output/run_folder.h>
#include <lumbricus/parameters/input_file.h>

#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a run was asked to do, so that it can be asked again. */
  struct RunRequest
  {
    std::string            parameters; ///< all, with the values of the run
    std::vector<InputFile> input_files; ///< that they name, on rank 0
  };



  /**
   * Write all that a run needs to go on to checkpoints/STEP in its folder:
   * mesh, cells.RANK, progress, inputs, parameters.prm, and last a MANIFEST
   * with their checksums, read back from disk. Without a manifest a checkpoint
   * does not count. Of older ones the newest is kept. Throws ExcSolveFailed,
   * and leaves the older ones as they are, where that is not possible (the disk
   * is full). Collective.
   */
  void
  write_checkpoint(const RunFolder    &folder,
                   const ParallelMesh &triangulation,
                   const MixedSpace   &space,
                   const State        &state,
                   const RunProgress  &progress,
                   const RunRequest   &request);



  /** A checkpoint that is complete. */
  class Checkpoint
  {
  public:
    /**
     * Find the newest of a run that is as it was written; @p skipped says which
     * newer ones are damaged, and how. Nothing in them is trusted: they may
     * come from anywhere. Throws ExcInput where there is none. Collective.
     */
    static Checkpoint
    newest(const RunFolder &folder, std::string &skipped, const MPI_Comm comm);

    /** Throw ExcInput where the folder of that name cannot have one.
     * Collective. */
    static void
    check_folder(const std::string &run_folder, const MPI_Comm comm);

    /** Where it is, from the working directory. */
    const std::string &
    path() const;

    /** The parameters of the run, and the files that they name. */
    const RunRequest &
    request() const;

    /** The version of the program that wrote it. */
    const std::string &
    program_version() const;

    /** What a run has to remember besides its State. */
    const RunProgress &
    progress() const;

    /** Make the mesh of it out of the coarse mesh. Collective. */
    void
    refine(ParallelMesh &triangulation) const;

    /** Read the state, on as many ranks as there are. Throws ExcInput where it
     * is not that of this mesh, or has other histories or global unknowns than
     * @p expected. Collective. */
    State
    read_state(const MixedSpace   &space,
               const StateOutline &expected) const;

  private:
    /** The small files, which all ranks have. */
    struct Texts
    {
      std::string manifest;
      std::string progress;
      std::string inputs;
      std::string parameters;
      std::string mesh;

      /** For sending it to all ranks. */
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &manifest &progress &inputs &parameters &mesh;
      }
    };

    /** Throw ExcInput where the state has other histories or global unknowns
     * than @p expected. */
    void
    check_outline(const StateOutline &expected) const;

    /** Read and check all files of it. Throws ExcDamaged, ExcUnknownItem. */
    static Texts
    read(const std::string &path, const std::string &run_id);

    /** Take what read() gave. Throws ExcDamaged, ExcUnknownItem. */
    void
    take(const Texts &texts);

    std::string folder_path;
    Manifest    manifest;
    RunProgress run_progress;
    RunRequest  run_request;
    std::string mesh;
  };
} // namespace lumbricus

#endif
