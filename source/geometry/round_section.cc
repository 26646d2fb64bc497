// SPDX-License-Identifier: LGPL-2.1-or-later
#include "round_section.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <set>

namespace lumbricus
{
  namespace Patterns = dealii::Patterns;

  RoundSection::RoundSection(const std::string              &path,
                             const std::vector<std::string> &reserved)
    : path(path)
    , reserved(reserved)
  {}



  void
  RoundSection::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Wall layers",
      layers,
      "[names] The tissues the wall is made of, from inside to outside, "
      "separated by commas. Each layer is a tissue of its own, with its own "
      "law and muscle.",
      Patterns::List(Name(), 1, 64));
    prm.add_parameter(
      "Cross-section",
      part,
      "[full, half or quarter] How much of the circle is computed: all of "
      "it, the half y >= 0, or the quarter y >= 0, z >= 0. The cut planes are "
      "planes of mirror symmetry, so loads and fibres have to be symmetric to "
      "them: helical fibres are not.",
      Patterns::Selection("full|half|quarter"));
    prm.add_parameter("Cells around a quarter",
                      n_around_quarter,
                      "[number, even] Cells around a quarter of the circle.",
                      Patterns::Integer(2));
    prm.add_parameter("Cells across the liquid",
                      n_disk_rings,
                      "[number] Cells along a radius of the inner disk, from "
                      "the square core in its middle to the wall. The core has "
                      "half as many cells along an edge of its quarter as "
                      "there are cells around that quarter.",
                      Patterns::Integer(1));
    prm.add_parameter("Cells across each wall layer",
                      n_layer_cells,
                      "[number] Cells through the thickness of every layer of "
                      "the wall.",
                      Patterns::Integer(1));
  }



  void
  RoundSection::check_parameters() const
  {
    std::set<std::string> taken(reserved.begin(), reserved.end());
    for (const std::string &layer : layers)
      AssertThrow(taken.insert(layer).second,
                  ExcInput(about_parameter(
                    path + "/Wall layers",
                    ": the name '" + layer +
                      "' is already that of another tissue of this body. Give "
                      "every layer a name of its own.")));
    check_even(
      path,
      "Cells around a quarter",
      n_around_quarter,
      "half of them lie along each of the two outer edges of the core");
  }



  void
  RoundSection::check_thicknesses(const std::string &where,
                                  const unsigned int n_thicknesses) const
  {
    AssertThrow(n_thicknesses == layers.size(),
                ExcInput(about_parameter(
                  where + "/Wall layer thicknesses",
                  "has " + std::to_string(n_thicknesses) +
                    " entries, but '" + path + "/Wall layers' has " +
                    std::to_string(layers.size()) +
                    ". Give one thickness for every layer.")));
  }



  double
  RoundSection::n_cells(const bool filled) const
  {
    const double around = n_around_quarter;
    const double core   = around / 2 * around / 2;
    const double rings  = double(n_layers()) * n_layer_cells;
    return (part == "full" ? 4 :
            part == "half" ? 2 :
                             1) *
           (around * rings + (filled ? core + around * n_disk_rings : 0.));
  }



  CrossSection
  RoundSection::cross_section(const bool filled) const
  {
    const auto which = part == "full" ? CrossSection::Part::full :
                       part == "half" ? CrossSection::Part::half :
                                        CrossSection::Part::quarter;
    return CrossSection(which,
                        n_around_quarter,
                        filled,
                        n_disk_rings,
                        std::vector<unsigned int>(n_layers(), n_layer_cells));
  }



  std::vector<double>
  RoundSection::ring_radii(const double               radius,
                           const std::vector<double> &thicknesses)
  {
    std::vector<double> radii = {radius};
    for (const double thickness : thicknesses)
      radii.push_back(radii.back() + thickness);
    return radii;
  }



  void
  RoundSection::append_layers(std::vector<TissueName> &tissues) const
  {
    for (const std::string &layer : layers)
      tissues.push_back({layer, false, true});
  }



  std::vector<SymmetryPlane>
  RoundSection::symmetry_planes(const unsigned int first) const
  {
    std::vector<SymmetryPlane> planes;
    if (part != "full")
      planes.push_back({symmetry_boundary(BodySurface::symmetry_y, first), 1});
    if (part == "quarter")
      planes.push_back({symmetry_boundary(BodySurface::symmetry_z, first), 2});
    return planes;
  }



  dealii::types::boundary_id
  RoundSection::symmetry_boundary(const BodySurface  surface,
                                  const unsigned int first)
  {
    Assert(surface == BodySurface::symmetry_y ||
             surface == BodySurface::symmetry_z,
           dealii::ExcInternalError());
    return surface == BodySurface::symmetry_y ? first : first + 1;
  }



  void
  RoundSection::check_even(const std::string &path,
                           const std::string &name,
                           const unsigned int n,
                           const std::string &reason)
  {
    AssertThrow(n % 2 == 0,
                ExcInput(about_parameter(path + "/" + name,
                                         "is " + std::to_string(n) +
                                           ", but has to be even: " + reason +
                                           ".")));
  }
} // namespace lumbricus
