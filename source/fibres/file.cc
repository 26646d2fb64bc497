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
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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
   * f(X) = d_i/|d_i| with the vector d_i given at the point X_i nearest to X;
   * the points are meant to be the centres of cells.
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

    bool
    is_sampled() const override
    {
      return true;
    }

  private:
    using Entry = std::pair<dealii::Point<dim>, unsigned int>;

    void
    read();

    /** Add what a line says, which is number @p number. */
    void
    add(const std::vector<std::string> &words, const unsigned int number);

    /** How far from the nearest point there still is a direction, unless the
     * user says. Throws ExcInput where two points are the same. */
    double
    natural_reach() const;

    /** The error about the parameter 'File'. */
    ExcInput
    wrong_file(const std::string &what) const
    {
      return ExcInput(about_parameter(path + "File", what));
    }

    /** The message on a point that is beyond the reach. */
    std::string
    too_far(const dealii::Point<dim> &X, const Entry &nearest) const;

    std::string file_name;
    double      given_reach = 0.;

    std::string                         path; ///< that of the section and '/'
    std::vector<Entry>                  points;
    std::vector<dealii::Tensor<1, dim>> directions;
    std::vector<unsigned int>           line_numbers;
    dealii::RTree<Entry>                tree;
    double                              reach = 0.;
  };



  void
  FibresFromFile::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("File",
                      file_name,
                      "[path] A text file with six numbers in a line, "
                      "separated by commas or blanks: a point x, y, z in mm "
                      "and a vector along the fibres there, of any length but "
                      "zero. The fibres at a point are those of the nearest "
                      "point of the file, so give the centres of all cells of "
                      "the muscle. The first line may be 'x, y, z, fx, fy, "
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
    tree                 = dealii::pack_rtree(points);
    const double natural = natural_reach();
    reach                = given_reach > 0. ? given_reach : natural;
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
    points.emplace_back(X, directions.size());
    directions.push_back(d / d.norm());
    line_numbers.push_back(number);
  }



  double
  FibresFromFile::natural_reach() const
  {
    // In a mesh of flat cells the nearest point is too near to be a measure.
    constexpr unsigned int n_neighbours = 6;
    if (points.size() == 1)
      return std::numeric_limits<double>::max();
    double             largest = 0.;
    std::vector<Entry> nearest;
    for (const Entry &point : points)
      {
        nearest.clear();
        tree.query(boost::geometry::index::nearest(point.first,
                                                   n_neighbours + 1),
                   std::back_inserter(nearest));
        for (const Entry &other : nearest)
          {
            const double distance = point.first.distance(other.first);
            AssertThrow(
              distance > 0. || other.second == point.second,
              wrong_file(": " + file_name + ", lines " +
                         std::to_string(
                           line_numbers[std::min(other.second, point.second)]) +
                         " and " +
                         std::to_string(
                           line_numbers[std::max(other.second, point.second)]) +
                         ", have the same point. Remove one of them."));
            largest = std::max(largest, distance);
          }
      }
    return 2. * largest;
  }



  std::string
  FibresFromFile::too_far(const dealii::Point<dim> &X,
                          const Entry              &nearest) const
  {
    std::ostringstream message;
    message << ": the file '" << file_name
            << "' lacks the part of the muscle around the point "
            << point_text(X) << ". Its nearest point, "
            << point_text(nearest.first) << " in line "
            << line_numbers[nearest.second] << ", is "
            << X.distance(nearest.first) << " mm away, and the reach is "
            << reach << " mm. Add a line for every cell of the muscle, or set '"
            << path << "Reach' if the fibres there are as in that line.";
    return message.str();
  }



  dealii::Tensor<1, dim>
  FibresFromFile::direction(const dealii::Point<dim> &X) const
  {
    std::vector<Entry> nearest;
    tree.query(boost::geometry::index::nearest(X, 1),
               std::back_inserter(nearest));
    AssertThrow(X.distance(nearest.front().first) <= reach,
                wrong_file(too_far(X, nearest.front())));
    return directions[nearest.front().second];
  }



  static const Register<FibreField, FibresFromFile>
    fibres_from_file("file",
                     "along the vector that a file gives for the nearest "
                     "point, a vector per cell.");
} // namespace lumbricus
