// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/monotone_cubic.h>
#include <lumbricus/core/number_table.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * f_l(x), x = l/l_best, through the rows (x_i, f_i) of a file, on each interval
   * the cubic_on() it with monotone_slope() at its ends, and at those of the
   * table the slope of the parabola through three rows, bounded so that the curve
   * is monotone there too. Before the first row and after the last it is what it
   * is there.
   */
  class ForceLengthFile : public ForceLength
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("File",
                        file_name,
                        "[path] A text file with a line 'l, f_l' and below it one "
                        "with two numbers for each row: the stretch, which "
                        "increases, and the part of its tension that a fibre has "
                        "there, at least 0. What follows a # is left out. A "
                        "relative path starts at the working directory.",
                        dealii::Patterns::FileName());
      prm.add_parameter("Best length",
                        best,
                        "[1] The stretch of the fibre that is 1 in the file.",
                        PositiveNumber());
    }

    void
    initialize(const std::string &section, const Geometry & /*geometry*/) override
    {
      read(section + "/File");
      find_slopes();
    }

    CurvePoint
    at(const double l) const override;

  private:
    void
    read(const std::string &parameter);

    void
    find_slopes();

    /** From row @p i to the next. */
    TableLine
    line(const unsigned int i) const
    {
      const double h = table.value(i + 1, 0) - table.value(i, 0);
      return {h, (table.value(i + 1, 1) - table.value(i, 1)) / h};
    }

    std::string file_name;
    double      best = 1.;

    NumberTable         table;
    std::vector<double> slopes;
  };



  void
  ForceLengthFile::read(const std::string &parameter)
  {
    const std::string wanted = "Give a line 'l, f_l', and below it one with two "
                               "numbers for each row, two rows or more.";
    AssertThrow(!file_name.empty(),
                ExcParameter(parameter,
                             "is not set. Give the path of a file with a stretch "
                             "and a part of the tension in a line, from the "
                             "working directory."));
    table = NumberTable(
      parameter,
      file_name,
      [](const std::vector<std::string> &names) {
        return names == std::vector<std::string>{"l", "f_l"} ?
                 std::string() :
                 "it has to be 'l, f_l', the names of the two columns.";
      },
      wanted);
    if (table.n_rows() < 2)
      table.fail("has fewer than two rows. " + wanted);
    for (unsigned int i = 0; i < table.n_rows(); ++i)
      {
        const std::string at =
          "line " + std::to_string(table.line(i)) + ", column ";
        if (!(table.value(i, 0) > 0.))
          table.fail(at + "'l': it has to be more than 0.");
        if (!(table.value(i, 1) >= 0.))
          table.fail(at + "'f_l': it has to be at least 0: a muscle pulls.");
      }
  }



  void
  ForceLengthFile::find_slopes()
  {
    const unsigned int n = table.n_rows();
    slopes.assign(n, line(0).slope);
    if (n == 2)
      return;
    for (unsigned int i = 1; i + 1 < n; ++i)
      slopes[i] = monotone_slope(line(i - 1), line(i));
    const auto at_end = [](const TableLine &end, const TableLine &next) {
      const double d =
        ((2. * end.h + next.h) * end.slope - end.h * next.slope) /
        (end.h + next.h);
      if (d * end.slope <= 0.)
        return 0.;
      return end.slope * next.slope <= 0. &&
                 std::abs(d) > 3. * std::abs(end.slope) ?
               3. * end.slope :
               d;
    };
    slopes[0]     = at_end(line(0), line(1));
    slopes[n - 1] = at_end(line(n - 2), line(n - 3));
  }



  CurvePoint
  ForceLengthFile::at(const double l) const
  {
    const double       x    = l / best;
    const unsigned int last = table.n_rows() - 1;
    if (x <= table.value(0, 0))
      return {table.value(0, 1), 0.};
    if (x >= table.value(last, 0))
      return {table.value(last, 1), 0.};
    const unsigned int  i = table.row_after(x) - 1;
    const CurvePoint    f = cubic_on(line(i),
                                  table.value(i, 1),
                                  slopes[i],
                                  slopes[i + 1],
                                  x - table.value(i, 0));
    return {f.value, f.slope / best};
  }



  static const Register<ForceLength, ForceLengthFile>
    force_length_file("file", "a curve through the rows of a file.");
} // namespace lumbricus
