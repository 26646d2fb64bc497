// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/vtu_series.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>
#include <deal.II/numerics/data_out.h>

#include <optional>
#include <regex>

namespace lumbricus
{
  namespace
  {
    const std::string sub_folder  = "vtu";
    const std::string series_name = "solution.pvd";

    // The name of picture @p number without its ending.
    std::string
    base_name(const unsigned int number)
    {
      return "solution_" + dealii::Utilities::to_string(number, 5);
    }



    // The picture that a file in the folder of pictures belongs to.
    std::optional<unsigned int>
    number_of(const std::string &name)
    {
      static const std::regex form(
        "solution_([0-9]{5,9})\\.(?:[0-9]{1,9}\\.vtu|pvtu)");
      std::smatch parts;
      if (name.size() > 40 || !std::regex_match(name, parts, form))
        return {};
      return std::stoul(parts[1]);
    }
  } // namespace



  VtuSeries::VtuSeries(RunFolder        &folder,
                       const MixedSpace &space,
                       const Anatomy    &anatomy)
    : folder(folder)
    , space(space)
    , anatomy(anatomy)
  {
    folder.claim(series_name);
    folder.claim_folder(sub_folder, [](const std::string &name) {
      return number_of(name).has_value();
    });
  }



  std::string
  VtuSeries::file_name(const unsigned int number)
  {
    return sub_folder + "/" + base_name(number) + ".pvtu";
  }



  const std::vector<std::pair<double, std::string>> &
  VtuSeries::files() const
  {
    return times_and_names;
  }



  void
  VtuSeries::continue_after(
    const std::vector<std::pair<double, std::string>> &files)
  {
    times_and_names = files;
    folder.on_first_rank([&]() {
      folder.remove(sub_folder, [&](const std::string &name) {
        const auto number = number_of(name);
        return number && *number >= files.size();
      });
    });
  }



  void
  VtuSeries::write(const State &state, const CellFields &cell_fields)
  {
    const MPI_Comm     comm    = space.communicator();
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(comm);
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);

    dealii::Vector<double> segment(space.triangulation.n_active_cells());
    dealii::Vector<double> tissue(segment.size());
    dealii::Vector<double> owner(segment.size());
    for (const auto &cell : space.triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Region region                = Region::of(cell->material_id());
          segment[cell->active_cell_index()] = region.segment + 1;
          tissue[cell->active_cell_index()]  = region.tissue;
          owner[cell->active_cell_index()]   = rank;
        }

    dealii::DataOut<dim>          data_out;
    dealii::DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = true;
    flags.time                     = state.time;
    flags.cycle                    = times_and_names.size();
    data_out.set_flags(flags);
    data_out.attach_triangulation(space.triangulation);
    data_out.add_data_vector(cell_fields.dof_handler(),
                             cell_fields.values(),
                             cell_fields.names(),
                             cell_fields.interpretations());
    data_out.add_data_vector(segment, "segment");
    data_out.add_data_vector(tissue, "tissue");
    data_out.add_data_vector(owner, "rank");
    data_out.build_patches(space.mapping,
                           MixedSpace::degree,
                           dealii::DataOut<dim>::curved_inner_cells);

    const unsigned int       number = times_and_names.size();
    const std::string        whole  = file_name(number);
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < n_ranks; ++r)
      pieces.push_back(base_name(number) + "." + std::to_string(r) + ".vtu");
    folder.on_first_rank([&]() {
      std::vector<std::string> names = {whole};
      for (const std::string &piece : pieces)
        names.push_back(sub_folder + "/" + piece);
      folder.record().add_files(names);
    });
    folder.write_collectively(sub_folder + "/" + pieces[rank],
                              true,
                              [&](std::ostream &out) {
                                data_out.write_vtu(out);
                              });

    times_and_names.emplace_back(state.time, whole);
    folder.write_collectively(whole, rank == 0, [&](std::ostream &out) {
      data_out.write_pvtu_record(out, pieces);
    });
    folder.write_collectively(
      series_name, rank == 0, [&](std::ostream &out) {
        dealii::DataOutBase::write_pvd_record(out, times_and_names);
      });
  }
} // namespace lumbricus
