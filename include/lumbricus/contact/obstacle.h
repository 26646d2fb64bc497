// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_contact_obstacle_h
#define lumbricus_contact_obstacle_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/vector_expression.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Something rigid that the body cannot go through: a signed distance g(x, t),
   * positive outside, whose gradient has the length 1 near the surface g = 0. It
   * may move, and points of it with it.
   */
  class Obstacle : public PartOfBody
  {
  public:
    /** The distance and its derivatives at a point of space. */
    struct Distance
    {
      double                 gap = 0.; ///< g [mm]
      dealii::Tensor<1, dim> n;        ///< grad g, away from the obstacle
      dealii::Tensor<2, dim> H;        ///< grad n, symmetric, H n = 0 [1/mm]
    };

    /** Where points of the obstacle are: x = origin + axes y, with y that do not
     * change in time. */
    struct Frame
    {
      dealii::Point<dim>     origin; ///< [mm]
      dealii::Tensor<2, dim> axes;   ///< any, with an inverse
    };

    /** All formulas in t, to be tried at the start and looked at between load
     * steps. */
    virtual std::vector<Expression>
    expressions() const = 0;

    /** Why there is no such obstacle at time @p t, "'Radius' is -1": empty where
     * there is. */
    virtual std::string
    unfit(const double t) const = 0;

    /** The distance of @p x at time @p t. */
    virtual Distance
    distance(const dealii::Point<dim> &x, const LoadTime &t) const = 0;

    /** Where points of the obstacle are at time @p t. */
    virtual Frame
    frame(const LoadTime &t) const = 0;

    /** Where a point of the obstacle is at time @p t that is at @p x0 at time
     * zero. */
    dealii::Point<dim>
    carried(const dealii::Point<dim> &x0, const LoadTime &t) const;

    /** Where it is at time zero, if it is at @p x at time @p t: the inverse of
     * carried(). */
    dealii::Point<dim>
    carried_back(const dealii::Point<dim> &x, const LoadTime &t) const;

    /** Quadrilaterals to draw, each by the numbers of its corners: around, so that
     * the normal points away from the obstacle. */
    struct Surface
    {
      std::vector<dealii::Point<dim>>          points; ///< [mm]
      std::vector<std::array<unsigned int, 4>> quads;  ///< by points
    };

    /** What there is of its surface in and around @p box at time @p t, for
     * pictures: quadrilaterals of about @p spacing that stay where they are in
     * the obstacle. None where it is not drawn. */
    virtual Surface
    surface(const LoadTime & /*t*/,
            const dealii::BoundingBox<dim> & /*box*/,
            const double /*spacing*/) const
    {
      return {};
    }

  protected:
    /** Whole numbers, all from the first to the last. */
    struct Range
    {
      int first; ///< the smallest
      int last;  ///< the largest
    };

    /** The surface whose points are @p place(i, j), with i and j in these
     * ranges. */
    static Surface
    grid(const Range                                                   &rows,
         const Range                                                   &columns,
         const std::function<dealii::Point<dim>(const int, const int)> &place);

    /** The whole numbers around what @p coordinate says of the corners of
     * @p box, divided by @p spacing. */
    static Range
    range_around(
      const dealii::BoundingBox<dim> &box,
      const std::function<double(const dealii::Point<dim> &)> &coordinate,
      const double                                             spacing);

    /** The value of a formula in t alone; before the first load it is what it is
     * at time zero. */
    static double
    value(const Expression &formula, const LoadTime &t);

    /** The same of three formulas. */
    static dealii::Point<dim>
    value(const VectorExpression &formulas, const LoadTime &t);
  };
} // namespace lumbricus

#endif
