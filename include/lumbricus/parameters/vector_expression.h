// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_vector_expression_h
#define lumbricus_parameters_vector_expression_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/utilities.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Three expressions separated by semicolons. Throws ExcInput. */
  inline std::vector<Expression>
  vector_expression(const std::string &name, const std::string &formulas)
  {
    const std::vector<std::string> parts =
      dealii::Utilities::split_string_list(formulas, ';');
    AssertThrow(parts.size() == dim,
                ExcInput("Parameter '" + name + "': '" +
                         shortened(formulas) + "' has " +
                         std::to_string(parts.size()) +
                         " components; give three expressions separated by "
                         "semicolons, such as '0.1*t; 0; 0'."));
    std::vector<Expression> components;
    for (const std::string &formula : parts)
      components.emplace_back(name, formula);
    return components;
  }
} // namespace lumbricus

#endif
