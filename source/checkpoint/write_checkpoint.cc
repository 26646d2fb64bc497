// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>

#include <deal.II/base/mpi.h>

#include <numeric>
#include <set>
#include <sstream>
#include <string>

#include "checkpoint_files.h"

namespace lumbricus
{
  namespace
  {
    // The files that the first rank writes. @return their lines.
    std::string
    write_common_files(const RunFolder         &folder,
                       const std::string       &checkpoint,
                       const std::set<CellKey> &refined,
                       const RunProgress       &progress,
                       const RunRequest        &request)
    {
      std::ostringstream text;
      progress.write(text);
      const auto write = [&](const std::string &name,
                             const std::string &content) {
        return write_and_check(folder, checkpoint, name, content);
      };
      return write(Manifest::mesh, mesh_content(refined)) +
             write(Manifest::progress, text.str()) +
             write(Manifest::inputs, to_text(request.input_files)) +
             write(Manifest::parameters, request.parameters);
    }
  } // namespace



  void
  write_checkpoint(const RunFolder    &folder,
                   const ParallelMesh &triangulation,
                   const MixedSpace   &space,
                   const State        &state,
                   const RunProgress  &progress,
                   const RunRequest   &request)
  {
    const MPI_Comm     comm = space.communicator();
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm);
    const std::string  name = checkpoint_name(progress.step);

    const auto         refined = refined_cells(triangulation);
    std::ostringstream cells;
    write_cells(space, state, cells);

    folder.on_first_rank([&]() { make_checkpoint_folder(folder, name); });

    std::string lines, reason;
    try
      {
        if (rank == 0)
          lines = write_common_files(folder, name, refined, progress, request);
        lines +=
          write_and_check(folder, name, Manifest::cells(rank), cells.str());
      }
    catch (const ExcSolveFailed &exception)
      {
        reason = plain_message(exception);
      }
    lines +=
      Manifest::line_of_cells(rank,
                              triangulation.n_locally_owned_active_cells(),
                              cell_record_size(progress.histories.size(),
                                               progress.past.size()));
    const auto all_lines = dealii::Utilities::MPI::gather(comm, lines);
    reason               = first_message(reason, comm);

    if (reason.empty() && rank == 0)
      try
        {
          write_and_check(
            folder,
            name,
            Manifest::file_name,
            Manifest::text(folder.record().run_id(),
                           std::accumulate(all_lines.begin(),
                                           all_lines.end(),
                                           std::string())));
          remove_old_checkpoints(folder, name);
        }
      catch (const ExcSolveFailed &exception)
        {
          reason = plain_message(exception);
        }
    if (!reason.empty() && rank == 0)
      remove_checkpoint(folder, name);
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);
  }
} // namespace lumbricus
