// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "direction_samples.h"

namespace lumbricus
{
  namespace
  {
    // The words of a line, without its comment. Commas and tabs are blanks.
    std::vector<std::string>
    words_of(std::string line)
    {
      line.resize(std::min(line.find('#'), line.size()));
      std::replace_if(
        line.begin(),
        line.end(),
        [](const char c) { return c == ',' || c == ';'; },
        ' ');
      std::istringstream       in(line);
      std::vector<std::string> words;
      for (std::string word; in >> word;)
        words.push_back(word);
      return words;
    }
  } // namespace



  /**
   * f(X) in between points X_i where the directions are those of the vectors d_i,
   * see DirectionSamples.
   */
  class FibresFromFile : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    initialize(const std::string &section, const Geometry &geometry) override;

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override;

    double
    error(const dealii::Point<dim> &X) const override
    {
      return samples->error(X);
    }

    std::string
    warning() const override;

  private:
    void
    read();

    /** Add what a line says, which is number @p number. */
    void
    add(const std::vector<std::string> &words, const unsigned int number);

    /** Throws ExcInput where two points are the same. */
    void
    check_points() const;

    /** The error about the parameter 'File'. */
    ExcInput
    wrong_file(const std::string &what) const
    {
      return ExcInput(about_parameter(path + "File", what));
    }

    /** The message on a point that is beyond the reach; point number @p nearest is
     * at the distance @p distance. */
    std::string
    too_far(const dealii::Point<dim> &X,
            const unsigned int        nearest,
            const double              distance) const;

    std::string file_name;
    double      given_reach = 0.;

    std::string                             path; ///< of the section, and '/'
    std::vector<dealii::Point<dim>>         points;
    std::vector<dealii::Tensor<1, dim>>     directions;
    std::vector<unsigned int>               line_numbers;
    std::unique_ptr<const DirectionSamples> samples;
    double                                  reach = 0.;
  };



  void
  FibresFromFile::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("File",
                      file_name,
                      "[path] A text file with six numbers in a line, "
                      "separated by commas or blanks: a point x, y, z in mm "
                      "and a vector along the fibres there, of any length but "
                      "zero; its sign means nothing. At a point of the file "
                      "the fibres are as given, between points they are "
                      "interpolated, with an error of second order in their "
                      "distance; the centres of all cells of the muscle will "
                      "do. The first line may be 'x, y, z, fx, fy, "
                      "fz'; what follows a # is left out. A relative path "
                      "starts at the working directory.",
                      dealii::Patterns::FileName());
    prm.add_parameter("Reach",
                      given_reach,
                      "[mm] How far from the nearest point of the file there "
                      "may be muscle. 0: twice the largest distance, in the "
                      "file, of a point from the sixth nearest to it.",
                      dealii::Patterns::Double(0));
  }



  void
  FibresFromFile::initialize(const std::string &section,
                             const Geometry & /*geometry*/)
  {
    path = section + "/";
    read();
    samples = std::make_unique<const DirectionSamples>(points, directions);
    check_points();
    reach = given_reach > 0. ? given_reach : 2. * samples->spacing();
  }



  void
  FibresFromFile::read()
  {
    AssertThrow(!file_name.empty(),
                wrong_file("is not set. Give the path of a file with a point "
                           "and a vector in a line, from the working "
                           "directory."));
    std::ifstream in = open_input_file(file_name);
    AssertThrow(in.good(),
                wrong_file(": the file '" + file_name +
                           "' cannot be read. Give the path of a file with a "
                           "point and a vector in a line, from the working "
                           "directory."));
    points.clear();
    directions.clear();
    line_numbers.clear();
    bool        at_top = true;
    std::string line;
    skip_byte_order_mark(in);
    for (unsigned int number = 1; read_line(in, line); ++number)
      {
        const auto words = words_of(line);
        if (words.empty())
          continue;
        const std::vector<std::string> header = {
          "x", "y", "z", "fx", "fy", "fz"};
        if (!at_top || words != header)
          add(words, number);
        at_top = false;
      }
    AssertThrow(!points.empty(),
                wrong_file(": the file '" + file_name +
                           "' has no points. Give one line x, y, z, fx, fy, fz "
                           "for every cell of the muscle."));
  }



  void
  FibresFromFile::add(const std::vector<std::string> &words,
                      const unsigned int              number)
  {
    const auto fail = [&](const std::string &what) {
      AssertThrow(false,
                  wrong_file(": " + file_name + ", line " +
                             std::to_string(number) + ", " + what));
    };
    if (words.size() != 2 * dim)
      fail("has " + std::to_string(words.size()) +
           " entries. Give six numbers: x, y, z, fx, fy, fz.");

    dealii::Point<dim>     X;
    dealii::Tensor<1, dim> d;
    for (unsigned int i = 0; i < words.size(); ++i)
      if (!read_number(words[i], i < dim ? X[i] : d[i - dim]))
        fail("has '" + words[i] +
             "', which is not a finite number. Give six numbers: x, y, z, fx, "
             "fy, fz.");

    if (!(d.norm() > 0.))
      fail("has a vector of length zero, which is no direction. Give a vector "
           "along the fibres.");
    points.push_back(X);
    directions.push_back(d / d.norm());
    line_numbers.push_back(number);
  }



  void
  FibresFromFile::check_points() const
  {
    const auto [first, second] = samples->twins();
    if (second >= points.size())
      return;
    AssertThrow(false,
                wrong_file(": " + file_name + ", lines " +
                           std::to_string(line_numbers[first]) + " and " +
                           std::to_string(line_numbers[second]) +
                           ", have the same point. Remove one of them."));
  }



  std::string
  FibresFromFile::warning() const
  {
    constexpr double   too_different = 45.; // degrees
    std::ostringstream what;
    what.precision(3);
    const auto [pair, angle] = samples->most_apart();
    if (points.size() > 1 && !samples->can_interpolate())
      what << "has " << points.size()
           << " points, which are too few to interpolate: fibres are those of "
              "the nearest point. Give at least four.";
    else if (angle > too_different)
      what << "has directions that are " << angle
           << " degrees apart at points next to each other, in lines "
           << line_numbers[pair.first] << " and " << line_numbers[pair.second]
           << ": between such points fibres turn from one to the other, or are "
              "those of the nearest. Give more points there, or a file for each "
              "of two muscles.";
    else if (points.size() > 1 && samples->n_directions_apart() < dim)
      what << "has all points "
           << (samples->n_directions_apart() == 1 ? "on a line" : "in a plane")
           << ": fibres beside it are those in it.";
    return what.str().empty() ?
             "" :
             about_parameter(path + "File",
                             ": the file '" + file_name + "' " + what.str());
  }



  std::string
  FibresFromFile::too_far(const dealii::Point<dim> &X,
                          const unsigned int        nearest,
                          const double              distance) const
  {
    std::ostringstream message;
    message << ": the file '" << file_name
            << "' lacks the part of the muscle around the point "
            << point_text(X) << ". Its nearest point, "
            << point_text(points[nearest]) << " in line "
            << line_numbers[nearest] << ", is " << distance
            << " mm away, and the reach is " << reach
            << " mm. Add a line for every cell of the muscle, or set '" << path
            << "Reach' if the fibres there are as in that line.";
    return message.str();
  }



  dealii::Tensor<1, dim>
  FibresFromFile::direction(const dealii::Point<dim> &X) const
  {
    const auto [nearest, distance] = samples->nearest(X);
    if (distance > reach)
      AssertThrow(false, wrong_file(too_far(X, nearest, distance)));
    return samples->direction(X);
  }



  static const Register<FibreField, FibresFromFile>
    fibres_from_file("file",
                     "along the vectors that a file gives at points, "
                     "interpolated between them.");
} // namespace lumbricus
