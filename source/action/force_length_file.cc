// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * f_l(x), x = l/l_best, through the rows (x_i, f_i) of a file, on each interval
   * the cubic of its values and slopes at the ends. Slopes are those of Fritsch
   * and Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300-304): zero where the
   * rows turn, else a mean that leaves the curve monotone between rows. Before
   * the first row and after the last it is what it is there.
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
      path = section + "/";
      read();
      find_slopes();
    }

    CurvePoint
    at(const double l) const override;

  private:
    void
    read();

    void
    find_slopes();

    /** The error about the parameter 'File'. */
    void
    fail(const std::string &what) const
    {
      AssertThrow(false,
                  ExcInput(about_parameter(path + "File",
                                           file_name.empty() ?
                                             what :
                                             ": the file '" + file_name + "' " +
                                               what)));
    }

    std::string file_name;
    double      best = 1.;

    std::string         path; ///< that of the section and '/'
    std::vector<double> x, f, slope;
  };



  void
  ForceLengthFile::read()
  {
    if (file_name.empty())
      fail("is not set. Give the path of a file with a stretch and a part of the "
           "tension in a line, from the working directory.");
    std::ifstream in = open_input_file(file_name);
    if (!in.good())
      fail("cannot be read. Give its path from the working directory.");
    x.clear();
    f.clear();
    bool        has_header = false;
    std::string line;
    skip_byte_order_mark(in);
    for (unsigned int number = 1; read_line(in, line); ++number)
      {
        line.resize(std::min(line.find('#'), line.size()));
        if (dealii::Utilities::trim(line).empty())
          continue;
        const auto        words = dealii::Utilities::split_string_list(line, ',');
        const std::string at    = "line " + std::to_string(number) + ": ";
        if (!has_header)
          {
            if (words != std::vector<std::string>{"l", "f_l"})
              fail(at + "the first line is 'l, f_l', the names of the two "
                        "columns, not '" +
                   shortened(dealii::Utilities::trim(line)) + "'.");
            has_header = true;
            continue;
          }
        if (words.size() != 2)
          fail(at + "it has " + std::to_string(words.size()) +
               " numbers for 2 columns.");
        double row[2];
        for (unsigned int c = 0; c < 2; ++c)
          if (!read_number(words[c], row[c]))
            fail(at + "'" + shortened(words[c]) + "' is no number.");
        if (!x.empty() && !(row[0] > x.back()))
          fail(at + "the column 'l' has to increase.");
        if (!(row[0] > 0.))
          fail(at + "l has to be more than 0.");
        if (!(row[1] >= 0.))
          fail(at + "f_l has to be at least 0: a muscle pulls.");
        x.push_back(row[0]);
        f.push_back(row[1]);
      }
    if (x.size() < 2)
      fail("has fewer than two rows. Give a line 'l, f_l', and below it one with "
           "two numbers for each row.");
  }



  void
  ForceLengthFile::find_slopes()
  {
    const unsigned int n = x.size();
    const auto         h = [&](const unsigned int i) { return x[i + 1] - x[i]; };
    const auto         secant = [&](const unsigned int i) {
      return (f[i + 1] - f[i]) / h(i);
    };
    slope.assign(n, secant(0));
    if (n == 2)
      return;
    for (unsigned int i = 1; i + 1 < n; ++i)
      {
        const double left = secant(i - 1), right = secant(i);
        const double w_left  = h(i - 1) + 2. * h(i);
        const double w_right = 2. * h(i - 1) + h(i);
        slope[i] = left * right > 0. ?
                     (w_left + w_right) / (w_left / left + w_right / right) :
                     0.;
      }
    // At an end the parabola through three rows, bounded as it has to be there.
    const auto at_end = [&](const unsigned int end, const unsigned int next) {
      const double s = secant(end), s_next = secant(next);
      const double d =
        ((2. * h(end) + h(next)) * s - h(end) * s_next) / (h(end) + h(next));
      if (d * s <= 0.)
        return 0.;
      return s * s_next <= 0. && std::abs(d) > 3. * std::abs(s) ? 3. * s : d;
    };
    slope[0]     = at_end(0, 1);
    slope[n - 1] = at_end(n - 2, n - 3);
  }



  CurvePoint
  ForceLengthFile::at(const double l) const
  {
    const double here = l / best;
    if (here <= x.front())
      return {f.front(), 0.};
    if (here >= x.back())
      return {f.back(), 0.};
    const unsigned int i =
      std::upper_bound(x.begin(), x.end(), here) - x.begin() - 1;
    const double h = x[i + 1] - x[i], t = (here - x[i]) / h;
    const double secant = (f[i + 1] - f[i]) / h;
    // f_i + h (d_i t + c t^2 + b t^3)
    const double b = slope[i] + slope[i + 1] - 2. * secant;
    const double c = 3. * secant - 2. * slope[i] - slope[i + 1];
    return {f[i] + h * t * (slope[i] + t * (c + t * b)),
            (slope[i] + t * (2. * c + 3. * t * b)) / best};
  }



  static const Register<ForceLength, ForceLengthFile>
    force_length_file("file", "a curve through the rows of a file.");
} // namespace lumbricus
