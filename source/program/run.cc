// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/chain_problem.h>
#include <lumbricus/program/run.h>

#include <memory>
#include <sstream>

namespace lumbricus
{
  void
  run(const CommandLine &command_line, const MPI_Comm comm)
  {
    ParameterFile file;
    RunParameters parameters;
    file.read(command_line.parameter_file);
    for (const std::string &setting : command_line.settings)
      file.set(setting);
    file.parse(parameters);
    parameters.initialize();
    if (!command_line.output_folder.empty())
      parameters.output_folder = command_line.output_folder;

    // First see whether results can be written, but leave what is in the folder
    // as it is until the input has turned out to be right.
    std::unique_ptr<RunFolder> folder;
    if (!command_line.check)
      folder = std::make_unique<RunFolder>(parameters.output_folder, comm);

    Log          log(comm);
    ChainProblem problem(parameters, log, comm);
    problem.setup();

    if (folder != nullptr)
      {
        log.open(folder->path() + "/log.txt");
        std::ostringstream resolved;
        file.print_resolved(resolved);
        folder->write_collectively(
          "parameters.prm",
          dealii::Utilities::MPI::this_mpi_process(comm) == 0,
          [&](std::ostream &out) { out << resolved.str(); });
      }

    std::ostringstream version;
    print_version(version);
    log << version.str() << blas_warning();
    problem.describe();
    if (command_line.check)
      log << "The input is valid; nothing was computed.\n";
    else
      problem.run(*folder);
  }
} // namespace lumbricus
