// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/anatomy.h>

#include <algorithm>

namespace lumbricus
{
  Anatomy::Anatomy()
    : geometry_choice("Shape", "segment chain", "The shape of the body.")
  {}



  void
  Anatomy::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Geometry");
    geometry_choice.declare_parameters(prm);
    prm.leave_subsection();
  }



  bool
  Anatomy::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    prm.enter_subsection("Geometry");
    bool extended = geometry_choice.extend_parameters(prm, extent);
    prm.leave_subsection();

    // The geometry's own entries have to be read before it has tissues.
    if (extended && extent == Extent::chosen)
      return true;

    std::vector<std::string> names;
    if (extent == Extent::chosen)
      for (const TissueName &tissue : geometry_choice->tissues())
        names.push_back(tissue.name);
    prm.enter_subsection("Tissues");
    extended |= tissues.extend_parameters(prm, extent, names, "<tissue>");
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
    tissues.check_parameters();
    muscles.check_parameters();
    for (const TissueName &tissue : geometry_choice->tissues())
      AssertThrow(!tissue.liquid ||
                    tissues.find(tissue.name)->muscles().empty(),
                  ExcInput("Parameter 'Tissues/" + tissue.name +
                           "/Muscles': a liquid has no fibres. Leave it empty, "
                           "and put the muscle into a tissue of the wall."));
  }



  void
  Anatomy::initialize(const double end_time)
  {
    tissue_names = geometry_choice->tissues();
    muscles_by_tissue.resize(tissue_names.size());
    for (unsigned int i = 0; i < tissue_names.size(); ++i)
      for (const std::string &name : tissue(i).muscles())
        muscles_by_tissue[i].push_back(muscles.find(name));

    const auto             sections = geometry_choice->sections();
    constexpr unsigned int n_times  = 100;
    for (unsigned int i = 0; i < muscles.size(); ++i)
      {
        muscles[i].initialize(sections.size());
        for (unsigned int step = 0; step <= n_times; ++step)
          for (unsigned int s = 0; s < sections.size(); ++s)
            muscles[i].active_stretch(end_time * step / n_times,
                                      s + 1,
                                      dealii::Point<dim>(sections[s].middle,
                                                         0.,
                                                         0.));
      }
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



  const std::vector<const Muscle *> &
  Anatomy::muscles_of(const unsigned int tissue) const
  {
    AssertIndexRange(tissue, muscles_by_tissue.size());
    return muscles_by_tissue[tissue];
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
        const double mu = tissue(i).law().shear_modulus();
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
      for (const std::string &name : tissues[i].muscles())
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
    return names;
  }
} // namespace lumbricus
