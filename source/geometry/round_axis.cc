// SPDX-License-Identifier: LGPL-2.1-or-later
#include "round_axis.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // Three numbers, if @p text is three.
    bool
    read_vector(const std::string &text, dealii::Tensor<1, dim> &vector)
    {
      const auto words = dealii::Utilities::split_string_list(text, ',');
      if (words.size() != dim)
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        if (!read_number(words[d], vector[d]))
          return false;
      return true;
    }
  } // namespace



  RoundAxis::RoundAxis(const std::string &parameter, const std::string &text)
  {
    const std::string trimmed = dealii::Utilities::trim(text);
    const std::string names   = "xyz";
    const auto        number  = names.find(trimmed);
    if (trimmed.size() == 1 && number != std::string::npos)
      {
        direction[number] = 1.;
        name              = "the " + trimmed + " axis";
        return;
      }

    const auto parts = dealii::Utilities::split_string_list(trimmed, ';');
    dealii::Tensor<1, dim> through;
    AssertThrow(parts.size() == 2 && read_vector(parts[0], through) &&
                  read_vector(parts[1], direction) && direction.norm() > 0.,
                ExcInput(about_parameter(
                  parameter,
                  ": '" + text +
                    "' is no axis. Give 'x', 'y' or 'z', or a point and a "
                    "direction that is not zero, as '0, 1.5, 0; 0, 0, 1'.")));
    point = dealii::Point<dim>(through);
    direction /= direction.norm();
    name = "the axis '" + trimmed + "'";
  }



  double
  RoundAxis::radius(const dealii::Point<dim> &X) const
  {
    return cross_product_3d(X - point, direction).norm();
  }



  double
  RoundAxis::along(const dealii::Point<dim> &X) const
  {
    return (X - point) * direction;
  }



  RoundAxis::Deviation
  RoundAxis::deviation(const std::array<dealii::Point<dim>, 4> &corners) const
  {
    std::array<double, 4> x, r;
    double                size = 0.;
    for (unsigned int i = 0; i < 4; ++i)
      {
        x[i] = along(corners[i]);
        r[i] = radius(corners[i]);
        for (unsigned int j = 0; j < i; ++j)
          size = std::max(size, corners[i].distance(corners[j]));
      }

    const auto   x_range   = std::minmax_element(x.begin(), x.end());
    const double same      = 1e-6 * size;
    Deviation    deviation = {0., std::numeric_limits<double>::max()};
    // In a section through the body, corners may have any radius.
    if (*x_range.second - *x_range.first < same)
      return {0., 0.};
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          if (std::abs(x[i] - x[j]) < same)
            deviation.of_radius =
              std::max(deviation.of_radius, std::abs(r[i] - r[j]) / size);

          // The narrowest strip has two of them on one of its sides.
          const double length = std::hypot(x[i] - x[j], r[i] - r[j]);
          if (length < same)
            continue;
          double least = 0., most = 0.;
          for (unsigned int k = 0; k < 4; ++k)
            {
              const double off =
                ((x[i] - x[j]) * (r[k] - r[j]) -
                 (r[i] - r[j]) * (x[k] - x[j])) /
                length;
              least = std::min(least, off);
              most  = std::max(most, off);
            }
          deviation.of_profile =
            std::min(deviation.of_profile, (most - least) / 2. / size);
        }
    return deviation;
  }
} // namespace lumbricus
