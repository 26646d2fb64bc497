// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/monotone_cubic.h>
#include <lumbricus/core/number_table.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Numbers over time from a table (NumberTable) with a column for each segment
   * or one for all. With rows d_i at times t_i, for t_i <= t < t_(i+1) and
   * q = (t - t_i)/h_i, h_i = t_(i+1) - t_i, it is
   *
   *   steps:  d_i
   *   linear: (1 - q) d_i + q d_(i+1)
   *   cubic:  d_i + the cubic polynomial in q with d_i, d_(i+1) and the slopes
   *           m_i, m_(i+1) at its ends,
   *
   * where m_i is that of monotone_slope(), and at an end of the table that of the
   * straight line there is: it never goes beyond the rows. Rows at times that
   * are repeated follow each other for ever, forwards and backwards.
   */
  class TableActivation : public Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Reads the table. Throws ExcInput with the line and the column. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** Throws ExcInput where @p t is not in the table. */
    double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const override;

    /** The times of rows; where many, those of the least and the greatest value
     * in each of many parts. */
    std::vector<double>
    marks(const unsigned int segment,
          const double       from,
          const double       to) const override;

    void
    check_given(
      const std::function<std::string(double)> &requirement) const override;

  private:
    /** The line after row @p row of column @p c; none where the table ends. */
    std::optional<TableLine>
    line_after(const std::size_t row, const std::size_t c) const;

    /** The line before it. */
    std::optional<TableLine>
    line_before(const std::size_t row, const std::size_t c) const;

    /** The slope m at row @p row of column @p c, with a line on a side at least. */
    double
    slope(const std::size_t row, const std::size_t c) const;

    /** How many times the table has been repeated at time @p t. */
    double
    n_repeats(const double t) const;

    /** Whether its last row is at the time at which it repeats. */
    bool
    is_closed() const;

    std::string file_name;
    std::string between = "linear";
    double      period  = 0.;

    NumberTable table;
    /** Of each segment, from zero. */
    std::vector<std::size_t> columns;
  };



  namespace
  {
    // Times this close, relative to their size, are the same.
    constexpr double same_time = 1e-12;



    // As people write it.
    std::string
    number_text(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }



    // The columns of a table are those of n segments, or one.
    std::string
    wrong_names(const std::vector<std::string> &names, const unsigned int n)
    {
      const std::string all_of_them =
        "Its line of names is 't, all', or 't, 1" +
        std::string(n > 2 ? ", ..." : "") +
        (n > 1 ? ", " + std::to_string(n) : "") + "' for the " +
        std::to_string(n) + " segment" + (n == 1 ? "" : "s") + " of this body.";
      if (names[0] != "t")
        return "the first column is '" + names[0] + "', but has to be 't'. " +
               all_of_them;
      if (names.size() == 2 && names[1] == "all")
        return "";
      for (unsigned int s = 1; s <= n; ++s)
        if (std::find(names.begin() + 1, names.end(), std::to_string(s)) ==
            names.end())
          return "the column '" + std::to_string(s) + "' is missing. " +
                 all_of_them;
      for (std::size_t c = 1; c < names.size(); ++c)
        {
          double s = 0.;
          for (unsigned int i = 1; i <= n && s == 0.; ++i)
            if (names[c] == std::to_string(i))
              s = i;
          if (s == 0.)
            return "the column '" + names[c] + "' is none of a segment. " +
                   all_of_them;
        }
      return "";
    }
  } // namespace



  void
  TableActivation::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("File",
                      file_name,
                      "[path] A text file with a line of names, 't, 1, 2, "
                      "..., n' with a column for each of the n segments or 't, "
                      "all', and below it lines with a number for each, "
                      "separated by commas: a time, which increases from line "
                      "to line, and what the muscle does then. What follows a "
                      "# is left out. A relative path starts at the working "
                      "directory.",
                      dealii::Patterns::FileName());
    prm.add_parameter("Between rows",
                      between,
                      "[linear, cubic or steps] What is between two rows: a "
                      "straight line; a smooth curve without overshoot (cubic, "
                      "monotone, 'pchip'); or the number of the earlier row.",
                      dealii::Patterns::Selection("linear|cubic|steps"));
    prm.add_parameter("Repeat",
                      period,
                      "[time] After this time the table begins again, for "
                      "ever; it is not less than the table is long. 0: the "
                      "table does not repeat, and the run has to end with its "
                      "last row.",
                      dealii::Patterns::Double(0.));
  }



  void
  TableActivation::initialize(const std::string &section,
                                 const Geometry    &geometry)
  {
    const unsigned int n         = geometry.n_segments();
    const std::string  parameter = section + "/File";
    AssertThrow(!file_name.empty(),
                ExcParameter(parameter,
                             "is not set. Give the path of a table with a "
                             "column 't' and one for each segment, from the "
                             "working directory."));
    table = NumberTable(
      parameter,
      file_name,
      [n](const std::vector<std::string> &names) {
        return wrong_names(names, n);
      },
      "Give a line with names, 't' and the numbers of the segments, and below "
      "it one with numbers for each time.");
    const auto &names = table.columns();
    columns.clear();
    for (unsigned int s = 1; s <= n; ++s)
      columns.push_back(names[1] == "all" ?
                          1 :
                          std::find(names.begin(),
                                    names.end(),
                                    std::to_string(s)) -
                            names.begin());
    const double length =
      table.value(table.n_rows() - 1, 0) - table.value(0, 0);
    AssertThrow(period == 0. || length <= period * (1. + same_time),
                ExcParameter(section + "/Repeat",
                             "is " + number_text(period) +
                               ", but the file '" + file_name + "' is " +
                               number_text(length) +
                               " long. Give at least that, or 0."));
  }



  double
  TableActivation::n_repeats(const double t) const
  {
    return period == 0. ? 0. : std::floor((t - table.value(0, 0)) / period);
  }



  bool
  TableActivation::is_closed() const
  {
    return period > 0. &&
           table.value(table.n_rows() - 1, 0) - table.value(0, 0) >=
             period * (1. - same_time);
  }



  std::optional<TableLine>
  TableActivation::line_after(const std::size_t row,
                                 const std::size_t c) const
  {
    const bool ends = row + 1 == table.n_rows();
    if (ends && is_closed())
      // Beyond a jump nothing goes on as it did.
      return table.value(row, c) == table.value(0, c) && row > 0 ?
               line_after(0, c) :
               std::nullopt;
    if (ends && period == 0.)
      return {};
    const std::size_t next = ends ? 0 : row + 1;
    const double      h =
      table.value(next, 0) + (ends ? period : 0.) - table.value(row, 0);
    return TableLine{h, (table.value(next, c) - table.value(row, c)) / h};
  }



  std::optional<TableLine>
  TableActivation::line_before(const std::size_t row,
                                  const std::size_t c) const
  {
    if (row > 0)
      return line_after(row - 1, c);
    const std::size_t last = table.n_rows() - 1;
    if (period == 0.)
      return {};
    if (!is_closed())
      return line_after(last, c);
    return table.value(last, c) == table.value(0, c) ?
             line_after(last - 1, c) :
             std::nullopt;
  }



  double
  TableActivation::slope(const std::size_t row, const std::size_t c) const
  {
    const auto before = line_before(row, c), after = line_after(row, c);
    if (!before || !after)
      return (before ? before : after)->slope;
    return monotone_slope(*before, *after);
  }



  double
  TableActivation::value(const double       t,
                            const unsigned int segment,
                            const dealii::Point<dim> & /*X*/) const
  {
    const std::size_t c     = columns[segment - 1];
    const std::size_t last  = table.n_rows() - 1;
    const double      first = table.value(0, 0), end = table.value(last, 0);
    double            at    = t - n_repeats(t) * period;
    if (period == 0.)
      {
        const double near = same_time * std::max(std::abs(first), std::abs(end));
        if (at < first - near || at > end + near)
          table.fail("is from t = " + number_text(first) +
                     " to " + number_text(end) +
                     ", but the run asks for time " +
                     number_text(t) +
                     ". Add rows, or set 'Repeat'.");
        at = std::clamp(at, first, end);
      }
    else
      at = std::max(at, first);
    const std::size_t row  = table.row_after(at) - 1;
    const double      d    = table.value(row, c);
    const auto        line = line_after(row, c);
    if (between == "steps" || !line || at == table.value(row, 0))
      return d;
    const double s = at - table.value(row, 0);
    if (between == "linear")
      return d + s * line->slope;
    const std::size_t next = row < last ? row + 1 : 0;
    return cubic_on(*line, d, slope(row, c), slope(next, c), s).value;
  }



  std::vector<double>
  TableActivation::marks(const unsigned int segment,
                            const double       from,
                            const double       to) const
  {
    // More are not looked at in a step.
    constexpr std::size_t n_parts = 100;
    const std::size_t     c       = columns[segment - 1];
    const std::size_t     n       = table.n_rows();
    // Rows count on from one repeat to the next.
    const auto row_at = [&](const double t) {
      const double m = n_repeats(t);
      return m * n + table.row_after(std::max(t - m * period, table.value(0, 0)));
    };
    const auto time = [&](const double i) {
      const double m = std::floor(i / n);
      return table.value(i - m * n, 0) + m * period;
    };
    const double first = row_at(from);
    // As with a wave, a step cannot go past more repeats.
    const double end =
      std::min(period == 0. ? std::min<double>(row_at(to), n) : row_at(to),
               first + 100. * n);

    std::vector<double> times;
    const double        n_rows = end - first;
    const double        part   = std::max(1., n_rows / n_parts);
    for (double begin = first; begin < end; begin += part)
      {
        double least = begin, greatest = begin;
        double d_least    = std::numeric_limits<double>::max(),
               d_greatest = std::numeric_limits<double>::lowest();
        for (double i = std::ceil(begin); i < std::min(begin + part, end); ++i)
          {
            const double d = table.value(i - n * std::floor(i / n), c);
            if (d < d_least)
              {
                least   = i;
                d_least = d;
              }
            if (d > d_greatest)
              {
                greatest   = i;
                d_greatest = d;
              }
          }
        for (const double i : {least, greatest})
          if (i == std::floor(i) && time(i) > from && time(i) < to)
            times.push_back(time(i));
      }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }



  void
  TableActivation::check_given(
    const std::function<std::string(double)> &requirement) const
  {
    for (std::size_t row = 0; row < table.n_rows(); ++row)
      for (std::size_t c = 1; c < table.columns().size(); ++c)
        {
          const std::string wanted = requirement(table.value(row, c));
          if (!wanted.empty())
            table.fail("line " + std::to_string(table.line(row)) +
                       ", column '" + table.columns()[c] + "': it is " +
                       number_text(table.value(row, c)) +
                       ", but has to be " + wanted + ".");
        }
  }



  static const Register<Activation, TableActivation>
    table_activation("table",
                     "numbers over time from a file, one for each segment or "
                     "for all.");
} // namespace lumbricus
