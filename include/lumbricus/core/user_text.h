// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_user_text_h
#define lumbricus_core_user_text_h

#include <cstddef>
#include <string>

namespace lumbricus
{
  /** Whether @p text is UTF-8 of characters that XML can hold, as all that a
   * run writes is. See RFC 3629; control characters are not looked for. */
  bool
  is_utf8(const std::string &text);

  /** Whether there is a control character (of ASCII) in @p text. */
  bool
  has_control_character(const std::string &text);

  /** The text as a message quotes it: where it is long, its beginning and how
   * long it is. */
  std::string
  shortened(const std::string &text, const std::size_t most = 100);

  /** "'a', 'b', 'c'", as messages list @p names, or "none". */
  template <class Names>
  std::string
  quoted_list(const Names &names);

  /**
   * A message as a terminal takes it: of a long one, @p most characters from
   * its beginning and its end, and '?' for what is no UTF-8 or a control
   * character.
   */
  std::string
  printable(const std::string &message, const std::size_t most);



  template <class Names>
  std::string
  quoted_list(const Names &names)
  {
    std::string list;
    for (const std::string &name : names)
      list += (list.empty() ? "'" : ", '") + name + "'";
    return list.empty() ? "none" : list;
  }
} // namespace lumbricus

#endif
