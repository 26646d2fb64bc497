// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/terms/body_forces.h>
#include <lumbricus/terms/tried_expressions.h>

#include <algorithm>
#include <string>
#include <vector>

namespace lumbricus
{
  void
  NamedBodyForce::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Tissues",
                      tissues,
                      "The tissues on which it acts; none for all that are "
                      "not liquid.",
                      NameList());
    NamedTerm::declare_parameters(prm);
  }



  void
  NamedBodyForce::check_parameters() const
  {
    check_no_name_twice("Tissues", tissues);
    NamedTerm::check_parameters();
  }



  void
  NamedBodyForce::initialize(const std::string &section,
                             const Geometry    &geometry)
  {
    NamedTerm::initialize(section, geometry);

    const std::vector<TissueName> known = geometry.tissues();
    std::vector<std::string>      solid;
    for (const TissueName &tissue : known)
      if (!tissue.liquid)
        solid.push_back(tissue.name);

    const auto wrong = [&](const std::string &what) {
      return ExcParameter(section + "/Tissues",
                          what + " Give some of " + quoted_list(solid) + ".");
    };
    for (const std::string &name : tissues)
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
                          "', which is a liquid: the mesh inside it does not "
                          "go with its points."));
      }
    acts_in.clear();
    for (const TissueName &tissue : known)
      acts_in.push_back(
        !tissue.liquid &&
        (tissues.empty() ||
         std::count(tissues.begin(), tissues.end(), tissue.name) > 0));
  }



  BodyForces::BodyForces()
    : Section("Body forces",
              "Names",
              "<body force>",
              "The forces on all points of tissues in this run, names of your "
              "own, each with a section of that name here.")
  {}



  void
  BodyForces::initialize(const Geometry &geometry)
  {
    for (unsigned int i = 0; i < size(); ++i)
      (*this)[i].initialize(section_name() + "/" + force(i).name, geometry);
  }



  void
  BodyForces::try_expressions(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::vector<double>                      &times) const
  {
    if (n_forces() == 0)
      return;

    std::string message;
    for (unsigned int i = 0; i < n_forces() && message.empty(); ++i)
      {
        std::vector<dealii::Point<dim>> points;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() &&
              force(i).acts_in[Region::of(cell->material_id()).tissue])
            points.push_back(cell->center());
        message = value_that_is_not_finite(force(i).type_section,
                                           force(i).type->expressions(),
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
    for (unsigned int i = 0; i < n_forces(); ++i)
      {
        // All ranks have all cells of the coarse mesh.
        std::vector<dealii::Point<dim>> centers;
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          if (force(i).acts_in[Region::of(cell->material_id()).tissue])
            centers.push_back(cell->center());
        for (const Expression &expression : force(i).type->expressions())
          curves.push_back(curve_of(force(i).type_section,
                                    expression,
                                    some_of(centers, most_points)));
      }
    return curves;
  }



  unsigned int
  BodyForces::n_forces() const
  {
    return size();
  }



  const NamedBodyForce &
  BodyForces::force(const unsigned int i) const
  {
    return (*this)[i];
  }



  bool
  BodyForces::symmetric() const
  {
    for (unsigned int i = 0; i < n_forces(); ++i)
      if (!force(i).type->symmetric())
        return false;
    return true;
  }
} // namespace lumbricus
