// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <system_error>

#include "checkpoint_files.h"

namespace lumbricus
{
  namespace
  {
    namespace files = std::filesystem;

    // The largest text that is read: no run has that many pictures.
    constexpr std::uintmax_t largest_text = 1 << 28;



    // Run @p read. An ExcDamaged of it is about the file @p name.
    template <typename Read>
    auto
    reading(const std::string &name, const Read &read)
    {
      try
        {
          return read();
        }
      catch (const ExcDamaged &exception)
        {
          throw ExcDamaged("has a file '" + name + "' that " +
                           plain_message(exception));
        }
    }



    std::string
    no_checkpoint(const std::string &run_folder, const std::string &skipped)
    {
      return "The folder '" + run_folder +
             "' has no checkpoint to go on from.\n" + skipped +
             "Give the output folder of a run with 'Checkpoints', or start "
             "the run from its parameter file.";
    }
  } // namespace



  void
  Checkpoint::check_folder(const std::string &run_folder, const MPI_Comm comm)
  {
    std::error_code error;
    throw_on_all_ranks<ExcInput>(
      files::is_directory(run_folder + "/checkpoints", error) ?
        "" :
        no_checkpoint(run_folder, ""),
      comm);
  }



  Checkpoint
  Checkpoint::newest(const RunFolder &folder,
                     std::string     &skipped,
                     const MPI_Comm   comm)
  {
    Texts       texts;
    std::string path;
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      for (const std::string &name : checkpoints_of(folder))
        {
          const std::string candidate = checkpoint_path(folder, name);
          std::string       wrong;
          Checkpoint        tried;
          try
            {
              texts = read(candidate, folder.record().run_id());
              tried.take(texts);
              AssertThrow(checkpoint_name(tried.run_progress.step) == name,
                          ExcDamaged("is of step " +
                                     std::to_string(tried.run_progress.step) +
                                     "."));
              path = candidate;
              break;
            }
          catch (const ExcDamaged &exception)
            {
              wrong = plain_message(exception);
            }
          catch (const ExcUnknownItem &exception)
            {
              const std::string &version = tried.manifest.version;
              wrong = "is of " +
                      (version.empty() ? "another version" :
                                         "version " + version) +
                      " and has '" + plain_message(exception) +
                      "', which this version, " LUMBRICUS_VERSION
                      ", does not know. Go on with that version.";
            }
          skipped += "The checkpoint '" + candidate +
                     "' cannot be used: it " + wrong + " It is left out.\n";
        }

    path = dealii::Utilities::MPI::broadcast(comm, path);
    throw_on_all_ranks<ExcInput>(
      path.empty() ? no_checkpoint(folder.path(), skipped) : "", comm);
    Checkpoint found;
    found.folder_path = path;
    found.take(dealii::Utilities::MPI::broadcast(comm, texts));
    return found;
  }



  Checkpoint::Texts
  Checkpoint::read(const std::string &path, const std::string &run_id)
  {
    std::error_code error;
    AssertThrow(files::exists(path + "/" + Manifest::file_name, error),
                ExcDamaged("was not completed."));
    Texts texts;
    texts.manifest = read_regular(path, Manifest::file_name, largest_text);
    const Manifest manifest = reading(Manifest::file_name, [&]() {
      return Manifest::read(texts.manifest);
    });
    AssertThrow(manifest.run_id == run_id,
                ExcDamaged("is of another run than the folder."));

    const auto listed = [&](const std::string   &name,
                            const std::uintmax_t most) {
      return read_listed(path, name, manifest, most);
    };
    texts.progress   = listed(Manifest::progress, largest_text);
    texts.inputs     = listed(Manifest::inputs, largest_text);
    texts.parameters = listed(Manifest::parameters, largest_text);

    const std::uintmax_t n_cells =
      std::accumulate(manifest.cells_of_rank.begin(),
                      manifest.cells_of_rank.end(),
                      std::uintmax_t(0));
    texts.mesh = listed(Manifest::mesh, largest_mesh_content(n_cells));
    AssertThrow(is_mesh_content(texts.mesh),
                ExcDamaged("has a file '" + Manifest::mesh +
                           "' that is not one of cells."));

    for (unsigned int rank = 0; rank < manifest.cells_of_rank.size(); ++rank)
      {
        // The size first: a file with holes may be larger than any disk.
        const std::string name   = Manifest::cells(rank);
        const Fingerprint listed = manifest.files.at(name);
        const std::string file   = path + "/" + name;
        const bool is_file = files::is_regular_file(
          files::symlink_status(file, error));
        const auto size = is_file ? files::file_size(file, error) : 0;
        AssertThrow(is_file && !error && size == listed.size,
                    ExcDamaged("has a file '" + name + "' of " +
                               std::to_string(size) + " bytes instead of " +
                               std::to_string(listed.size) + "."));
        const auto content = fingerprint_of_file(file);
        AssertThrow(content && content->value() == listed,
                    ExcDamaged("has a file '" + name +
                               "' whose checksum is wrong."));
      }
    return texts;
  }



  void
  Checkpoint::take(const Texts &texts)
  {
    manifest     = Manifest::read(texts.manifest);
    run_progress = reading(Manifest::progress, [&]() {
      return RunProgress::read(texts.progress);
    });
    AssertThrow(manifest.cell_size ==
                  cell_record_size(run_progress.histories.size(),
                                   run_progress.past.size()),
                ExcDamaged("has cells of " +
                           std::to_string(manifest.cell_size) +
                           " bytes, which is not what its state has."));
    run_request.input_files = reading(Manifest::inputs, [&]() {
      return read_input_files(texts.inputs);
    });
    run_request.parameters = texts.parameters;
    mesh                   = texts.mesh;
  }



  const std::string &
  Checkpoint::path() const
  {
    return folder_path;
  }



  const RunRequest &
  Checkpoint::request() const
  {
    return run_request;
  }



  const std::string &
  Checkpoint::program_version() const
  {
    return manifest.version;
  }



  const RunProgress &
  Checkpoint::progress() const
  {
    return run_progress;
  }



  void
  Checkpoint::refine(ParallelMesh &triangulation) const
  {
    refine_cells(triangulation, refined_in(mesh));
  }



  void
  Checkpoint::check_outline(const StateOutline &expected) const
  {
    const std::set<std::string> &wanted = expected.histories;
    const std::string advice =
      " At a restart a boundary condition that remembers cannot be added, "
      "removed or renamed: start the run from its parameter file.";
    for (const std::string &name : wanted)
      AssertThrow(run_progress.histories.count(name) > 0,
                  ExcInput("The checkpoint '" + folder_path +
                           "' does not have the history '" + name +
                           "', which this run needs." + advice));
    for (const std::string &name : run_progress.histories)
      AssertThrow(wanted.count(name) > 0,
                  ExcInput("The checkpoint '" + folder_path +
                           "' has the history '" + name +
                           "', which this run does not have." + advice));

    const auto is_like = [](const auto &one, const auto &other) {
      return one.first == other.first &&
             one.second.size() == other.second.size();
    };
    AssertThrow(std::equal(run_progress.globals.begin(),
                           run_progress.globals.end(),
                           expected.globals.begin(),
                           expected.globals.end(),
                           is_like),
                ExcInput("The checkpoint '" + folder_path +
                         "' has other global unknowns than the body of its "
                         "parameters. Start the run from its parameter "
                         "file."));
  }



  State
  Checkpoint::read_state(const MixedSpace   &space,
                         const StateOutline &expected) const
  {
    check_outline(expected);
    State state = space.zero_state({run_progress.time,
                                    run_progress.time,
                                    run_progress.past,
                                    run_progress.histories,
                                    run_progress.globals});

    // Ranks own contiguous parts of the space-filling curve, then and now: read
    // the files that overlap with this rank's part.
    std::uintmax_t n_owned = 0;
    for (const auto &cell : space.triangulation.active_cell_iterators())
      n_owned += cell->is_locally_owned();
    const MPI_Comm comm  = space.communicator();
    const auto n_of_rank = dealii::Utilities::MPI::all_gather(comm, n_owned);
    const auto this_rank =
      n_of_rank.begin() + dealii::Utilities::MPI::this_mpi_process(comm);
    const std::uintmax_t first =
      std::accumulate(n_of_rank.begin(), this_rank, std::uintmax_t(0));
    const std::uintmax_t n_cells =
      std::accumulate(this_rank, n_of_rank.end(), first);

    CellReader     reader(space, state);
    std::uintmax_t begin = 0;
    for (unsigned int rank = 0; rank < manifest.cells_of_rank.size(); ++rank)
      {
        const std::uintmax_t end = begin + manifest.cells_of_rank[rank];
        if (begin < first + n_owned && first < end)
          {
            std::ifstream in(folder_path + "/" + Manifest::cells(rank),
                             std::ios::binary);
            reader.read(in);
          }
        begin = end;
      }

    const std::string advice = " Go on with the version that wrote it, " +
                               manifest.version +
                               ", or start the run from its parameter file.";
    throw_on_all_ranks<ExcInput>(
      reader.is_complete() && begin == n_cells ?
        "" :
        "The checkpoint '" + folder_path + "' is of " + std::to_string(begin) +
          " cells, but the mesh of its parameters has " +
          std::to_string(n_cells) + (begin == n_cells ? " others." : ".") +
          advice,
      comm);
    throw_on_all_ranks<ExcInput>(
      reader.is_finite() ? "" :
                           "The checkpoint '" + folder_path +
                             "' has a state that is not finite." + advice,
      comm);
    return state;
  }
} // namespace lumbricus
