// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_regime_changes_h
#define lumbricus_discretization_regime_changes_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/surface_terms.h>

#include <string>

namespace lumbricus
{
  /**
   * What changes between sticking, sliding and being free from the solution
   * @p before to @p after at time @p t, for the message of a Newton's method that
   * goes to and fro: "; 7 of 81 points of 'soil' ...", empty where nothing does.
   * The same on all ranks. Collective.
   */
  std::string
  regime_changes(const Body     &body,
                 SurfaceTerms   &terms,
                 const Vector   &before,
                 const Vector   &after,
                 const LoadTime &t);
} // namespace lumbricus

#endif
