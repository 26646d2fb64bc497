// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_fibres_direction_samples_h
#define lumbricus_fibres_direction_samples_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/numerics/rtree.h>

#include <utility>
#include <vector>

#include "tensor_fit.h"

namespace lumbricus
{
  /**
   * Directions f_i at scattered points X_i, whose signs mean nothing, and what they
   * are in between: the principal direction of the tensor A(X) that is fitted to
   * A_i = f_i f_i around X,
   *
   *   A(Y) = A_0 + sum_k S_k x_k(Y),   least sum_i w_i |A(X_i) - A_i|^2,
   *   w_i = ((R - r_i)/(R r_i))^2,     r_i = |X - X_i| < R,
   *
   * over the 20 points nearest to X, R the distance of the next, x_k coordinates along
   * the principal axes of these points with the weights w_i. So A is exact where f f
   * is linear in X, else the error is of second order in the distance of points; at a
   * point A = A_i, since its weight is infinite there (Lancaster and Salkauskas, Math.
   * Comp. 37 (1981) 141).
   *
   * Along an axis across which the points are not apart, or only as far as they are
   * on a curved surface, which is as far as x_k is a quadratic function of the
   * coordinates before it, nothing says how f changes, and S_k = 0. Where that is so
   * for the nearest points only, as in a wall of many thin layers, where all of them
   * are on one line through it, others take their place, see spread_entries(). Of the others S_k
   * is that of a fit with this function. Beyond the points the fit goes on for one
   * farthest_spread only; with fewer than four points, and where the two largest
   * eigenvalues of A are next to each other, f is that of the nearest point.
   */
  class DirectionSamples
  {
  public:
    /** Unit vectors @p directions at as many @p points, one or more. */
    DirectionSamples(const std::vector<dealii::Point<dim>>     &points,
                     const std::vector<dealii::Tensor<1, dim>> &directions);

    /** The unit vector at @p X. */
    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const;

    /** By how much f f may be off at @p X, in the Frobenius norm, as the second
     * differences of the directions around it tell, and at most half of what they
     * differ from the nearest; 1 where f is that of the nearest
     * point because those around it contradict each other. */
    double
    error(const dealii::Point<dim> &X) const;

    /** The number of the point nearest to @p X, and how far it is. */
    std::pair<unsigned int, double>
    nearest(const dealii::Point<dim> &X) const;

    /** The largest distance of a point from the sixth nearest to it: in a mesh of
     * flat cells the nearest is too near to be a measure. Without bounds for a
     * single point. */
    double
    spacing() const
    {
      return largest_spacing;
    }

    /** Two points at one place, the lower number first; twice the number of points
     * where there are none. */
    std::pair<unsigned int, unsigned int>
    twins() const
    {
      return first_twins;
    }

    /** Two neighbours whose directions are most apart, and the angle in degrees. */
    std::pair<std::pair<unsigned int, unsigned int>, double>
    most_apart() const
    {
      return {least_alike, largest_angle};
    }

    /** Whether there are enough points to interpolate. */
    bool
    can_interpolate() const;

    /** In how many directions the points are apart, from 0 to 3. */
    unsigned int
    n_directions_apart() const;

  private:
    using Entry = std::pair<dealii::Point<dim>, unsigned int>;

    struct Value
    {
      dealii::Tensor<1, dim> f;     ///< see direction()
      double                 error; ///< see error()
    };

    Value
    value(const dealii::Point<dim> &X) const;

    std::vector<Entry>
    nearest_entries(const dealii::Point<dim> &X, const unsigned int n) const;

    /** Points around @p X, the nearest first, of which no two are closer to each
     * other than half as far as the farther one is away. */
    std::vector<Entry>
    spread_entries(const dealii::Point<dim> &X) const;

    /** What is fitted to @p around, the nearest first, and the next of these. */
    std::vector<TensorSample>
    samples_of(const std::vector<Entry> &around, const dealii::Point<dim> &X) const;

    void
    look_at_neighbours();

    std::vector<Entry>                  entries;
    std::vector<dealii::Tensor<1, dim>> directions;
    dealii::RTree<Entry>                tree;

    double                                largest_spacing = 0.;
    /** The distance of the sixth of spread_entries() at some points, the largest. */
    double                                farthest_spread = 0.;
    std::pair<unsigned int, unsigned int> first_twins;
    std::pair<unsigned int, unsigned int> least_alike;
    double                                largest_angle = 0.;
  };
} // namespace lumbricus

#endif
