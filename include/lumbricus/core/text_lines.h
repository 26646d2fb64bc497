// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_text_lines_h
#define lumbricus_core_text_lines_h

#include <istream>
#include <string>

namespace lumbricus
{
  /**
   * Read a line that ends with LF, CR LF, or CR alone, or with the file.
   * Returns whether there was one; @p line is without its end.
   */
  bool
  read_line(std::istream &in, std::string &line);

  /** Go past the mark that some editors put first in a file in UTF-8. */
  void
  skip_byte_order_mark(std::istream &in);

  /** All there is, with LF at the end of every line and without the byte order
   * mark. */
  std::string
  text_of(std::istream &in);
} // namespace lumbricus

#endif
