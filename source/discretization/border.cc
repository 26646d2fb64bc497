// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/border.h>

#include <deal.II/base/exceptions.h>

namespace lumbricus
{
  namespace
  {
    template <typename T>
    void
    append_to(std::vector<T> &all, const std::vector<T> &more)
    {
      all.insert(all.end(), more.begin(), more.end());
    }
  } // namespace



  void
  Border::append(const Border &other)
  {
    if (corner.empty())
      corner = other.corner;
    else if (!other.corner.empty())
      {
        // Neither hangs on the unknowns of the other.
        dealii::FullMatrix<double> both(corner.m() + other.corner.m());
        both.fill(corner);
        both.fill(other.corner, corner.m(), corner.m());
        corner = both;
      }
    append_to(names, other.names);
    append_to(residual, other.residual);
    append_to(scale, other.scale);
    append_to(rounding, other.rounding);
    append_to(columns, other.columns);
    append_to(rows, other.rows);
  }



  std::vector<double>
  Border::read(const Globals &globals) const
  {
    std::vector<double> values;
    for (const auto &[name, n] : names)
      {
        const std::vector<double> &of_name = globals.at(name);
        AssertDimension(of_name.size(), n);
        append_to(values, of_name);
      }
    return values;
  }



  Globals
  Border::write(const std::vector<double> &values) const
  {
    Globals globals;
    auto    next = values.begin();
    for (const auto &[name, n] : names)
      {
        globals[name].assign(next, next + n);
        next += n;
      }
    return globals;
  }



  Border
  transposed(const Border &border)
  {
    Border turned  = border;
    turned.columns = border.rows;
    turned.rows    = border.columns;
    if (!border.corner.empty())
      turned.corner.copy_transposed(border.corner);
    return turned;
  }
} // namespace lumbricus
