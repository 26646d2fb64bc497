// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/anatomy/stiffness_ratio.h>
#include <lumbricus/core/exceptions.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace lumbricus
{
  Anatomy::Anatomy()
    : geometry_choice("Geometry",
                      "Shape",
                      "segment chain",
                      "The shape of the body.")
  {}



  void
  Anatomy::declare_parameters(dealii::ParameterHandler &prm)
  {
    geometry_choice.declare_parameters(prm);
  }



  bool
  Anatomy::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    bool extended = geometry_choice.extend_parameters(prm, extent);

    // The geometry's own entries have to be read before it has tissues.
    if (extended && extent == Extent::chosen)
      return true;

    std::vector<std::string> names;
    std::set<std::string>    liquids;
    if (extent == Extent::chosen)
      for (const TissueName &tissue : geometry_choice->tissues())
        {
          names.push_back(tissue.name);
          if (tissue.liquid)
            liquids.insert(tissue.name);
        }
    const bool has_wall = liquids.size() < names.size();
    prm.enter_subsection("Tissues");
    extended |= tissues.extend_parameters(
      prm, extent, names, "<tissue>", [&](Tissue &tissue) {
        if (has_wall && liquids.count(tissue.name()) > 0)
          tissue.make_liquid();
      });
    prm.leave_subsection();

    prm.enter_subsection("Muscles");
    extended |=
      muscles.extend_parameters(prm, extent, all_muscle_names(), "<muscle>");
    prm.leave_subsection();
    return extended;
  }



  void
  Anatomy::check_parameters() const
  {
    geometry_choice.check_parameters();
    within_section("Tissues", [&]() { tissues.check_parameters(); });
    within_section("Muscles", [&]() { muscles.check_parameters(); });
    check_field_names();
    check_liquids();
    StiffnessRatio(*this).check();
  }



  void
  Anatomy::check_field_names() const
  {
    std::map<std::string, std::string> muscle_of_field;
    for (std::size_t i = 0; i < muscles.size(); ++i)
      {
        const std::string &name  = muscles[i].name();
        const std::string  field = muscles[i].field_name();
        const auto other = muscle_of_field.insert({field, name}).first->second;
        AssertThrow(other == name,
                    ExcParameter("Muscles/" + name,
                                 "has the fields of 'Muscles/" + other +
                                   "' in the VTU files, where both are '" +
                                   field + "'. Rename one of the muscles."));
      }
  }



  void
  Anatomy::check_liquids() const
  {
    // The stiffest tissue of the wall.
    double      wall = 0.;
    std::string wall_name;
    for (const TissueName &tissue : geometry_choice->tissues())
      {
        const double mu = tissues.find(tissue.name)->shear_modulus();
        if (!tissue.liquid && mu > wall)
          {
            wall      = mu;
            wall_name = tissue.name;
          }
      }

    for (const TissueName &name : geometry_choice->tissues())
      {
        if (!name.liquid)
          continue;
        const Tissue &liquid = *tissues.find(name.name);
        AssertThrow(liquid.muscle_names().empty(),
                    ExcParameter("Tissues/" + name.name + "/Muscles",
                                 "has to be empty: a liquid has no fibres. Put "
                                 "the muscle into a tissue of the wall."));

        AssertThrow(!liquid.has_elastic_fibres(),
                    ExcParameter("Tissues/" + name.name,
                                 "has elastic fibres, by its law or its section "
                                 "'Elastic fibres', which a liquid has not. "
                                 "Put them into a tissue of the wall."));

        AssertThrow(liquid.viscous_branches().size() == 0,
                    ExcParameter("Tissues/" + name.name,
                                 "has viscous branches, which a liquid has not: "
                                 "its pressure is all that counts. Put them "
                                 "into a tissue of the wall."));

        const double mu = liquid.shear_modulus();
        if (wall > 0. && mu > wall / 10)
          {
            std::ostringstream message;
            message << "Section '" << liquid.law_section()
                    << "': the shear modulus of the liquid, " << mu
                    << ", is more than a tenth of that of the stiffest tissue "
                       "of the wall, "
                    << wall << " ('" << wall_name
                    << "'). A liquid is a very soft rubber whose shape is "
                       "reset. Give it 1% of the wall's stiffness or less, "
                       "here a shear modulus of at most "
                    << wall / 100 << ".";
            AssertThrow(false, ExcInput(message.str()));
          }
      }
  }



  void
  Anatomy::initialize()
  {
    tissue_names = geometry_choice->tissues();
    for (std::size_t i = 0; i < tissues.size(); ++i)
      {
        std::vector<const Muscle *> named;
        for (const std::string &name : tissues[i].muscle_names())
          named.push_back(muscles.find(name));
        tissues[i].set_muscles(named);
        tissues[i].initialize("Tissues/" + tissues[i].name(), geometry());
      }
    for (unsigned int i = 0; i < muscles.size(); ++i)
      muscles[i].initialize("Muscles/" + muscles[i].name(), geometry());
  }



  void
  Anatomy::try_activations(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::vector<double>                      &times) const
  {
    // One point for each muscle and segment it is in.
    std::map<std::pair<const Muscle *, unsigned int>, dealii::Point<dim>>
      points;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const Region region = Region::of(cell->material_id());
          for (const Muscle *muscle : muscles_of(region.tissue))
            points.insert({{muscle, region.segment + 1}, cell->center()});
        }

    std::string message;
    try
      {
        for (const auto &[where, X] : points)
          for (const double t : times)
            where.first->activation(t, where.second, X);
      }
    catch (const ExcInput &exception)
      {
        message = plain_message(exception);
      }
    throw_on_all_ranks<ExcInput>(message, triangulation.get_communicator());
  }



  std::vector<LoadCurve>
  Anatomy::load_curves(
    const dealii::parallel::TriangulationBase<dim> &triangulation) const
  {
    // All ranks have all cells of the coarse mesh.
    constexpr std::size_t most_points = 5;
    std::map<std::pair<unsigned int, const Muscle *>,
             std::vector<dealii::Point<dim>>>
      centers;
    std::vector<std::pair<unsigned int, const Muscle *>> in_order;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        const Region region = Region::of(cell->material_id());
        for (const Muscle *muscle : muscles_of(region.tissue))
          {
            // Nobody knows them before.
            if (muscle->action().activation()->held_values() != nullptr)
              continue;
            auto &points = centers[{region.segment + 1, muscle}];
            if (points.empty())
              in_order.push_back({region.segment + 1, muscle});
            points.push_back(cell->center());
          }
      }

    std::vector<LoadCurve> curves;
    for (const auto &where : in_order)
      curves.push_back(
        where.second->load_curve(where.first,
                                 some_of(centers[where], most_points)));
    return curves;
  }



  const Geometry &
  Anatomy::geometry() const
  {
    return *geometry_choice;
  }



  const Tissue &
  Anatomy::tissue(const unsigned int i) const
  {
    AssertIndexRange(i, tissue_names.size());
    return *tissues.find(tissue_names[i].name);
  }



  const Tissue &
  Anatomy::tissue(const std::string &name) const
  {
    return *tissues.find(name);
  }



  bool
  Anatomy::is_liquid(const unsigned int tissue) const
  {
    AssertIndexRange(tissue, tissue_names.size());
    return tissue_names[tissue].liquid;
  }



  bool
  Anatomy::has_liquid() const
  {
    return std::any_of(tissue_names.begin(),
                       tissue_names.end(),
                       [](const TissueName &tissue) { return tissue.liquid; });
  }



  bool
  Anatomy::liquids_may_flow() const
  {
    bool may = true;
    for (unsigned int i = 0; i < tissue_names.size(); ++i)
      may = may && (!is_liquid(i) || (tissue(i).law().may_flow() &&
                                      !tissue(i).has_elastic_fibres()));
    return may;
  }



  const std::vector<const Muscle *> &
  Anatomy::muscles_of(const unsigned int tissue) const
  {
    return this->tissue(tissue).muscles();
  }



  unsigned int
  Anatomy::n_viscous_branches() const
  {
    std::size_t most = 0;
    for (unsigned int i = 0; i < tissue_names.size(); ++i)
      most = std::max(most, tissue(i).viscous_branches().size());
    return most;
  }



  unsigned int
  Anatomy::n_muscles() const
  {
    return muscles.size();
  }



  const Muscle &
  Anatomy::muscle(const unsigned int i) const
  {
    return muscles[i];
  }



  double
  Anatomy::wall_stiffness() const
  {
    double wall = 0., any = 0.;
    for (unsigned int i = 0; i < tissue_names.size(); ++i)
      {
        const double mu = tissue(i).shear_modulus();
        any             = std::max(any, mu);
        if (!is_liquid(i))
          wall = std::max(wall, mu);
      }
    return wall > 0. ? wall : any;
  }



  std::vector<std::string>
  Anatomy::all_muscle_names() const
  {
    std::vector<std::string> names;
    for (unsigned int i = 0; i < tissues.size(); ++i)
      for (const std::string &name : tissues[i].muscle_names())
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
    return names;
  }
} // namespace lumbricus
