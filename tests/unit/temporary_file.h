// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_unit_temporary_file_h
#define lumbricus_tests_unit_temporary_file_h

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace lumbricus
{
  /** A file with this text, of its own for every process; removed at the end. */
  class TemporaryFile
  {
  public:
    explicit TemporaryFile(const std::string &text)
      : name("unit_test_" + std::to_string(getpid()) + ".csv")
    {
      std::ofstream(name) << text;
    }

    ~TemporaryFile()
    {
      std::filesystem::remove(name);
    }

    const std::string name;
  };
} // namespace lumbricus

#endif
