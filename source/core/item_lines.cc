// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/item_lines.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    // The whole of @p word as a number.
    template <typename T>
    bool
    read_whole(const std::string &word, T &value)
    {
      const char *const end    = word.data() + word.size();
      const auto        result = std::from_chars(word.data(), end, value);
      return result.ec == std::errc() && result.ptr == end;
    }
  } // namespace



  ItemLines::ItemLines(const std::string &text)
    : text(text)
    , at(std::string::npos)
  {}



  bool
  ItemLines::next()
  {
    if (at != std::string::npos)
      fail();
    if (!std::getline(text, line))
      return false;
    // Every line that was written whole has an end.
    if (text.eof())
      fail();
    at   = 0;
    name = get_word();
    return true;
  }



  const std::string &
  ItemLines::item() const
  {
    return name;
  }



  std::uintmax_t
  ItemLines::get_count(const std::uintmax_t most)
  {
    std::uintmax_t value = 0;
    if (!read_whole(get_word(), value) || value > most)
      fail();
    return value;
  }



  double
  ItemLines::get_number(const double least)
  {
    double value = 0.;
    if (!read_whole(get_word(), value) || !std::isfinite(value) ||
        value < least)
      fail();
    return value;
  }



  std::string
  ItemLines::get_word()
  {
    if (at == std::string::npos)
      fail();
    const auto  end  = line.find(' ', at);
    std::string word = line.substr(at, end - at);
    if (word.empty())
      fail();
    at = end == std::string::npos ? end : end + 1;
    return word;
  }



  std::string
  ItemLines::get_rest()
  {
    if (at == std::string::npos)
      fail();
    std::string rest = line.substr(at);
    at               = std::string::npos;
    return rest;
  }



  void
  ItemLines::fail() const
  {
    constexpr std::size_t longest = 80;
    throw ExcDamaged("has the line '" + line.substr(0, longest) +
                     (line.size() > longest ? "..." : "") +
                     "', which the program does not write.");
  }
} // namespace lumbricus
