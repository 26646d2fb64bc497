// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/user_text.h>

#include <algorithm>
#include <cctype>

namespace lumbricus
{
  namespace
  {
    bool
    continues(const char c)
    {
      return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    }



    // How many bytes the character at @p i has; 0 where there is none of UTF-8.
    std::size_t
    length_of_character(const std::string &text, const std::size_t i)
    {
      const auto        lead = static_cast<unsigned char>(text[i]);
      const std::size_t n    = lead < 0x80                  ? 1 :
                               lead >= 0xC2 && lead <= 0xDF ? 2 :
                               (lead & 0xF0) == 0xE0        ? 3 :
                               lead >= 0xF0 && lead <= 0xF4 ? 4 :
                                                              0;
      if (n < 2)
        return n;
      if (i + n > text.size() ||
          !std::all_of(text.begin() + i + 1, text.begin() + i + n, continues))
        return 0;

      unsigned long code = lead & (0xFFu >> (n + 1));
      for (std::size_t k = 1; k < n; ++k)
        code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
      const bool overlong  = (n == 3 && code < 0x800) ||
                             (n == 4 && code < 0x10000);
      const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
      const bool no_character =
        code > 0x10FFFF || (code & 0xFFFE) == 0xFFFE;
      return overlong || surrogate || no_character ? 0 : n;
    }



    // The last place, not behind @p i, where a character begins.
    std::size_t
    begin_of_character(const std::string &text, std::size_t i)
    {
      while (i > 0 && i < text.size() && continues(text[i]))
        --i;
      return i;
    }
  } // namespace



  bool
  is_utf8(const std::string &text)
  {
    for (std::size_t i = 0, n = 0; i < text.size(); i += n)
      if ((n = length_of_character(text, i)) == 0)
        return false;
    return true;
  }



  bool
  has_control_character(const std::string &text)
  {
    return std::any_of(text.begin(), text.end(), [](const char c) {
      return std::iscntrl(static_cast<unsigned char>(c));
    });
  }



  std::string
  shortened(const std::string &text, const std::size_t most)
  {
    return text.size() <= most ?
             text :
             text.substr(0, begin_of_character(text, most)) + "... (" +
               std::to_string(text.size()) + " characters)";
  }



  std::string
  printable(const std::string &message, const std::size_t most)
  {
    std::string whole = message;
    if (whole.size() > most)
      {
        const std::string gap   = " ... ";
        const std::size_t begin = begin_of_character(whole, most / 2);
        const std::size_t end   = begin_of_character(
          whole, whole.size() - (most - begin - gap.size()) + 3);
        whole = whole.substr(0, begin) + gap + whole.substr(end);
      }

    std::string text;
    for (std::size_t i = 0; i < whole.size();)
      {
        const std::size_t n     = length_of_character(whole, i);
        const std::string shown = whole.substr(i, std::max<std::size_t>(n, 1));
        text += n == 0 || (shown != "\n" && has_control_character(shown)) ?
                  "?" :
                  shown;
        i += shown.size();
      }
    return text;
  }
} // namespace lumbricus
