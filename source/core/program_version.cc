// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/build_version.h>
#include <lumbricus/core/program_version.h>

#include <deal.II/base/config.h>

namespace lumbricus
{
  ProgramVersion
  program_version()
  {
    return {LUMBRICUS_VERSION, DEAL_II_PACKAGE_VERSION, LUMBRICUS_BUILD_TYPE};
  }
} // namespace lumbricus
