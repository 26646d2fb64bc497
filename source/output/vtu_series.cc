// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/vtu_series.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/utilities.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <map>
#include <optional>
#include <regex>
#include <tuple>

namespace lumbricus
{
  namespace Interpretation = dealii::DataComponentInterpretation;



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



    // A text as the value of an attribute in XML.
    std::string
    xml_text(const std::string &text)
    {
      static const std::map<char, std::string> entities = {{'&', "&amp;"},
                                                           {'<', "&lt;"},
                                                           {'>', "&gt;"},
                                                           {'"', "&quot;"},
                                                           {'\'', "&apos;"}};
      std::string                              xml;
      for (const char c : text)
        {
          const auto entity = entities.find(c);
          xml += entity == entities.end() ? std::string(1, c) : entity->second;
        }
      return xml;
    }



    // DataOut with any names for the fields: it takes letters and digits alone,
    // and writes them as they are.
    class NamedDataOut : public dealii::DataOut<dim>
    {
    public:
      // Add a vector whose components have the names @p names.
      void
      add_fields(
        const dealii::DoFHandler<dim>  &dof_handler,
        const Vector                   &values,
        const std::vector<std::string> &names,
        const std::vector<Interpretation::DataComponentInterpretation>
          &interpretations)
      {
        std::map<std::string, std::string> stand_ins;
        std::vector<std::string>           taken;
        for (const std::string &name : names)
          {
            const std::string next = "field" + std::to_string(shown.size());
            const auto [entry, is_new] = stand_ins.insert({name, next});
            if (is_new)
              shown[next] = xml_text(name);
            taken.push_back(entry->second);
          }
        add_data_vector(dof_handler, values, taken, interpretations);
      }

    protected:
      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> names =
          dealii::DataOut<dim>::get_dataset_names();
        for (std::string &name : names)
          name = shown_name(name);
        return names;
      }

      std::vector<std::tuple<unsigned int,
                             unsigned int,
                             std::string,
                             Interpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        auto ranges = dealii::DataOut<dim>::get_nonscalar_data_ranges();
        for (auto &range : ranges)
          std::get<2>(range) = shown_name(std::get<2>(range));
        return ranges;
      }

    private:
      std::string
      shown_name(const std::string &name) const
      {
        const auto entry = shown.find(name);
        return entry == shown.end() ? name : entry->second;
      }

      std::map<std::string, std::string> shown;
    };
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

    NamedDataOut                  data_out;
    dealii::DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = true;
    flags.time                     = state.time;
    flags.cycle                    = times_and_names.size();
    data_out.set_flags(flags);
    data_out.attach_triangulation(space.triangulation);
    data_out.add_fields(cell_fields.dof_handler(),
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
