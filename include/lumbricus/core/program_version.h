// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_program_version_h
#define lumbricus_core_program_version_h

#include <string>

namespace lumbricus
{
  /** What was built, and with what. */
  struct ProgramVersion
  {
    std::string program;    ///< of this program, as "0.1.0"
    std::string deal_ii;    ///< of deal.II, as "9.4.1"
    std::string build_type; ///< "Debug" or "Release"
  };

  /** Those of the program that runs. */
  ProgramVersion
  program_version();
} // namespace lumbricus

#endif
