// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/surface_term.h>

#include <algorithm>
#include <cmath>

namespace
{
  using dealii::Tensor;
  using lumbricus::dim;

  /**
   * A skin that sticks along x to springs, which it drags along where they would
   * be stretched too much. Every point of the skin hangs on a spring whose other
   * end is anchored at X + a; with s = (u - a) . e_x
   *
   *   T = -k s e_x,             dT/du = -k e_x x e_x    for |s| <= d,
   *   T = -k d sign(s) e_x,     dT/du = 0               else,
   *
   * and when a load step has ended a follows, so that |s| = d. What the skin
   * remembers is a.
   */
  class Sticky : public lumbricus::SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Stiffness",
                        stiffness,
                        "[N/mm^3] Of the springs, per area at rest.",
                        lumbricus::PositiveNumber());
      prm.add_parameter("Largest stretch",
                        largest_stretch,
                        "[mm] Of the springs; more drags them along.",
                        lumbricus::PositiveNumber());
    }

    void
    surface(const lumbricus::SurfacePoint &point,
            lumbricus::SurfaceResponse    &response) const override
    {
      const double s = point.u[0] - point.history[0];
      response.T[0] =
        -stiffness * std::clamp(s, -largest_stretch, largest_stretch);
      if (std::abs(s) <= largest_stretch)
        response.dT_du[0][0] = -stiffness;
    }

    std::vector<Tensor<1, dim>>
    elastic_directions(
      const lumbricus::SurfacePoint & /*point*/) const override
    {
      return {dealii::Point<dim>::unit_vector(0)};
    }

    bool
    remembers() const override
    {
      return true;
    }

    void
    remember(const lumbricus::SurfacePoint &point,
             Tensor<1, dim>                &history) const override
    {
      history[0] = std::clamp(history[0],
                              point.u[0] - largest_stretch,
                              point.u[0] + largest_stretch);
    }

  private:
    double stiffness       = 0.1;
    double largest_stretch = 0.1;
  };

  const lumbricus::Register<lumbricus::BoundaryCondition, Sticky>
    sticky("sticky", "springs along x that are dragged along.");
} // namespace
