// SPDX-License-Identifier: LGPL-2.1-or-later
#include "locking_watch.h"

#include <lumbricus/measures/locking.h>
#include <lumbricus/parameters/expression.h>

#include <iomanip>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // From this share of the strain at which a law locks on there is something
    // to say.
    constexpr double near = 0.9;
  } // namespace



  void
  LockingWatch::look(const Body           &body,
                     const ReferenceField &references,
                     const State          &state,
                     Log                  &log)
  {
    for (const auto &[i, most] : locking_of_tissues(body, references, state))
      if (most.share > near && named.insert(i).second)
        {
          const Tissue      &tissue = body.anatomy.tissue(i);
          std::ostringstream line;
          line << "        Warning: from time " << state.time
               << " on the tissue '" << tissue.name() << "' of segment "
               << most.segment << " is about to lock: it is at "
               << std::setprecision(3) << most.share
               << " of the I1 - 3 that its law, " << tissue.law_name()
               << ", ends at, at the point " << point_text(most.X)
               << ". Rubber seldom stretches so far; is '"
               << tissue.law_section() << "' as meant?\n";
          log << line.str();
        }
  }
} // namespace lumbricus
