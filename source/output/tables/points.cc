// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/mapping.h>

#include <sstream>

#include "../nearest_point.h"

namespace lumbricus
{
  /** Displacement, stress and volume at material points that the user names: a
   * row per load step and point. */
  class PointsTable : public Table
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    bool
    is_wanted() const override;

    std::vector<std::string>
    columns() const override;

    /** A point that is not in the body stands for the nearest point of the body
     * if that is no further than a tenth of the longest edge of the cell it is
     * in: curved surfaces are not where formulas say. */
    std::string
    check(const MixedSpace &space) const override;

    void
    reinit(const MixedSpace &space) override;

    void
    write(TableRows &rows, const OutputContext &context) const override;

  private:
    /** The reference positions [mm]. Throws ExcInput. */
    std::vector<dealii::Point<dim>>
    points() const;

    std::string                     list;
    std::vector<dealii::Point<dim>> asked_for; ///< in list
    std::vector<NearestPoint>       places;    ///< of these
  };



  void
  PointsTable::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Points",
                      list,
                      "[mm] Material points 'x, y, z' at rest, separated by "
                      "semicolons, whose displacement and stress are written "
                      "to points.csv. For a point that is outside of the mesh "
                      "by less than a tenth of a cell, as on a curved surface, "
                      "those of the nearest point of the body.");
  }



  void
  PointsTable::check_parameters() const
  {
    points();
  }



  bool
  PointsTable::is_wanted() const
  {
    return !points().empty();
  }



  std::vector<std::string>
  PointsTable::columns() const
  {
    std::vector<std::string> all = {
      "t", "point", "x", "y", "z", "ux", "uy", "uz", "pressure"};
    for (const std::string row : {"x", "y", "z"})
      for (const std::string column : {"x", "y", "z"})
        all.push_back("s" + row + column);
    all.push_back("J");
    return all;
  }



  std::string
  PointsTable::check(const MixedSpace &space) const
  {
    std::ostringstream text;
    for (const auto &point : points())
      {
        const NearestPoint nearest =
          nearest_point(point, space.triangulation, space.mapping);
        constexpr double   farthest = 0.1;
        std::ostringstream message;
        message << ": the point " << point_text(point)
                << " is not in the body. The nearest point of the mesh at rest "
                   "is "
                << point_text(nearest.position) << ", " << nearest.distance
                << " mm away, which is more than " << farthest
                << " of the cell there. Give a point of the body; with a "
                   "quarter cross-section, y and z are not negative.";
        AssertThrow(nearest.distance <= farthest * nearest.cell_size,
                    ExcInput(about_parameter("Output/Points", message.str())));
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
  PointsTable::reinit(const MixedSpace &space)
  {
    asked_for = points();
    places.clear();
    for (const auto &point : asked_for)
      places.push_back(
        nearest_point(point, space.triangulation, space.mapping));
  }



  void
  PointsTable::write(TableRows &rows, const OutputContext &context) const
  {
    const CellFields &fields      = context.fields();
    const auto       &dof_handler = fields.dof_handler();
    const auto       &fe          = dof_handler.get_fe();
    std::vector<dealii::types::global_dof_index> indices(fe.n_dofs_per_cell());

    // Which column a component is in, from ux on.
    constexpr unsigned int    n_columns = dim + 1 + dim * dim + 1;
    std::vector<unsigned int> column_of(fe.n_components(), n_columns);
    unsigned int              next = 0;
    for (const std::string name :
         {"displacement", "pressure", "cauchy_stress", "J"})
      for (const unsigned int component : fields.components(name))
        column_of[component] = next++;

    std::vector<double> values(places.size() * n_columns, 0.);
    for (unsigned int k = 0; k < places.size(); ++k)
      {
        if (!places[k].mine)
          continue;
        same_cell(places[k].cell, dof_handler)->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          {
            const unsigned int column =
              column_of[fe.system_to_component_index(i).first];
            if (column < n_columns)
              values[k * n_columns + column] +=
                fields.values()(indices[i]) *
                fe.shape_value(i, places[k].unit_point);
          }
      }
    dealii::Utilities::MPI::sum(values,
                                context.body.space.communicator(),
                                values);

    for (unsigned int k = 0; k < places.size(); ++k)
      {
        rows << context.state.time << k + 1;
        for (unsigned int i = 0; i < dim; ++i)
          rows << asked_for[k][i];
        for (unsigned int i = 0; i < n_columns; ++i)
          rows << values[k * n_columns + i];
        rows.end_row();
      }
  }



  std::vector<dealii::Point<dim>>
  PointsTable::points() const
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
                    ExcInput(about_parameter(
                      "Output/Points",
                      ": '" + shortened(text) +
                        "' is not a point. Give three numbers a point, as in "
                        "'0, 0, 2; 1, 0, 2'.")));
        all.push_back(point);
      }
    return all;
  }

  static const Register<Table, PointsTable>
    points_table("points", "the fields at the material points of 'Points'.");
} // namespace lumbricus
