// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stride_warning.h"

#include <lumbricus/contact/contacts.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // By how many elastic slips a stride is too short, and how much of it that
    // may be.
    constexpr double slips_too_short = 2.5, noticeable = 0.1;



    // Whether something besides contact says where the body is.
    bool
    is_held(const BoundaryConditions           &conditions,
            const std::vector<const Contact *> &contacts)
    {
      for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
        {
          const NamedCondition &condition = conditions.condition(i);
          const SurfaceTerm    *term      = condition.surface_term();
          const bool            is_elastic =
            contacts[i] == nullptr && term != nullptr &&
            !term->elastic_directions(SurfacePoint()).empty();
          if (is_elastic || condition.prescribed_displacement() != nullptr)
            return true;
        }
      return false;
    }
  } // namespace



  std::string
  stride_warning(const Anatomy            &anatomy,
                 const BoundaryConditions &conditions,
                 const BodyMotion         &motion)
  {
    const auto contacts = contacts_of(conditions);
    // What the largest slip is that is elastic, and where.
    double       slip = 0.;
    unsigned int where = 0;
    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (contacts[i] != nullptr && contacts[i]->may_slide() &&
          contacts[i]->friction().elastic_slip() > slip)
        {
          slip  = contacts[i]->friction().elastic_slip();
          where = i;
        }
    const double stride = std::abs(motion.stride);
    if (anatomy.n_muscles() == 0 || is_held(conditions, contacts) ||
        !(stride > slip) || slips_too_short * slip <= noticeable * stride)
      return "";
    std::ostringstream text;
    text.precision(2);
    text << "\nWarning: The stride, " << stride << " mm, is only "
         << std::round(stride / slip)
         << " elastic slips long; its error is some "
         << std::round(100. * std::min(slips_too_short * slip / stride, 1.))
         << " %. Lower '" << conditions.condition(where).type_section
         << "/Elastic slip', which is " << slip << " mm.\n";
    return text.str();
  }
} // namespace lumbricus
