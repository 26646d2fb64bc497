// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_input_h
#define lumbricus_program_run_input_h

#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/output/run_folder.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/program/command_line.h>
#include <lumbricus/program/run_parameters.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What the user asks of a run: the command line, the parameters, and where
   * it goes on the checkpoint that it goes on from.
   */
  class RunInput
  {
  public:
    /** Read the input and initialize the parameters. Throws ExcInput.
     * Collective. */
    RunInput(const CommandLine &command_line, const MPI_Comm comm);

    /** Whether the run goes on from a checkpoint. */
    bool
    restarts() const;

    /** Whether the run that is asked to go on has come to its end, with all
     * files. Throws ExcInput where it has come further. */
    bool
    is_over() const;

    /** See whether results can be written to the folder of the parameters, but
     * leave what is in there as it is. Throws ExcInput. Collective. */
    void
    open_folder();

    /** All parameters as a parameter file, see
     * ParameterFile::print_resolved(). */
    std::string
    resolved(const ParameterFile::Values &instead = {}) const;

    /** What checkpoints say that was asked for, with the files that
     * the parameters name as they are now. */
    RunRequest
    request() const;

    /**
     * Where @p input_files and the folder of results are, by parameter, so
     * that parameters.prm runs the run again from anywhere, into its folder.
     * What a parameter file cannot hold stays as the user wrote it.
     */
    ParameterFile::Values
    places(const std::vector<InputFile> &input_files) const;

    const CommandLine  command_line; ///< what was asked for
    ParameterFile      file;         ///< the parameters as text
    RunParameters      parameters;   ///< what they made
    /** Where results go; none before open_folder() unless the run goes on. */
    std::unique_ptr<RunFolder> folder;
    /** What the run goes on from, or none. */
    std::unique_ptr<Checkpoint> checkpoint;
    /** What to say of checkpoints that cannot be read. */
    std::string skipped_checkpoints;

  private:
    void
    read_checkpoint();

    /** The parameters of the run that goes on, with files that are where they
     * were where they are not found from the working directory. */
    void
    take_parameters();

    const MPI_Comm comm;
  };
} // namespace lumbricus

#endif
