// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_json_parameters_h
#define lumbricus_parameters_json_parameters_h

#include <iosfwd>
#include <string>

namespace lumbricus
{
  /**
   * Parameters in JSON as the text of a .prm file: objects are sections, other
   * values are parameters, arrays are lists:
   *
   *   {"Time": {"End": 2}, "Output": {"Points": "0, 0, 0"}}
   *
   * Throws ExcInput that names @p file_name and the line where it is no JSON,
   * or more than InputLimits allow.
   */
  std::string
  prm_from_json(const std::string &file_name, std::istream &in);
} // namespace lumbricus

#endif
