// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarse_cells.h"

#include <lumbricus/core/exceptions.h>

#include <sstream>

namespace lumbricus
{
  void
  check_n_coarse_cells(const std::string &section, const double n)
  {
    constexpr double   most = 1e7;
    std::ostringstream message;
    message << "Section '" << section << "': the coarse mesh would have " << n
            << " cells, and every rank has all of it. Ask for at most " << most
            << ", and refine them with 'Mesh/Global refinements'.";
    AssertThrow(n <= most, ExcInput(message.str()));
  }
} // namespace lumbricus
