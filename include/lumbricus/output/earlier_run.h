// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_earlier_run_h
#define lumbricus_output_earlier_run_h

#include <lumbricus/parameters/parameter_entry.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A run that has left its folder, as far as it says how accurate it was. */
  struct EarlierRun
  {
    /** Values of parameters by path, as run.json has them. */
    using Values = std::map<std::string, std::string>;

    /** A number of errors.csv, as "length", and its largest estimated error of
     * all segments and times, relative to its own largest value. */
    struct Error
    {
      std::string name;     ///< of the number, with blanks
      double      relative; ///< more than 0 [-]
    };

    std::string        folder;           ///< as it was given
    Values             parameters;       ///< all that the run had
    double             time       = 0.;  ///< to which it came
    std::uint64_t      n_unknowns = 0;   ///< of its first mesh
    bool               is_adapted = false; ///< whether it had others later
    std::vector<Error> errors;           ///< those that are known, at least one
  };

  /** The run whose files run.json, mesh.csv and errors.csv are in @p folder;
   * none where one of them is not there, or is not as this program writes it,
   * or has no estimate yet. */
  std::optional<EarlierRun>
  earlier_run(const std::string &folder);

  /** Those in @p folder and in the folders beside it, that one first and the
   * others by name. */
  std::vector<EarlierRun>
  earlier_runs(const std::string &folder);

  /** The values of @p entries as run.json would have them. */
  EarlierRun::Values
  values_of(const std::vector<ParameterEntry> &entries);
} // namespace lumbricus

#endif
