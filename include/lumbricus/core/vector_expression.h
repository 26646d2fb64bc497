// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_vector_expression_h
#define lumbricus_core_vector_expression_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>

#include <deal.II/base/utilities.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Three expressions separated by semicolons. Throws ExcInput. */
  inline std::vector<Expression>
  vector_expression(const std::string &name, const std::string &formulas)
  {
    std::vector<Expression> components;
    for (const std::string &formula :
         dealii::Utilities::split_string_list(formulas, ';'))
      components.emplace_back(name, formula);
    AssertThrow(components.size() == dim,
                ExcInput("Parameter '" + name + "': '" + formulas + "' has " +
                         std::to_string(components.size()) +
                         " components; give three expressions separated by "
                         "semicolons, such as '0.1*t; 0; 0'."));
    return components;
  }
} // namespace lumbricus

#endif
