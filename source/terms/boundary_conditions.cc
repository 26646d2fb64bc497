// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/terms/boundary_conditions.h>
#include <lumbricus/terms/tried_expressions.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // The conditions at a boundary, often none.
    const std::vector<unsigned int> &
    at_boundary(const std::map<dealii::types::boundary_id,
                               std::vector<unsigned int>> &conditions,
                const dealii::types::boundary_id           id)
    {
      static const std::vector<unsigned int> none;
      const auto                             found = conditions.find(id);
      return found == conditions.end() ? none : found->second;
    }
  } // namespace



  void
  NamedCondition::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Boundary",
                      boundary_name,
                      "The name of the boundary; each shape has its own.");
    NamedTerm::declare_parameters(prm);
  }



  void
  NamedCondition::initialize(const std::string &section,
                             const Geometry    &geometry)
  {
    NamedTerm::initialize(section, geometry);

    const std::string inside = geometry.inside_of_body(boundary_name);
    const std::vector<std::string> known = geometry.boundary_names();
    AssertThrow(inside.empty(),
                ExcParameter(section + "/Boundary",
                             "is '" + boundary_name + "', which " + inside +
                               ". Loads and supports act at the boundary of "
                               "the body. Give one of " +
                               quoted_list(known) + "."));
    const auto place = std::find(known.begin(), known.end(), boundary_name);
    AssertThrow(place != known.end(),
                ExcParameter(section + "/Boundary",
                             "is '" + boundary_name +
                               "', but this shape has no such boundary. Give "
                               "one of " +
                               quoted_list(known) + "."));
    boundary = place - known.begin();
  }



  const SurfaceTerm *
  NamedCondition::surface_term() const
  {
    return dynamic_cast<const SurfaceTerm *>(type.get());
  }



  const PrescribedDisplacement *
  NamedCondition::prescribed_displacement() const
  {
    return dynamic_cast<const PrescribedDisplacement *>(type.get());
  }



  BoundaryConditions::BoundaryConditions()
    : Section("Boundary conditions",
              "Names",
              "<load or support>",
              "The loads and supports of this run, names of your own, each "
              "with a section of that name here.")
  {}



  void
  BoundaryConditions::declare_parameters(dealii::ParameterHandler &prm)
  {
    Section::declare_parameters(prm);
    prm.enter_subsection(section_name());
    prm.add_parameter("Minimal support",
                      hold_rigid_motions,
                      "Whether to hold the rigid motions that nothing else "
                      "holds at three points of the body. This puts no stress "
                      "into a body whose loads are in balance.");
    prm.leave_subsection();
  }



  void
  BoundaryConditions::initialize(const Geometry &geometry)
  {
    std::set<std::pair<dealii::types::boundary_id, unsigned int>> prescribed;
    for (unsigned int i = 0; i < size(); ++i)
      {
        NamedCondition   &condition = (*this)[i];
        const std::string section   = section_name() + "/" + condition.name;
        condition.initialize(section, geometry);

        if (condition.surface_term() != nullptr)
          surface_terms[condition.boundary].push_back(i);
        if (condition.prescribed_displacement() == nullptr)
          continue;
        prescribed_displacements[condition.boundary].push_back(i);
        const auto components =
          condition.prescribed_displacement()->components();
        for (unsigned int c = 0; c < dim; ++c)
          AssertThrow(!components[c] ||
                        prescribed.insert({condition.boundary, c}).second,
                      ExcInput("Section '" + section +
                               "': the displacement along " + "xyz"[c] +
                               " of boundary '" + condition.boundary_name +
                               "' is prescribed twice. Remove one of the two "
                               "conditions, or its component."));
      }
  }



  void
  BoundaryConditions::try_expressions(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::vector<double>                      &times) const
  {
    if (size() == 0)
      return;

    std::map<dealii::types::boundary_id, std::vector<dealii::Point<dim>>>
      centers;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            centers[face->boundary_id()].push_back(face->center(true));

    std::string message;
    for (unsigned int i = 0; i < size() && message.empty(); ++i)
      message = value_that_is_not_finite(condition(i).type_section,
                                         condition(i).type->expressions(),
                                         centers[condition(i).boundary],
                                         times,
                                         "on the whole boundary");
    throw_on_all_ranks<ExcInput>(message, triangulation.get_communicator());
  }



  unsigned int
  BoundaryConditions::n_conditions() const
  {
    return size();
  }



  const NamedCondition &
  BoundaryConditions::condition(const unsigned int i) const
  {
    return (*this)[i];
  }



  void
  BoundaryConditions::set_scales(
    const std::map<dealii::types::boundary_id, SurfaceScale> &scales)
  {
    for (const auto &[boundary, scale] : scales)
      for (const unsigned int i : surface_terms_on(boundary))
        dynamic_cast<SurfaceTerm &>(*(*this)[i].type.get()).set_scale(scale);
  }



  std::vector<LoadCurve>
  BoundaryConditions::load_curves(
    const dealii::parallel::TriangulationBase<dim> &triangulation) const
  {
    // All ranks have all cells of the coarse mesh.
    constexpr std::size_t most_points = 5;
    std::map<dealii::types::boundary_id, std::vector<dealii::Point<dim>>>
      centers;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          centers[face->boundary_id()].push_back(face->center(true));

    std::vector<LoadCurve> curves;
    for (unsigned int i = 0; i < size(); ++i)
      {
        const auto points =
          some_of(centers[condition(i).boundary], most_points);
        if (condition(i).surface_term() != nullptr)
          for (const Expression &expression : condition(i).type->expressions())
            {
              curves.push_back(
                curve_of(condition(i).type_section, expression, points));
              if (condition(i).type->is_there_at_rest() && !points.empty())
                curves.back().at_rest = expression.value(points.front(), 0.);
            }
        const auto *prescribed = condition(i).prescribed_displacement();
        for (unsigned int c = 0; c < dim; ++c)
          if (prescribed != nullptr && prescribed->components()[c])
            {
              LoadCurve curve;
              curve.what = "the displacement of '" + section_name() + "/" +
                           condition(i).name + "'";
              curve.where = std::string(" along ") + "xyz"[c];
              for (const dealii::Point<dim> &X : points)
                curve.values.push_back([prescribed, c, X](const double t) {
                  return prescribed->value(c, X, t);
                });
              curves.push_back(curve);
            }
      }
    return curves;
  }



  const std::vector<unsigned int> &
  BoundaryConditions::surface_terms_on(
    const dealii::types::boundary_id id) const
  {
    return at_boundary(surface_terms, id);
  }



  const std::vector<unsigned int> &
  BoundaryConditions::prescribed_displacements_on(
    const dealii::types::boundary_id id) const
  {
    return at_boundary(prescribed_displacements, id);
  }



  bool
  BoundaryConditions::minimal_support() const
  {
    return hold_rigid_motions;
  }
} // namespace lumbricus
