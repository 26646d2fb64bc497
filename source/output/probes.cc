// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/output/probes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/mapping.h>

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
                      "to points.csv. For a point that is outside of the mesh "
                      "by less than a tenth of a cell, as on a curved surface, "
                      "those of the nearest point of the body.");
  }



  std::vector<dealii::Point<dim>>
  ProbePoints::points() const
  {
    std::vector<dealii::Point<dim>> all;
    for (const std::string &text :
         dealii::Utilities::split_string_list(list, ';'))
      {
        const std::vector<std::string> words =
          dealii::Utilities::split_string_list(text, ',');
        dealii::Point<dim> point;
        bool               is_point = words.size() == dim;
        for (unsigned int d = 0; d < dim && is_point; ++d)
          is_point = read_number(words[d], point[d]);
        AssertThrow(is_point,
                    ExcInput("Parameter 'Output/Points': '" + shortened(text) +
                             "' is not a point. Give three numbers a point, "
                             "as in '0, 0, 2; 1, 0, 2'."));
        all.push_back(point);
      }
    return all;
  }



  Probes::Probes(const std::vector<dealii::Point<dim>> &points,
                 RunFolder                             &folder,
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
      places.push_back(
        nearest_point(point, space.triangulation, space.mapping));
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



  std::string
  Probes::check(const std::vector<dealii::Point<dim>> &points,
                const MixedSpace                      &space)
  {
    std::ostringstream text;
    for (const auto &point : points)
      {
        const NearestPoint nearest =
          nearest_point(point, space.triangulation, space.mapping);
        constexpr double   farthest = 0.1;
        std::ostringstream message;
        message << "Parameter 'Output/Points': the point " << point_text(point)
                << " is not in the body. The nearest point of the mesh at rest "
                   "is "
                << point_text(nearest.position) << ", " << nearest.distance
                << " mm away, which is more than " << farthest
                << " of the cell there. Give a point of the body; with a "
                   "quarter cross-section, y and z are not negative.";
        AssertThrow(nearest.distance <= farthest * nearest.cell_size,
                    ExcInput(message.str()));
        // No more than rounding, as of a number with seven digits.
        if (nearest.distance > 1e-6 * nearest.cell_size)
          text << "The point " << point_text(point)
               << " of 'Output/Points' is outside of the mesh: the nearest "
                  "point of the body, "
               << nearest.distance << " mm away at "
               << point_text(nearest.position) << ", stands for it.\n";
      }
    return text.str();
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
