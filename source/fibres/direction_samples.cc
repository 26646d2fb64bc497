// SPDX-License-Identifier: LGPL-2.1-or-later
#include "direction_samples.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace lumbricus
{
  using dealii::Point;
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    // Twice those of a cube around a point, and some more: of a regular grid eight
    // around a point may all be in a plane.
    constexpr unsigned int n_fitted = 20;
    // How far the largest eigenvalue of A, which are 1, 0, 0 where all fibres have one
    // direction, has to be above the next.
    constexpr double least_gap = 0.1;
    // What is far from X on a curved surface is no quadratic function any more.
    constexpr double part_without_doubt = 0.3;
    // Nearer than this, relative to the farthest, is at a point.
    constexpr double same_point = 1e-8;
  } // namespace



  DirectionSamples::DirectionSamples(
    const std::vector<Point<dim>>     &points,
    const std::vector<Tensor<1, dim>> &directions)
    : directions(directions)
    , first_twins(2 * points.size(), 2 * points.size())
  {
    for (unsigned int i = 0; i < points.size(); ++i)
      entries.emplace_back(points[i], i);
    tree = dealii::pack_rtree(entries);
    look_at_neighbours();
  }



  std::vector<DirectionSamples::Entry>
  DirectionSamples::nearest_entries(const Point<dim>  &X,
                                    const unsigned int n) const
  {
    std::vector<Entry> found;
    found.reserve(n);
    tree.query(boost::geometry::index::nearest(X, n),
               std::back_inserter(found));
    std::sort(found.begin(), found.end(), [&X](const Entry &a, const Entry &b) {
      const double r = X.distance_square(a.first);
      const double s = X.distance_square(b.first);
      return r < s || (r == s && a.second < b.second);
    });
    return found;
  }



  std::vector<DirectionSamples::Entry>
  DirectionSamples::spread_entries(const Point<dim> &X) const
  {
    // Of the distance from X.
    constexpr double closest = 0.5;
    // More are not looked at.
    constexpr unsigned int most = 64 * (n_fitted + 1);

    std::vector<Entry> result;
    for (unsigned int n = n_fitted + 1;
         n <= most && result.size() <= n_fitted;
         n *= 4)
      {
        const auto found = nearest_entries(X, n);
        result.clear();
        for (const Entry &entry : found)
          {
            const double least = closest * X.distance(entry.first);
            if (std::none_of(result.begin(),
                             result.end(),
                             [&](const Entry &other) {
                               return entry.first.distance(other.first) < least;
                             }))
              result.push_back(entry);
            if (result.size() > n_fitted)
              break;
          }
        if (found.size() < n)
          break;
      }
    return result;
  }



  void
  DirectionSamples::look_at_neighbours()
  {
    constexpr unsigned int n_neighbours = 6;
    double                 least_cosine = 2.;
    for (const Entry &entry : entries)
      for (const Entry &other : nearest_entries(entry.first, n_neighbours + 1))
        {
          if (other.second == entry.second)
            continue;
          const auto   pair = std::minmax(entry.second, other.second);
          const double r    = entry.first.distance(other.first);
          if (r == 0.)
            first_twins = std::min(first_twins, {pair.first, pair.second});
          largest_spacing = std::max(largest_spacing, r);
          const double cosine =
            std::abs(directions[entry.second] * directions[other.second]);
          if (cosine < least_cosine)
            {
              least_cosine = cosine;
              least_alike  = pair;
            }
        }
    constexpr std::size_t most_looked_at = 1000;
    const std::size_t     stride         = 1 + entries.size() / most_looked_at;
    for (std::size_t i = 0; i < entries.size(); i += stride)
      {
        const auto around = spread_entries(entries[i].first);
        farthest_spread =
          std::max(farthest_spread,
                   entries[i].first.distance(
                     around[std::min<std::size_t>(n_neighbours,
                                                  around.size() - 1)]
                       .first));
      }
    if (entries.size() == 1)
      largest_spacing = farthest_spread =
        0.5 * std::numeric_limits<double>::max();
    else
      largest_angle =
        std::acos(std::min(1., least_cosine)) * 180. / dealii::numbers::PI;
  }



  bool
  DirectionSamples::can_interpolate() const
  {
    return entries.size() > dim;
  }



  unsigned int
  DirectionSamples::n_directions_apart() const
  {
    Tensor<1, dim> center;
    for (const Entry &entry : entries)
      center += entry.first / static_cast<double>(entries.size());
    SymmetricTensor<2, dim> C;
    for (const Entry &entry : entries)
      C += dealii::symmetrize(
        dealii::outer_product(entry.first - center, entry.first - center));
    const auto spread = dealii::eigenvalues(C);
    return std::count_if(spread.begin(), spread.end(), [&](const double s) {
      return s > 1e-12 * spread[0];
    });
  }



  std::pair<unsigned int, double>
  DirectionSamples::nearest(const Point<dim> &X) const
  {
    const Entry entry = nearest_entries(X, 1).front();
    return {entry.second, X.distance(entry.first)};
  }



  std::vector<TensorSample>
  DirectionSamples::samples_of(const std::vector<Entry> &around,
                               const Point<dim>         &X) const
  {
    // The last of all has no next, and all may be as far.
    const double farthest  = X.distance(around.back().first);
    const auto   is_nearer = [&](const Entry &entry) {
      return X.distance(entry.first) < (1. - same_point) * farthest;
    };
    const bool   has_next = around.size() > n_fitted &&
                          std::count_if(around.begin(),
                                        around.end(),
                                        is_nearer) > dim;
    const double R        = has_next ? farthest : 1.1 * farthest;
    std::vector<TensorSample> samples;
    for (const Entry &entry : around)
      {
        const double r = X.distance(entry.first);
        if (has_next && !is_nearer(entry))
          break;
        const auto &f = directions[entry.second];
        samples.push_back({entry.first - X,
                           dealii::symmetrize(dealii::outer_product(f, f)),
                           std::pow((R - r) / (R * r), 2)});
      }
    return samples;
  }



  DirectionSamples::Value
  DirectionSamples::value(const Point<dim> &where) const
  {
    std::vector<Entry>   around   = nearest_entries(where, n_fitted + 1);
    const Entry          first    = around.front();
    const Tensor<1, dim> to_where = where - first.first;
    const double         distance = to_where.norm();
    const bool           is_far   = distance > farthest_spread;
    const Point<dim>     X =
      is_far ? first.first + farthest_spread / distance * to_where : where;
    if (is_far)
      around = nearest_entries(X, n_fitted + 1);
    if (!can_interpolate() || X.distance(around.front().first) <=
                                same_point * X.distance(around.back().first))
      {
        double off = 0.;
        if (!can_interpolate())
          for (const Entry &other : around)
            off = std::max(off,
                           1. - std::abs(directions[first.second] *
                                         directions[other.second]));
        return {directions[around.front().second], std::sqrt(2. * off)};
      }

    std::vector<TensorSample> samples = samples_of(around, X);
    FittedTensor              fitted  = fit_tensor(samples);
    if (fitted.n_directions < dim)
      {
        const auto others   = samples_of(spread_entries(X), X);
        const auto of_these = fit_tensor(others, part_without_doubt);
        // With few of them curvature cannot be told from being apart.
        if (others.size() >= n_fitted / 2 &&
            of_these.n_directions > fitted.n_directions)
          {
            samples = others;
            fitted  = of_these;
          }
      }
    const auto   axes = dealii::eigenvectors(fitted.A);
    const double gap  = axes[0].first - axes[1].first;
    if (!(gap >= least_gap))
      return {directions[first.second], 1.};
    double change = 0.;
    for (const TensorSample &sample : samples)
      change = std::max(change, (sample.A - samples.front().A).norm());
    // To first order, a projection changes by this where its tensor does by 1.
    return {axes[0].second / axes[0].second.norm(),
            std::min(0.5 * change, std::sqrt(2.) / gap * fitted.error)};
  }



  Tensor<1, dim>
  DirectionSamples::direction(const Point<dim> &X) const
  {
    return value(X).f;
  }



  double
  DirectionSamples::error(const Point<dim> &X) const
  {
    return value(X).error;
  }
} // namespace lumbricus
