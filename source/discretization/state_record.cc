// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/state_record.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <ostream>
#include <vector>

namespace lumbricus
{
  namespace
  {
    template <typename T>
    void
    write_bits(std::ostream &out, const T *values, const std::size_t n)
    {
      out.write(reinterpret_cast<const char *>(values), n * sizeof(T));
    }



    template <typename T>
    bool
    read_bits(std::istream &in, T *values, const std::size_t n)
    {
      return static_cast<bool>(
        in.read(reinterpret_cast<char *>(values), n * sizeof(T)));
    }
  } // namespace



  void
  write_cells(const MixedSpace &space, const State &state, std::ostream &out)
  {
    CellStateReader     reader(space, state);
    std::vector<double> values;
    for (const auto &cell : space.owned_cells())
      {
        reader.read(cell, values);
        const CellKey key = cell_key(cell);
        write_bits(out, key.data(), key.size());
        write_bits(out, values.data(), values.size());
      }
  }



  CellReader::CellReader(const MixedSpace &space, State &state)
    : writer(space, state)
    , values(writer.layout.size())
  {
    for (const auto &cell : space.owned_cells())
      missing[cell_key(cell)] = cell;
  }



  void
  CellReader::read(std::istream &in)
  {
    CellKey key;
    while (read_bits(in, key.data(), key.size()) &&
           read_bits(in, values.data(), values.size()))
      {
        twice            = twice || was_read.count(key) > 0;
        const auto found = missing.find(key);
        if (found == missing.end())
          continue;
        finite =
          finite && std::all_of(values.begin(), values.end(), [](double v) {
            return std::isfinite(v);
          });
        writer.write(found->second, values);
        missing.erase(found);
        was_read.insert(key);
      }
  }



  bool
  CellReader::is_complete() const
  {
    return missing.empty() && !twice;
  }



  bool
  CellReader::is_finite() const
  {
    return finite;
  }
} // namespace lumbricus
