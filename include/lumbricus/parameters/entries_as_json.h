// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_entries_as_json_h
#define lumbricus_parameters_entries_as_json_h

#include <lumbricus/core/json_value.h>
#include <lumbricus/parameters/parameter_entry.h>

#include <vector>

namespace lumbricus
{
  /** An array with an object of path, value, default, unit and meaning for each
   * entry, as run.json and --values have it. Values are numbers, or true and
   * false, where the pattern allows nothing else, and texts otherwise. */
  JsonValue
  as_json(const std::vector<ParameterEntry> &entries);
} // namespace lumbricus

#endif
