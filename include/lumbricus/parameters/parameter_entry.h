// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_parameter_entry_h
#define lumbricus_parameters_parameter_entry_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A parameter that is declared: what it is set to, and what it means. */
  struct ParameterEntry
  {
    std::string path;          ///< "Section/Subsection/Name"
    std::string value;         ///< as in a parameter file
    std::string default_value; ///< the same without that it is set
    std::string unit;          ///< as "mm"; empty where there is none
    std::string meaning;       ///< its documentation, behind the unit
    std::string pattern;       ///< what it can be: the pattern's description
  };

  /** All entries of @p prm, in the order in which they were declared. */
  std::vector<ParameterEntry>
  entries_of(const dealii::ParameterHandler &prm);
} // namespace lumbricus

#endif
