// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_names_h
#define lumbricus_core_names_h

#include <string>

namespace lumbricus
{
  /**
   * What keeps @p name from being a name of the user's own (of a tissue, a
   * muscle, a load, a patch), in words: "has a '/', which ...". Empty if
   * nothing does.
   *
   * A name is that of a section, an entry of a list, part of a setting on the
   * command line and, for muscles, of a field in the VTU files. So it is text
   * in UTF-8 without '/', '=', '#', commas and control characters; all others
   * are right, as in "50% power", "M&M" or "Längsmuskel".
   */
  std::string
  unfit_name(const std::string &name);
} // namespace lumbricus

#endif
