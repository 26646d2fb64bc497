// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/stiffness_ratio.h>
#include <lumbricus/core/exceptions.h>

#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // Measured on a chain of two segments with a soft liquid and with stiff
    // caps, by 'auto' and 'direct': up to 1e11 lengths and pressures are those
    // of a ratio of 1e8, to 1e-8. At 3e11 the strains of the wall between the
    // caps are 2 % off; at 1e12 a soft liquid takes 'auto' for ever.
    constexpr double noticeable = 1e9, too_large = 1e11;
  } // namespace



  StiffnessRatio::StiffnessRatio(const Anatomy &anatomy)
  {
    for (const TissueName &name : anatomy.geometry().tissues())
      {
        const Tissue &tissue = anatomy.tissue(name.name);
        const double  mu     = tissue.shear_modulus();
        if (softest.name.empty() || mu < softest.mu)
          softest = {tissue.law_section(), name.name, mu};
        if (stiffest.name.empty() || mu > stiffest.mu)
          stiffest = {tissue.law_section(), name.name, mu};
      }
  }



  double
  StiffnessRatio::value() const
  {
    return stiffest.mu / softest.mu;
  }



  std::string
  StiffnessRatio::words() const
  {
    std::ostringstream out;
    out.precision(3);
    out << "the tissue '" << stiffest.name << "' is " << value()
        << " times as stiff as '" << softest.name << "' (shear moduli "
        << stiffest.mu << " and " << softest.mu << " N/mm^2)";
    return out.str();
  }



  void
  StiffnessRatio::check() const
  {
    std::ostringstream limit;
    limit << too_large;
    AssertThrow(value() <= too_large,
                ExcInput(
                  "Sections '" + stiffest.section + "' and '" +
                  softest.section + "': " + words() +
                  ". Beyond " + limit.str() +
                  " the softer one is lost in the rounding errors of the "
                  "other. A tissue that hardly deforms is rigid at 1e4 times "
                  "the stiffness of its neighbours already, and a liquid is "
                  "free of shear at 1e-4 times: bring the two closer "
                  "together."));
  }



  std::string
  StiffnessRatio::warning() const
  {
    if (value() < noticeable)
      return "";
    std::ostringstream out;
    out.precision(1);
    out << "Warning: " << words()
        << ". Strains of the softer one are exact to about "
        << value() * std::numeric_limits<double>::epsilon()
        << " only, and linear systems are hard to solve; 1e4 times would be as "
           "good as rigid.\n";
    return out.str();
  }
} // namespace lumbricus
