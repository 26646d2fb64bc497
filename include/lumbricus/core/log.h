// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_log_h
#define lumbricus_core_log_h

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace lumbricus
{
  /** What the program says: to the terminal and to a file, from rank 0. */
  class Log
  {
  public:
    explicit Log(const MPI_Comm comm)
      : active(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
    {}

    /** From now on write to this file too, at its end where @p append. */
    void
    open(const std::string &file_name, const bool append)
    {
      if (active)
        file.open(file_name, append ? std::ios::app : std::ios::out);
    }

    template <typename T>
    Log &
    operator<<(const T &item)
    {
      if (active)
        {
          std::ostringstream text;
          text << item;
          std::cout << text.str() << std::flush;
          if (file.is_open())
            file << text.str() << std::flush;
        }
      return *this;
    }

  private:
    const bool    active;
    std::ofstream file;
  };
} // namespace lumbricus

#endif
