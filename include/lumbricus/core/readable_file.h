// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_readable_file_h
#define lumbricus_core_readable_file_h

#include <fstream>
#include <string>

namespace lumbricus
{
  /**
   * Why a file of the user's cannot be read as input: it is not there, it is a
   * folder, a pipe (of which every rank would read a part, and which may keep
   * them waiting) or a device (which may have no end). Empty if it can be.
   */
  std::string
  why_unreadable(const std::string &file_name);

  /** The file; a stream that has failed where it is unreadable. */
  std::ifstream
  open_input_file(const std::string &file_name);
} // namespace lumbricus

#endif
