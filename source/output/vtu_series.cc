// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/vtu_series.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

namespace lumbricus
{
  namespace Interpretation = dealii::DataComponentInterpretation;

  VtuSeries::VtuSeries(const RunFolder  &folder,
                       const MixedSpace &space,
                       const Anatomy    &anatomy)
    : folder(folder)
    , space(space)
    , anatomy(anatomy)
  {}



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

    const std::string base =
      "vtu/solution_" +
      dealii::Utilities::int_to_string(times_and_names.size(), 5);
    const auto piece = [&](const unsigned int r) {
      return base + "." + std::to_string(r) + ".vtu";
    };
    folder.write_collectively(piece(rank), true, [&](std::ostream &out) {
      data_out.write_vtu(out);
    });

    times_and_names.emplace_back(state.time, base + ".pvtu");
    folder.write_collectively(base + ".pvtu",
                              rank == 0,
                              [&](std::ostream &out) {
                                std::vector<std::string> pieces;
                                for (unsigned int r = 0; r < n_ranks; ++r)
                                  pieces.push_back(piece(r).substr(4));
                                data_out.write_pvtu_record(out, pieces);
                              });
    folder.write_collectively(
      "solution.pvd", rank == 0, [&](std::ostream &out) {
        dealii::DataOutBase::write_pvd_record(out, times_and_names);
      });
  }
} // namespace lumbricus
