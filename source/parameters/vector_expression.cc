// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/vector_expression.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

namespace lumbricus
{
  VectorExpression::VectorExpression(const std::string &entry,
                                     const std::string &formulas)
    : text(formulas)
  {
    const std::vector<std::string> parts =
      dealii::Utilities::split_string_list(formulas, ';');
    AssertThrow(parts.size() == dim,
                ExcParameter(entry,
                             ": '" + shortened(formulas) + "' has " +
                               std::to_string(parts.size()) +
                               " components; give three expressions separated "
                               "by semicolons, such as '0.1*t; 0; 0'."));
    for (const std::string &formula : parts)
      of_components.emplace_back(entry, formula);
  }



  void
  VectorExpression::declare_parameter(dealii::ParameterHandler &prm,
                                      const std::string        &documentation)
  {
    const std::string entry = parameter();
    prm.declare_entry(entry, text, dealii::Patterns::Anything(), documentation);
    prm.add_action(entry, [this, entry](const std::string &formulas) {
      *this = VectorExpression(entry, formulas);
    });
  }
} // namespace lumbricus
