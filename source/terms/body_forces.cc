// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/terms/body_forces.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tried_expressions.h"

namespace lumbricus
{
  namespace
  {
    const std::string own_section = "Body forces";
  } // namespace



  NamedBodyForce::NamedBodyForce(const std::string &name)
    : name(name)
    , type("Type", "", "What acts there.")
  {}



  void
  NamedBodyForce::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Tissues",
                      tissues,
                      "The tissues on which it acts; none for all that are "
                      "not liquid.",
                      NameList());
    type.declare_parameters(prm);
  }



  bool
  NamedBodyForce::extend_parameters(dealii::ParameterHandler &prm,
                                    const Extent              extent)
  {
    return type.extend_parameters(prm, extent);
  }



  void
  NamedBodyForce::check_parameters() const
  {
    check_no_name_twice("Tissues", tissues);
    AssertThrow(type.get() != nullptr,
                ExcParameter("Type",
                             "is not set. Set it to one of " +
                               Registry<VolumeTerm>::quoted_names() + "."));
    type.check_parameters();
  }



  void
  BodyForces::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(own_section);
    prm.add_parameter("Names",
                      names,
                      "The forces on all points of tissues in this run, names "
                      "of your own, each with a section of that name here.",
                      NameList());
    prm.leave_subsection();
  }



  bool
  BodyForces::extend_parameters(dealii::ParameterHandler &prm,
                                const Extent              extent)
  {
    prm.enter_subsection(own_section);
    const bool extended =
      forces.extend_parameters(prm, extent, names, "<body force>");
    prm.leave_subsection();
    return extended;
  }



  void
  BodyForces::check_parameters() const
  {
    within_section(own_section, [&]() {
      check_no_name_twice("Names", names);
      forces.check_parameters();
    });
  }



  void
  BodyForces::initialize(const Geometry &geometry)
  {
    const std::vector<TissueName> known = geometry.tissues();
    std::vector<std::string>      solid;
    for (const TissueName &tissue : known)
      if (!tissue.liquid)
        solid.push_back(tissue.name);

    for (unsigned int i = 0; i < forces.size(); ++i)
      {
        NamedBodyForce &force = forces[i];
        const auto      wrong = [&](const std::string &what) {
          return ExcParameter(own_section + "/" + force.name + "/Tissues",
                              what + " Give some of " + quoted_list(solid) +
                                ".");
        };
        for (const std::string &name : force.tissues)
          {
            const auto tissue =
              std::find_if(known.begin(), known.end(), [&](const auto &other) {
                return other.name == name;
              });
            AssertThrow(tissue != known.end(),
                        wrong("has '" + name +
                              "', but this shape has no such tissue."));
            AssertThrow(!tissue->liquid,
                        wrong("has '" + name +
                              "', which is a liquid: the mesh inside it does "
                              "not go with its points."));
          }
        force.acts_in.clear();
        for (const TissueName &tissue : known)
          force.acts_in.push_back(
            !tissue.liquid &&
            (force.tissues.empty() ||
             std::count(force.tissues.begin(),
                        force.tissues.end(),
                        tissue.name) > 0));
        force.type.get()->initialize(own_section + "/" + force.name + "/" +
                                     force.type.chosen_name());
      }
  }



  void
  BodyForces::try_expressions(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::vector<double>                      &times) const
  {
    if (forces.size() == 0)
      return;

    std::string message;
    for (unsigned int i = 0; i < forces.size() && message.empty(); ++i)
      {
        std::vector<dealii::Point<dim>> points;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() &&
              forces[i].acts_in[Region::of(cell->material_id()).tissue])
            points.push_back(cell->center());
        message = value_that_is_not_finite(forces[i].type->expressions(),
                                           points,
                                           times,
                                           "in all of these tissues");
      }
    throw_on_all_ranks<ExcInput>(message, triangulation.get_communicator());
  }



  std::vector<LoadCurve>
  BodyForces::load_curves(
    const dealii::parallel::TriangulationBase<dim> &triangulation) const
  {
    constexpr std::size_t  most_points = 5;
    std::vector<LoadCurve> curves;
    for (unsigned int i = 0; i < forces.size(); ++i)
      {
        // All ranks have all cells of the coarse mesh.
        std::vector<dealii::Point<dim>> centers;
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          if (forces[i].acts_in[Region::of(cell->material_id()).tissue])
            centers.push_back(cell->center());
        for (const Expression &expression : forces[i].type->expressions())
          curves.push_back(
            curve_of(expression, some_of(centers, most_points)));
      }
    return curves;
  }



  unsigned int
  BodyForces::n_forces() const
  {
    return forces.size();
  }



  const NamedBodyForce &
  BodyForces::force(const unsigned int i) const
  {
    return forces[i];
  }



  bool
  BodyForces::symmetric() const
  {
    for (unsigned int i = 0; i < forces.size(); ++i)
      if (!forces[i].type->symmetric())
        return false;
    return true;
  }
} // namespace lumbricus
