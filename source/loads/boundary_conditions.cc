// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/loads/boundary_conditions.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace lumbricus
{
  namespace
  {
    const std::string section = "Boundary conditions";



    std::string
    quoted_list(const std::vector<std::string> &names)
    {
      std::string all;
      for (const std::string &name : names)
        all += (all.empty() ? "'" : ", '") + name + "'";
      return all;
    }



    // Try the expressions of a condition over the time of the run.
    void
    check_values(const NamedCondition     &condition,
                 const dealii::Point<dim> &X,
                 const double              end_time)
    {
      constexpr unsigned int n_times = 100;
      for (const Expression &expression : condition.type->expressions())
        for (unsigned int step = 0; step <= n_times; ++step)
          {
            const double t     = end_time * step / n_times;
            const double value = expression.value(X, t);
            if (!std::isfinite(value))
              {
                std::ostringstream message;
                message << "Section '" << section << "/" << condition.name
                        << "': the expression '" << expression.formula()
                        << "' is " << value << " at time " << t
                        << ". It has to be a number from time 0 to the end.";
                AssertThrow(false, ExcInput(message.str()));
              }
          }
    }
  } // namespace



  NamedCondition::NamedCondition(const std::string &name)
    : name(name)
    , type("Type", "", "What acts there.")
  {}



  void
  NamedCondition::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Boundary",
                      boundary_name,
                      "The name of the boundary; each shape has its own.");
    type.declare_parameters(prm);
  }



  bool
  NamedCondition::extend_parameters(dealii::ParameterHandler &prm,
                                    const Extent              extent)
  {
    return type.extend_parameters(prm, extent);
  }



  void
  NamedCondition::check_parameters() const
  {
    AssertThrow(type.get() != nullptr,
                ExcInput("Parameter '" + section + "/" + name +
                         "/Type' is not set. Set it to one of " +
                         Registry<BoundaryCondition>::names() + "."));
    type.check_parameters();
  }



  void
  BoundaryConditions::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    prm.add_parameter("Names",
                      names,
                      "The loads and supports of this run, names of your "
                      "own, each with a section of that name here.");
    prm.add_parameter("Minimal support",
                      hold_rigid_motions,
                      "Whether to hold the rigid motions that nothing else "
                      "holds at three points of the body. This puts no stress "
                      "into a body whose loads are in balance.");
    prm.leave_subsection();
  }



  bool
  BoundaryConditions::extend_parameters(dealii::ParameterHandler &prm,
                                        const Extent              extent)
  {
    prm.enter_subsection(section);
    const bool extended =
      conditions.extend_parameters(prm, extent, names, "<load or support>");
    prm.leave_subsection();
    return extended;
  }



  void
  BoundaryConditions::check_parameters() const
  {
    conditions.check_parameters();
  }



  void
  BoundaryConditions::initialize(const Geometry &geometry,
                                 const double    end_time)
  {
    const std::vector<std::string> known = geometry.boundary_names();

    std::set<std::pair<dealii::types::boundary_id, unsigned int>> prescribed;
    for (unsigned int i = 0; i < conditions.size(); ++i)
      {
        NamedCondition &condition = conditions[i];
        const auto      place =
          std::find(known.begin(), known.end(), condition.boundary_name);
        AssertThrow(place != known.end(),
                    ExcInput("Parameter '" + section + "/" + condition.name +
                             "/Boundary': there is no boundary '" +
                             condition.boundary_name + "'. This shape has " +
                             quoted_list(known) + "."));
        condition.boundary = place - known.begin();
        condition.type.get()->initialize(section + "/" + condition.name + "/" +
                                         condition.type.chosen_name());
        check_values(condition, geometry.support_points()[0], end_time);

        const auto components = condition.type->prescribed_components();
        for (unsigned int c = 0; c < dim; ++c)
          AssertThrow(!components[c] ||
                        prescribed.insert({condition.boundary, c}).second,
                      ExcInput("Section '" + section + "/" + condition.name +
                               "': the displacement along " + "xyz"[c] +
                               " of boundary '" + condition.boundary_name +
                               "' is prescribed twice. Remove one of the two "
                               "conditions, or its component."));
      }
  }



  std::vector<const BoundaryCondition *>
  BoundaryConditions::on_boundary(const dealii::types::boundary_id id) const
  {
    std::vector<const BoundaryCondition *> found;
    for (unsigned int i = 0; i < conditions.size(); ++i)
      if (conditions[i].boundary == id)
        found.push_back(&*conditions[i].type);
    return found;
  }



  bool
  BoundaryConditions::minimal_support() const
  {
    return hold_rigid_motions;
  }



  bool
  BoundaryConditions::symmetric() const
  {
    for (unsigned int i = 0; i < conditions.size(); ++i)
      if (!conditions[i].type->symmetric())
        return false;
    return true;
  }
} // namespace lumbricus
