// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>

#include <deal.II/base/utilities.h>

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

    const std::string mesh_header = "cells that are refined\n";

    // The largest text that is read: no run has that many pictures.
    constexpr std::uintmax_t largest_text = 1 << 28;



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
      folder.write(checkpoint_in_folder(checkpoint) + "/" + name,
                   [&](std::ostream &out) { out << content; });
      const std::string file_name =
        checkpoint_path(folder, checkpoint) + "/" + name;
      AssertThrow(content_of(file_name) == content,
                  ExcSolveFailed("The file '" + file_name +
                                 "' is not on disk as it was written. Check "
                                 "the disk."));
      return Manifest::line_of_file(name, fingerprint(content));
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



    // The whole of a file that has to be there, of no more than @p most bytes.
    std::string
    read_regular(const std::string   &path,
                 const std::string   &name,
                 const std::uintmax_t most)
    {
      const std::string file_name = path + "/" + name;
      std::error_code   error;
      AssertThrow(files::is_regular_file(
                    files::symlink_status(file_name, error)),
                  ExcDamaged("does not have the file '" + name + "'."));
      AssertThrow(files::file_size(file_name, error) <= most,
                  ExcDamaged("has a file '" + name + "' of more than " +
                             std::to_string(most) + " bytes."));
      return content_of(file_name);
    }



    // The content of a regular file, which is what the manifest says.
    std::string
    read_listed(const std::string   &path,
                const std::string   &name,
                const Manifest      &manifest,
                const std::uintmax_t most)
    {
      const std::string content = read_regular(path, name, most);
      const Fingerprint listed  = manifest.files.at(name);
      AssertThrow(content.size() == listed.size,
                  ExcDamaged("has a file '" + name + "' of " +
                             std::to_string(content.size()) +
                             " bytes instead of " +
                             std::to_string(listed.size) + "."));
      AssertThrow(fingerprint(content) == listed,
                  ExcDamaged("has a file '" + name +
                             "' whose checksum is wrong."));
      return content;
    }



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

    // A cell that is cut gives eight, of which seven are more than before.
    const std::uintmax_t n_cells =
      std::accumulate(manifest.cells_of_rank.begin(),
                      manifest.cells_of_rank.end(),
                      std::uintmax_t(0));
    texts.mesh = listed(Manifest::mesh,
                        mesh_header.size() + n_cells / 7 * sizeof(CellKey));
    AssertThrow(texts.mesh.compare(0, mesh_header.size(), mesh_header) == 0 &&
                  (texts.mesh.size() - mesh_header.size()) % sizeof(CellKey) ==
                    0,
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
    std::set<CellKey> refined;
    for (std::size_t at = mesh_header.size(); at < mesh.size();
         at += sizeof(CellKey))
      {
        CellKey key;
        std::copy_n(mesh.data() + at,
                    sizeof(CellKey),
                    reinterpret_cast<char *>(key.data()));
        refined.insert(key);
      }
    refine_cells(triangulation, refined);
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
