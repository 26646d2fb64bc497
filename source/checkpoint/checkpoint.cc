// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/core/exceptions.h>

#include <deal.II/base/utilities.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <sstream>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    namespace files = std::filesystem;

    const std::string folder_name  = "checkpoints";
    const std::string manifest_end = "checksum ";
    const std::string mesh_header  = "cells that are refined\n";

    std::string
    cells_file(const unsigned int rank)
    {
      return "cells." + std::to_string(rank);
    }



    std::uint32_t
    checksum(const std::string &content)
    {
      boost::crc_32_type crc;
      crc.process_bytes(content.data(), content.size());
      return crc.checksum();
    }



    std::string
    content_of(const std::string &file_name)
    {
      std::ifstream in(file_name, std::ios::binary);
      return {std::istreambuf_iterator<char>(in), {}};
    }



    // Write a file and read it back. @return its line in the manifest.
    std::string
    write_and_check(const RunFolder   &folder,
                    const std::string &checkpoint,
                    const std::string &name,
                    const std::string &content)
    {
      folder.write(checkpoint + "/" + name,
                   [&](std::ostream &out) { out << content; });
      const std::string file_name =
        folder.path() + "/" + checkpoint + "/" + name;
      AssertThrow(content_of(file_name) == content,
                  ExcSolveFailed("The file '" + file_name +
                                 "' is not on disk as it was written. Check "
                                 "the disk."));
      return "file " + std::to_string(checksum(content)) + " " +
             std::to_string(content.size()) + " " + name + "\n";
    }



    std::string
    mesh_content(const std::set<CellKey> &refined)
    {
      std::string content = mesh_header;
      for (const CellKey &key : refined)
        content.append(reinterpret_cast<const char *>(key.data()),
                       sizeof(CellKey));
      return content;
    }



    // All files of this rank. @return their lines in the manifest.
    std::string
    write_files(const RunFolder         &folder,
                const std::string       &checkpoint,
                const std::set<CellKey> &refined,
                const std::string       &cells,
                const RunProgress       &progress,
                const std::string       &parameters,
                const unsigned int       rank)
    {
      std::string lines;
      if (rank == 0)
        {
          std::ostringstream text;
          progress.write(text);
          lines +=
            write_and_check(folder, checkpoint, "mesh", mesh_content(refined)) +
            write_and_check(folder, checkpoint, "progress", text.str()) +
            write_and_check(folder, checkpoint, "parameters.prm", parameters);
        }
      return lines +
             write_and_check(folder, checkpoint, cells_file(rank), cells);
    }



    // The numbered folders, newest first.
    std::vector<std::string>
    numbered_folders(const std::string &run_folder)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (const auto &entry :
           files::directory_iterator(run_folder + "/" + folder_name, error))
        names.push_back(entry.path().filename().string());
      std::sort(names.rbegin(), names.rend());
      return names;
    }



    // Remove all but this checkpoint and the newest older one that is complete.
    void
    remove_old(const std::string &run_folder, const std::string &current)
    {
      bool kept = false;
      for (const std::string &name : numbered_folders(run_folder))
        {
          const files::path path = files::path(run_folder) / folder_name / name;
          const bool        older = name < current;
          if (name == current ||
              (older && !kept && files::exists(path / "MANIFEST")))
            {
              kept = kept || older;
              continue;
            }
          std::error_code error;
          files::remove_all(path, error);
        }
    }
  } // namespace



  void
  write_checkpoint(const RunFolder    &folder,
                   const ParallelMesh &triangulation,
                   const MixedSpace   &space,
                   const State        &state,
                   const RunProgress  &progress,
                   const std::string  &parameters)
  {
    const MPI_Comm     comm = space.communicator();
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm);
    const std::string name = dealii::Utilities::int_to_string(progress.step, 6);
    const std::string checkpoint = folder_name + "/" + name;
    const std::string path       = folder.path() + "/" + checkpoint;

    const auto         refined = refined_cells(triangulation);
    std::ostringstream cells;
    write_cells(space, state, cells);

    std::string reason;
    if (rank == 0)
      {
        std::error_code error;
        files::remove_all(path, error);
        files::create_directories(path, error);
        if (error)
          reason = "The folder '" + path +
                   "' cannot be made: " + error.message() + ".";
      }
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);

    std::string lines;
    try
      {
        lines = write_files(
          folder, checkpoint, refined, cells.str(), progress, parameters, rank);
      }
    catch (const ExcSolveFailed &exception)
      {
        reason = plain_message(exception);
      }
    lines += "cells " + std::to_string(rank) + " " +
             std::to_string(triangulation.n_locally_owned_active_cells()) +
             "\n";
    const auto all_lines = dealii::Utilities::MPI::gather(comm, lines);
    reason               = first_message(reason, comm);

    if (reason.empty() && rank == 0)
      try
        {
          std::string manifest = "version " LUMBRICUS_VERSION "\n";
          for (const std::string &of_rank : all_lines)
            manifest += of_rank;
          folder.write(checkpoint + "/MANIFEST", [&](std::ostream &out) {
            out << manifest << manifest_end << checksum(manifest) << '\n';
          });
          remove_old(folder.path(), name);
        }
      catch (const ExcSolveFailed &exception)
        {
          reason = plain_message(exception);
        }
    if (!reason.empty() && rank == 0)
      {
        std::error_code error;
        files::remove_all(path, error);
      }
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);
  }



  Checkpoint
  Checkpoint::newest(const std::string &run_folder,
                     std::string       &skipped,
                     const MPI_Comm     comm)
  {
    Checkpoint  found;
    std::string path;
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      for (const std::string &name : numbered_folders(run_folder))
        {
          found                   = Checkpoint();
          found.path              = run_folder + "/" + folder_name + "/" + name;
          const std::string wrong = found.read_manifest(true);
          if (wrong.empty())
            {
              path = found.path;
              break;
            }
          skipped += "The checkpoint '" + found.path +
                     "' cannot be used: " + wrong + " It is left out.\n";
        }

    path = dealii::Utilities::MPI::broadcast(comm, path);
    AssertThrow(!path.empty(),
                ExcInput("The folder '" + run_folder +
                         "' has no checkpoint to go on from.\n" + skipped +
                         "Give the output folder of a run with 'Checkpoints', "
                         "or start the run from its parameter file."));
    found                   = Checkpoint();
    found.path              = path;
    const std::string wrong = found.read_manifest(false);
    throw_on_all_ranks<ExcInput>(wrong, comm);
    return found;
  }



  std::string
  Checkpoint::read_manifest(const bool check_files)
  {
    const std::string text = content_of(path + "/MANIFEST");
    const auto        end  = text.rfind(manifest_end);
    if (text.empty() || end == std::string::npos)
      return "it was not completed.";
    std::istringstream manifest(text.substr(0, end));
    if (text.substr(end) !=
        manifest_end + std::to_string(checksum(manifest.str())) + "\n")
      return "the checksum of its MANIFEST is wrong.";

    std::string item;
    while (manifest >> item)
      if (item == "version")
        manifest >> version;
      else if (item == "cells")
        {
          unsigned int rank, n_cells;
          manifest >> rank >> n_cells;
          cells_of_rank.resize(
            std::max<std::size_t>(cells_of_rank.size(), rank + 1));
          cells_of_rank[rank] = n_cells;
        }
      else if (item == "file")
        {
          std::uint32_t crc;
          std::size_t   size;
          std::string   name;
          manifest >> crc >> size >> name;
          if (!check_files)
            continue;
          const std::string content = content_of(path + "/" + name);
          if (content.size() != size)
            return "the file '" + name + "' has " +
                   std::to_string(content.size()) + " bytes instead of " +
                   std::to_string(size) + ".";
          if (checksum(content) != crc)
            return "the checksum of the file '" + name + "' is wrong.";
        }

    std::ifstream in(path + "/progress");
    std::string   unknown;
    run_progress = RunProgress::read(in, unknown);
    return unknown.empty() ?
             "" :
             "it is of version " + version + " and has '" + unknown +
               "', which this version, " LUMBRICUS_VERSION
               ", does not know. Go on with that version.";
  }



  std::string
  Checkpoint::parameter_file() const
  {
    return path + "/parameters.prm";
  }



  const std::string &
  Checkpoint::program_version() const
  {
    return version;
  }



  const RunProgress &
  Checkpoint::progress() const
  {
    return run_progress;
  }



  void
  Checkpoint::refine(ParallelMesh &triangulation) const
  {
    const std::string content = content_of(path + "/mesh");
    std::set<CellKey> refined;
    for (std::size_t at = mesh_header.size(); at < content.size();
         at += sizeof(CellKey))
      {
        CellKey key;
        std::copy_n(content.data() + at,
                    sizeof(CellKey),
                    reinterpret_cast<char *>(key.data()));
        refined.insert(key);
      }
    refine_cells(triangulation, refined);
  }



  State
  Checkpoint::read_state(const MixedSpace &space) const
  {
    State state = space.initial_state();
    state.time  = run_progress.time;

    // Ranks own contiguous parts of the space-filling curve, then and now: read
    // the files that overlap with this rank's part.
    unsigned int n_owned = 0;
    for (const auto &cell : space.triangulation.active_cell_iterators())
      n_owned += cell->is_locally_owned();
    const MPI_Comm comm  = space.communicator();
    const auto n_of_rank = dealii::Utilities::MPI::all_gather(comm, n_owned);
    const auto this_rank =
      n_of_rank.begin() + dealii::Utilities::MPI::this_mpi_process(comm);
    const unsigned int first =
      std::accumulate(n_of_rank.begin(), this_rank, 0u);
    const unsigned int n_cells =
      std::accumulate(this_rank, n_of_rank.end(), first);

    unsigned int n_read = 0, begin = 0;
    for (unsigned int rank = 0; rank < cells_of_rank.size(); ++rank)
      {
        const unsigned int end = begin + cells_of_rank[rank];
        if (begin < first + n_owned && first < end)
          {
            std::ifstream in(path + "/" + cells_file(rank), std::ios::binary);
            n_read += read_cells(space, in, state);
          }
        begin = end;
      }
    state.compress();

    const std::string wrong =
      n_read == n_owned && begin == n_cells ?
        "" :
        "The checkpoint '" + path + "' is of " + std::to_string(begin) +
          " cells, but the mesh of its parameters has " +
          std::to_string(n_cells) + ". Go on with the version that wrote it, " +
          version + ", or start the run from its parameter file.";
    throw_on_all_ranks<ExcInput>(wrong, comm);
    return state;
  }
} // namespace lumbricus
