// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/output_format.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/reference_cell.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_component_interpretation.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <regex>
#include <tuple>

namespace lumbricus
{
  namespace Interpretation = dealii::DataComponentInterpretation;



  namespace
  {
    const std::string sub_folder  = "vtu";
    const std::string series_name = "solution.pvd";
    const std::string obstacles_series_name = "obstacles.pvd";

    // The name of picture @p number without its ending.
    std::string
    base_name(const unsigned int number)
    {
      return "solution_" + dealii::Utilities::to_string(number, 5);
    }



    // The file with the obstacles of picture @p number, in the folder.
    std::string
    obstacles_name(const unsigned int number)
    {
      return sub_folder + "/obstacles_" +
             dealii::Utilities::to_string(number, 5) + ".vtu";
    }



    // The picture that a file in the folder of pictures belongs to.
    std::optional<unsigned int>
    number_of(const std::string &name)
    {
      static const std::regex form(
        "solution_([0-9]{5,9})\\.(?:[0-9]{1,9}\\.vtu|pvtu)|"
        "obstacles_([0-9]{5,9})\\.vtu");
      std::smatch parts;
      if (name.size() > 40 || !std::regex_match(name, parts, form))
        return {};
      return std::stoul(parts[parts[1].matched ? 1 : 2]);
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



    Interpretation::DataComponentInterpretation
    interpretation_of(const Field::Kind kind)
    {
      switch (kind)
        {
          case Field::Kind::vector:
            return Interpretation::component_is_part_of_vector;
          case Field::Kind::tensor:
            return Interpretation::component_is_part_of_tensor;
          default:
            return Interpretation::component_is_scalar;
        }
    }



    // DataOut with any names for the fields: it takes letters and digits alone,
    // and writes them as they are.
    class NamedDataOut : public dealii::DataOut<dim>
    {
    public:
      void
      add(const CellFields &fields)
      {
        std::vector<std::string>                                 names;
        std::vector<Interpretation::DataComponentInterpretation> kinds;
        for (const FieldArray &array : fields.nodal_arrays())
          {
            const unsigned int n = array.field->n_components();
            names.insert(names.end(), n, stand_in_for(array.name));
            kinds.insert(kinds.end(),
                         n,
                         interpretation_of(array.field->kind()));
          }
        add_data_vector(fields.dof_handler(), fields.values(), names, kinds);
        for (unsigned int i = 0; i < fields.cell_arrays().size(); ++i)
          add_data_vector(fields.cell_values(i),
                          stand_in_for(fields.cell_arrays()[i].name));
      }

      // Behind the patches of the mesh.
      void
      append(const std::vector<FillingCell> &cells)
      {
        for (const FillingCell &cell : cells)
          {
            constexpr unsigned int          n = MixedSpace::n_nodes;
            dealii::DataOutBase::Patch<dim> patch;
            // In rows of three: corners are the first and the last ones.
            for (const unsigned int v :
                 dealii::GeometryInfo<dim>::vertex_indices())
              patch.vertices[v] =
                cell.X[2 * (v % 2) + 6 * (v / 2 % 2) + 18 * (v / 4)];
            patch.reference_cell =
              dealii::ReferenceCells::get_hypercube<dim>();
            patch.patch_index          = patches.size();
            patch.n_subdivisions       = MixedSpace::degree;
            patch.points_are_available = true;

            const unsigned int n_nodal = cell.nodal.size() / n;
            patch.data.reinit(n_nodal + cell.per_cell.size() + dim, n);
            for (unsigned int i = 0; i < n; ++i)
              {
                unsigned int row = 0;
                for (unsigned int c = 0; c < n_nodal; ++c)
                  patch.data(row++, i) = cell.nodal[c * n + i];
                for (const double value : cell.per_cell)
                  patch.data(row++, i) = value;
                for (unsigned int d = 0; d < dim; ++d)
                  patch.data(row++, i) = cell.X[i][d];
              }
            patches.push_back(patch);
          }
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
      stand_in_for(const std::string &name)
      {
        const std::string next = "field" + std::to_string(shown.size());
        shown[next]            = xml_text(name);
        return next;
      }

      std::string
      shown_name(const std::string &name) const
      {
        const auto entry = shown.find(name);
        return entry == shown.end() ? name : entry->second;
      }

      std::map<std::string, std::string> shown;
    };



    // The file of a series. Readers sort it by its time steps and show one picture
    // of each: where the times of the run do not rise, as along a path, the steps
    // are the numbers of the pictures, and the time, which every picture has too,
    // is what is called the group.
    void
    write_series(const OutputFormat::Pictures &series, std::ostream &out)
    {
      const bool rises =
        std::adjacent_find(series.begin(),
                           series.end(),
                           [](const auto &one, const auto &next) {
                             return one.first >= next.first;
                           }) == series.end();
      if (rises)
        {
          dealii::DataOutBase::write_pvd_record(out, series);
          return;
        }
      out << "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"Collection\" version=\"0.1\" "
             "ByteOrder=\"LittleEndian\">\n"
             "  <Collection>\n";
      out.precision(12);
      for (unsigned int i = 0; i < series.size(); ++i)
        out << "    <DataSet timestep=\"" << i << "\" group=\"t="
            << series[i].first << "\" part=\"0\" file=\"" << series[i].second
            << "\"/>\n";
      out << "  </Collection>\n</VTKFile>\n";
    }
  } // namespace



  /**
   * VTU files for ParaView: for every time one per rank and a PVTU that joins
   * them, and solution.pvd over all times. The geometry is the reference
   * configuration; warp by the displacement. Chambers without cells are filled
   * with cells.
   */
  class Vtu : public OutputFormat
  {
  public:
    std::string
    file_name(const unsigned int number) const override;

    void
    claim(RunFolder &folder) override;

    void
    write(const State                          &state,
          const CellFields                     &fields,
          const std::vector<Obstacle::Surface> &obstacles) override;

    const Pictures &
    pictures() const override;

    void
    continue_after(const Pictures &pictures) override;

  private:
    void
    write_obstacles(const std::vector<Obstacle::Surface> &obstacles,
                    const bool                            is_first_rank) const;

    const RunFolder *folder = nullptr;
    Pictures         times_and_names;
  };



  std::string
  Vtu::file_name(const unsigned int number) const
  {
    return sub_folder + "/" + base_name(number) + ".pvtu";
  }



  void
  Vtu::claim(RunFolder &run_folder)
  {
    folder = &run_folder;
    run_folder.claim(series_name);
    run_folder.claim(obstacles_series_name);
    run_folder.claim_folder(sub_folder, [](const std::string &name) {
      return number_of(name).has_value();
    });
  }



  const OutputFormat::Pictures &
  Vtu::pictures() const
  {
    return times_and_names;
  }



  void
  Vtu::continue_after(const Pictures &pictures)
  {
    times_and_names = pictures;
    folder->on_first_rank([&]() {
      folder->remove(sub_folder, [&](const std::string &name) {
        const auto number = number_of(name);
        return number && *number >= pictures.size();
      });
    });
  }



  void
  Vtu::write(const State                          &state,
             const CellFields                     &fields,
             const std::vector<Obstacle::Surface> &obstacles)
  {
    const MixedSpace  &space   = fields.body.space;
    const MPI_Comm     comm    = space.communicator();
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(comm);
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);

    NamedDataOut                  data_out;
    dealii::DataOutBase::VtkFlags flags;
    flags.write_higher_order_cells = true;
    flags.time                     = state.time;
    // The best compression takes several times as long, and next to no less
    // room. Its type has another name in later versions of deal.II.
    using Compression       = decltype(flags.compression_level);
    flags.compression_level = Compression::best_speed;
    flags.cycle                    = times_and_names.size();
    data_out.set_flags(flags);
    data_out.attach_triangulation(space.triangulation);
    data_out.add(fields);
    data_out.build_patches(space.mapping,
                           MixedSpace::degree,
                           dealii::DataOut<dim>::curved_inner_cells);
    data_out.append(fields.filling_cells());

    const unsigned int       number = times_and_names.size();
    const std::string        whole  = file_name(number);
    std::vector<std::string> pieces;
    for (unsigned int r = 0; r < n_ranks; ++r)
      pieces.push_back(base_name(number) + "." + std::to_string(r) + ".vtu");
    folder->on_first_rank([&]() {
      std::vector<std::string> names = {whole};
      for (const std::string &piece : pieces)
        names.push_back(sub_folder + "/" + piece);
      if (!obstacles.empty())
        names.push_back(obstacles_name(number));
      folder->record().add_files(names);
    });
    folder->write_collectively(sub_folder + "/" + pieces[rank],
                               true,
                               [&](std::ostream &out) {
                                 data_out.write_vtu(out);
                               });

    times_and_names.emplace_back(state.time, whole);
    folder->write_collectively(whole, rank == 0, [&](std::ostream &out) {
      data_out.write_pvtu_record(out, pieces);
    });
    folder->write_collectively(
      series_name, rank == 0, [&](std::ostream &out) {
        write_series(times_and_names, out);
      });
    if (!obstacles.empty())
      write_obstacles(obstacles, rank == 0);
  }



  void
  Vtu::write_obstacles(const std::vector<Obstacle::Surface> &obstacles,
                       const bool is_first_rank) const
  {
    using Patch = dealii::DataOutBase::Patch<2, dim>;
    std::vector<Patch> patches;
    for (unsigned int i = 0; i < obstacles.size(); ++i)
      for (const auto &quad : obstacles[i].quads)
        {
          Patch patch;
          // Not around, but in rows.
          const unsigned int in_rows[4] = {quad[0], quad[1], quad[3], quad[2]};
          for (unsigned int v = 0; v < 4; ++v)
            patch.vertices[v] = obstacles[i].points[in_rows[v]];
          patch.reference_cell = dealii::ReferenceCells::get_hypercube<2>();
          patch.patch_index    = patches.size();
          patch.n_subdivisions = 1;
          patch.data.reinit(1, 4);
          for (unsigned int v = 0; v < 4; ++v)
            patch.data(0, v) = i + 1.;
          patches.push_back(patch);
        }
    Pictures series = times_and_names;
    for (unsigned int i = 0; i < series.size(); ++i)
      series[i].second = obstacles_name(i);
    dealii::DataOutBase::VtkFlags flags;
    flags.time = series.back().first;
    folder->write_collectively(
      series.back().second, is_first_rank, [&](std::ostream &out) {
        dealii::DataOutBase::write_vtu(
          patches, {"obstacle"}, {}, flags, out);
      });
    folder->write_collectively(
      obstacles_series_name, is_first_rank, [&](std::ostream &out) {
        write_series(series, out);
      });
  }

  static const Register<OutputFormat, Vtu>
    vtu("vtu", "VTU files and solution.pvd, for ParaView.");
} // namespace lumbricus
