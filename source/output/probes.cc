// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/output/probes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // What is written of a point, the first of CellFields: displacement,
    // pressure, stress, J.
    constexpr unsigned int n_values = dim + 1 + dim * dim + 1;
  } // namespace



  void
  ProbePoints::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Points",
                      list,
                      "[mm] Material points 'x, y, z' at rest, separated by "
                      "semicolons, whose displacement and stress are written "
                      "to points.csv.");
  }



  std::vector<dealii::Point<dim>>
  ProbePoints::points() const
  {
    std::vector<dealii::Point<dim>> all;
    for (const std::string &text :
         dealii::Utilities::split_string_list(list, ';'))
      try
        {
          const auto coordinates = dealii::Utilities::string_to_double(
            dealii::Utilities::split_string_list(text, ','));
          AssertThrow(coordinates.size() == dim &&
                        std::all_of(coordinates.begin(),
                                    coordinates.end(),
                                    [](const double x) {
                                      return std::isfinite(x);
                                    }),
                      dealii::ExcMessage("not three numbers"));
          all.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
        }
      catch (const dealii::ExceptionBase &)
        {
          AssertThrow(false,
                      ExcInput("Parameter 'Output/Points': '" + text +
                               "' is not a point. Give three numbers a point, "
                               "as in '0, 0, 2; 1, 0, 2'."));
        }
    return all;
  }



  Probes::Probes(const std::vector<dealii::Point<dim>> &points,
                 const RunFolder                       &folder,
                 const MixedSpace                      &space,
                 const CellFields                      &cell_fields)
    : points(points)
    , space(space)
    , cell_fields(cell_fields)
  {
    if (empty())
      return;
    reinit();
    std::vector<std::string> columns = {
      "t", "point", "x", "y", "z", "ux", "uy", "uz", "pressure"};
    for (const std::string row : {"x", "y", "z"})
      for (const std::string column : {"x", "y", "z"})
        columns.push_back("s" + row + column);
    columns.push_back("J");
    table = std::make_unique<CsvTable>(folder,
                                       "points.csv",
                                       columns,
                                       space.communicator());
  }



  void
  Probes::reinit()
  {
    places.clear();
    for (const auto &point : points)
      places.push_back(find(point, space));
  }



  bool
  Probes::empty() const
  {
    return points.empty();
  }



  const CsvTable *
  Probes::csv_table() const
  {
    return table.get();
  }



  void
  Probes::check(const std::vector<dealii::Point<dim>> &points,
                const MixedSpace                      &space)
  {
    for (const auto &point : points)
      find(point, space);
  }



  Probes::Place
  Probes::find(const dealii::Point<dim> &point, const MixedSpace &space)
  {
    Place  best;
    double least = std::numeric_limits<double>::max();
    for (const auto &cell : space.triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        if (cell->center().distance(point) > cell->diameter())
          continue;
        try
          {
            const auto unit =
              space.mapping.transform_real_to_unit_cell(cell, point);
            const double distance =
              dealii::GeometryInfo<dim>::distance_to_unit_cell(unit);
            if (distance < least)
              {
                least           = distance;
                best.cell       = cell;
                best.unit_point = unit;
              }
          }
        catch (const dealii::Mapping<dim>::ExcTransformationFailed &)
          {
            // So far outside that the map cannot be inverted there.
          }
      }

    const auto nearest =
      dealii::Utilities::MPI::min_max_avg(least, space.communicator());
    std::ostringstream message;
    message << "Parameter 'Output/Points': the point " << point_text(point)
            << " is not in the body. Give a point of the mesh at rest; with a "
               "quarter cross-section, y and z are not negative.";
    AssertThrow(nearest.min < 1e-6, ExcInput(message.str()));
    best.mine = nearest.min_index ==
                dealii::Utilities::MPI::this_mpi_process(space.communicator());
    return best;
  }



  void
  Probes::write(const State &state)
  {
    if (empty())
      return;
    const auto &fields = cell_fields.dof_handler();
    const auto &fe     = fields.get_fe();
    std::vector<dealii::types::global_dof_index> indices(fe.n_dofs_per_cell());

    std::vector<double> values(points.size() * n_values, 0.);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        if (!places[k].mine)
          continue;
        same_cell(places[k].cell, fields)->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          {
            const unsigned int c = fe.system_to_component_index(i).first;
            if (c < n_values)
              values[k * n_values + c] +=
                cell_fields.values()(indices[i]) *
                fe.shape_value(i, places[k].unit_point);
          }
      }
    dealii::Utilities::MPI::sum(values, space.communicator(), values);

    for (unsigned int k = 0; k < points.size(); ++k)
      {
        *table << state.time << k + 1;
        for (unsigned int i = 0; i < dim; ++i)
          *table << points[k][i];
        for (unsigned int i = 0; i < n_values; ++i)
          *table << values[k * n_values + i];
        table->end_row();
      }
    table->flush();
  }
} // namespace lumbricus
