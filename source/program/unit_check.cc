// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/program/unit_check.h>

#include <sstream>

namespace lumbricus
{
  namespace
  {
    struct Units
    {
      std::string name;
      std::string length_unit;
      double      metre; ///< in the unit of length
      std::string stress_unit;
      double      pascal; ///< in the unit of stress
    };

    const Units known[] = {{"mm, N, MPa", "mm", 1e3, "MPa", 1e-6},
                           {"m, N, Pa", "m", 1., "Pa", 1.}};

    // What no body and no tissue is.
    constexpr double shortest = 1e-5, longest = 1.; // m
    constexpr double softest = 1., stiffest = 8e10; // Pa; steel
  }                                                 // namespace



  void
  UnitCheck::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Units",
      units,
      "The units of the input, only to warn where a number looks like one in "
      "others; 'other' for no warnings. Units in this list are those of the "
      "first choice.",
      dealii::Patterns::Selection("mm, N, MPa|m, N, Pa|other"));
  }



  std::string
  UnitCheck::warnings(const Anatomy &anatomy) const
  {
    std::ostringstream out;
    for (const Units &set : known)
      if (set.name == units)
        {
          const double length    = anatomy.geometry().characteristic_length();
          const double stiffness = anatomy.wall_stiffness();
          const auto   warn      = [&](const std::string &what,
                                const double       value,
                                const std::string &unit,
                                const std::string &than) {
            out << "Warning: " << what << " " << value << " " << unit << ", "
                << than << ". Is that in the units of 'Units' = '" << units
                << "'?\n";
          };
          if (length > longest * set.metre)
            warn("the radius or edge of the body is",
                 length,
                 set.length_unit,
                 "more than 1 m");
          if (length < shortest * set.metre)
            warn("the radius or edge of the body is",
                 length,
                 set.length_unit,
                 "less than 0.01 mm");
          if (stiffness > stiffest * set.pascal)
            warn("the stiffest tissue has a shear modulus of",
                 stiffness,
                 set.stress_unit,
                 "more than steel");
          if (stiffness < softest * set.pascal)
            warn("the stiffest tissue has a shear modulus of",
                 stiffness,
                 set.stress_unit,
                 "less than 1 Pa");
        }
    return out.str();
  }
} // namespace lumbricus
