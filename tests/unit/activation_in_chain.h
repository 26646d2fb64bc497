// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_unit_activation_in_chain_h
#define lumbricus_tests_unit_activation_in_chain_h

#include <lumbricus/activation/activation.h>
#include <lumbricus/geometry/geometry.h>

#include <memory>
#include <string>

#include "read_plugin.h"

namespace lumbricus
{
  /** The activation @p name with its parameters read from @p text, of a muscle in a
   * chain of @p n_segments segments. */
  inline std::unique_ptr<Activation>
  activation(const std::string &name,
             const std::string &text,
             const unsigned int n_segments = 10)
  {
    auto       result = read_plugin<Activation>(name, text);
    const auto chain  =
      read_plugin<Geometry>("segment chain",
                            "set Number of segments = " +
                              std::to_string(n_segments));
    result->initialize("Muscles/longitudinal/" + name, *chain);
    return result;
  }
} // namespace lumbricus

#endif
