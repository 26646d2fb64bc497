// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/readable_file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace lumbricus
{
  std::string
  why_unreadable(const std::string &file_name)
  {
    using Type = std::filesystem::file_type;
    std::error_code error;
    const Type      type = std::filesystem::status(file_name, error).type();
    switch (type)
      {
        case Type::regular:
          errno = 0;
          return std::ifstream(file_name) ? "" :
                 errno != 0               ? std::strerror(errno) :
                                            "it cannot be opened";
        case Type::directory:
          return "it is a folder";
        case Type::fifo:
          return "it is a pipe. Write it to a file first";
        case Type::block:
        case Type::character:
        case Type::socket:
          return "it is a device, not a file";
        default:
          return error ? error.message() : "No such file or directory";
      }
  }



  std::ifstream
  open_input_file(const std::string &file_name)
  {
    std::ifstream in;
    if (why_unreadable(file_name).empty())
      in.open(file_name);
    else
      in.setstate(std::ios::failbit);
    return in;
  }
} // namespace lumbricus
