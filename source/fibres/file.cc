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
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/utilities.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
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
   * Between points X_i with vectors d_i, f_i = d_i/|d_i|, whose signs mean
   * nothing: f(X) is the principal direction of the tensor
   *
   *   A(X) = sum_i phi_i(X) f_i f_i,
   *   phi_i = w_i/W (1 + (X - c) . C^+ (X_i - c)),   W = sum_i w_i,
   *   c = sum_i w_i/W X_i,   C = sum_i w_i/W (X_i - c) (X_i - c),
   *
   * which is a moving least squares fit: what is linear in X in the components
   * of f f is reproduced, so the error is of second order in the distance of
   * points. i goes over the points nearest to X, and
   *
   *   w_i = ((R - r_i)/(R r_i))^2,   r_i = |X - X_i| < R,
   *
   * with r_i^2 less by the same for all where X is farther from the nearest point
   * than that from the next, is infinite at a point, where f(X) = f_i exactly (Lancaster and Salkauskas,
   * Math. Comp. 37 (1981) 141). C^+ leaves out the directions in which the
   * points are hardly apart. Where X is farther from all points than twice
   * the largest distance of one from its sixth nearest, f is that of the nearest.
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

    /** The largest distance of a point from the sixth nearest to it. Throws
     * ExcInput where two points are the same. */
    double
    largest_spacing() const;

    /** The error about the parameter 'File'. */
    ExcInput
    wrong_file(const std::string &what) const
    {
      return ExcInput(about_parameter(path + "File", what));
    }

    /** The tensor A at @p X; @p nearest are the points near it. */
    dealii::SymmetricTensor<2, dim>
    mean_at(const dealii::Point<dim> &X, const std::vector<Entry> &nearest) const;

    /** The message on a point that is beyond the reach. */
    std::string
    too_far(const dealii::Point<dim> &X, const Entry &nearest) const;

    /** The message on a point around which directions are too different; the
     * points near it are @p nearest, the nearest first. */
    std::string
    no_mean(const dealii::Point<dim> &X, const std::vector<Entry> &nearest) const;

    std::string file_name;
    double      given_reach = 0.;

    std::string                         path; ///< that of the section and '/'
    std::vector<Entry>                  points;
    std::vector<dealii::Tensor<1, dim>> directions;
    std::vector<unsigned int>           line_numbers;
    dealii::RTree<Entry>                tree;
    /** Farther from all points nothing is between them. */
    double spacing = 0.;
    double reach   = 0.;
  };



  void
  FibresFromFile::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("File",
                      file_name,
                      "[path] A text file with six numbers in a line, "
                      "separated by commas or blanks: a point x, y, z in mm "
                      "and a vector along the fibres there, of any length but "
                      "zero; its sign means nothing. Between points the fibres "
                      "are interpolated from those around, at a point they "
                      "are as given, and beyond all points those of the "
                      "nearest; the centres of all cells of the muscle will "
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
    tree    = dealii::pack_rtree(points);
    spacing = largest_spacing();
    reach   = given_reach > 0. ? given_reach : 2. * spacing;
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
  FibresFromFile::largest_spacing() const
  {
    // In a mesh of flat cells the nearest point is too near to be a measure.
    constexpr unsigned int n_neighbours = 6;
    if (points.size() == 1)
      return 0.5 * std::numeric_limits<double>::max();
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
    return largest;
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



  std::string
  FibresFromFile::no_mean(const dealii::Point<dim> &X,
                          const std::vector<Entry> &nearest) const
  {
    // That which differs most from the nearest.
    const auto &f     = directions[nearest.front().second];
    const Entry other = *std::min_element(
      nearest.begin(), nearest.end(), [&](const Entry &a, const Entry &b) {
        return std::abs(f * directions[a.second]) <
               std::abs(f * directions[b.second]);
      });
    std::ostringstream message;
    message << ": in the file '" << file_name << "' the directions around the "
            << "point " << point_text(X)
            << " are so different that they have no mean, as those of lines "
            << line_numbers[nearest.front().second] << " and "
            << line_numbers[other.second]
            << ". Give more points there, or a file for each of two muscles.";
    return message.str();
  }



  dealii::SymmetricTensor<2, dim>
  FibresFromFile::mean_at(const dealii::Point<dim> &X,
                          const std::vector<Entry> &nearest) const
  {
    // In a direction in which points are less apart than this part, squared, of
    // the largest there is no slope to be found.
    constexpr double least_spread = 1e-3;

    // As seen from where X would be beside the nearest point.
    double apart = std::numeric_limits<double>::max();
    for (std::size_t i = 1; i < nearest.size(); ++i)
      apart =
        std::min(apart, nearest[0].first.distance(nearest[i].first));
    const double first = X.distance(nearest[0].first);
    const double least = std::min(first, apart);
    const auto distance = [&](const Entry &point) {
      const double r = X.distance(point.first);
      return std::sqrt(
        std::max(0., (r - first) * (r + first)) + least * least);
    };
    // So that the farthest do not count where all are as far.
    const double R = 1.1 * distance(nearest.back());

    std::vector<double>    weights;
    double                 sum = 0.;
    dealii::Tensor<1, dim> c; // from X
    for (const Entry &point : nearest)
      {
        const double r = distance(point);
        weights.push_back(std::pow((R - r) / (R * r), 2));
        sum += weights.back();
        c += weights.back() * (point.first - X);
      }
    c /= sum;

    dealii::SymmetricTensor<2, dim> C;
    for (std::size_t i = 0; i < nearest.size(); ++i)
      C += weights[i] / sum *
           dealii::symmetrize(
             dealii::outer_product(nearest[i].first - X - c,
                                   nearest[i].first - X - c));
    dealii::Tensor<1, dim> slope; // C^+ (X - c)
    const auto             axes = dealii::eigenvectors(C);
    for (const auto &[spread, axis] : axes)
      if (spread > least_spread * axes[0].first)
        slope -= (c * axis) / spread * axis;

    dealii::SymmetricTensor<2, dim> A;
    for (std::size_t i = 0; i < nearest.size(); ++i)
      {
        const auto  &f   = directions[nearest[i].second];
        const double phi = weights[i] / sum *
                           (1. + slope * (nearest[i].first - X - c));
        A += phi * dealii::symmetrize(dealii::outer_product(f, f));
      }
    return A;
  }



  dealii::Tensor<1, dim>
  FibresFromFile::direction(const dealii::Point<dim> &X) const
  {
    // Twice those of a cube around X, and some more: with eight around a point
    // of a regular grid all of them may be in a plane.
    constexpr unsigned int n_neighbours = 20;
    // Nearer than this, relative to the farthest, is at the point.
    constexpr double same_point = 1e-8;
    // How far the largest eigenvalue of A, which are 1, 0, 0 where all fibres
    // have one direction, is at least above the next.
    constexpr double least_gap = 0.1;

    std::vector<Entry> nearest;
    tree.query(boost::geometry::index::nearest(X, n_neighbours),
               std::back_inserter(nearest));
    std::sort(nearest.begin(),
              nearest.end(),
              [&X](const Entry &a, const Entry &b) {
                const double r = X.distance(a.first), s = X.distance(b.first);
                return r < s || (r == s && a.second < b.second);
              });
    AssertThrow(X.distance(nearest.front().first) <= reach,
                wrong_file(too_far(X, nearest.front())));
    while (nearest.size() > 1 && X.distance(nearest.back().first) > 2. * spacing)
      nearest.pop_back();
    // A fit would go on beyond the points as it does among them.
    if (nearest.size() == 1 ||
        X.distance(nearest.front().first) > 2. * spacing ||
        X.distance(nearest.front().first) <=
          same_point * X.distance(nearest.back().first))
      return directions[nearest.front().second];

    const auto axes = dealii::eigenvectors(mean_at(X, nearest));
    AssertThrow(axes[0].first - axes[1].first >= least_gap,
                wrong_file(no_mean(X, nearest)));
    return axes[0].second / axes[0].second.norm();
  }



  static const Register<FibreField, FibresFromFile>
    fibres_from_file("file",
                     "along the vectors that a file gives at points, "
                     "interpolated between them.");
} // namespace lumbricus
