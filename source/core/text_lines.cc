// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/text_lines.h>

#include <ios>
#include <streambuf>

namespace lumbricus
{
  bool
  read_line(std::istream &in, std::string &line)
  {
    constexpr int end_of_file = std::char_traits<char>::eof();
    line.clear();
    const std::istream::sentry ready(in, true);
    if (!ready)
      return false;
    std::streambuf &buffer = *in.rdbuf();
    for (int c = buffer.sbumpc(); c != end_of_file; c = buffer.sbumpc())
      {
        if (c == '\r' && buffer.sgetc() == '\n')
          buffer.sbumpc();
        if (c == '\r' || c == '\n')
          return true;
        line += static_cast<char>(c);
      }
    in.setstate(line.empty() ? std::ios::eofbit | std::ios::failbit :
                               std::ios::eofbit);
    return !line.empty();
  }



  void
  skip_byte_order_mark(std::istream &in)
  {
    if (in.peek() != 0xEF)
      return;
    for (unsigned int i = 0; i < 3; ++i)
      in.get();
  }



  std::string
  text_of(std::istream &in)
  {
    skip_byte_order_mark(in);
    std::string text, line;
    while (read_line(in, line))
      text += line + '\n';
    return text;
  }
} // namespace lumbricus
