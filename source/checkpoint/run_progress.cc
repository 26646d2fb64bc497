// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/run_progress.h>

#include <iomanip>
#include <istream>
#include <limits>
#include <ostream>

namespace lumbricus
{
  // A line per item: its name, then its values; names of files come last.
  void
  RunProgress::write(std::ostream &out) const
  {
    out << std::setprecision(std::numeric_limits<double>::max_digits10)
        << "time " << time << "\nstep " << step << "\nstep_size " << step_size
        << "\nelapsed_seconds " << elapsed_seconds << "\nvtu_is_current "
        << vtu_is_current << '\n';
    for (const auto &[name, size] : table_sizes)
      out << "table " << size << ' ' << name << '\n';
    for (const auto &[t, name] : vtu_files)
      out << "vtu " << t << ' ' << name << '\n';
  }



  RunProgress
  RunProgress::read(std::istream &in, std::string &unknown)
  {
    RunProgress progress;
    std::string item, name;
    while (in >> item)
      if (item == "time")
        in >> progress.time;
      else if (item == "step")
        in >> progress.step;
      else if (item == "step_size")
        in >> progress.step_size;
      else if (item == "elapsed_seconds")
        in >> progress.elapsed_seconds;
      else if (item == "vtu_is_current")
        in >> progress.vtu_is_current;
      else if (item == "table")
        {
          std::uintmax_t size;
          in >> size >> name;
          progress.table_sizes[name] = size;
        }
      else if (item == "vtu")
        {
          double t;
          in >> t >> name;
          progress.vtu_files.emplace_back(t, name);
        }
      else
        {
          unknown = item;
          break;
        }
    return progress;
  }
} // namespace lumbricus
