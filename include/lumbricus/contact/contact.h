// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_contact_contact_h
#define lumbricus_contact_contact_h

#include <lumbricus/contact/friction.h>
#include <lumbricus/contact/obstacle.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/surface_term.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Contact of the skin with an Obstacle, and friction there. A point of the skin
   * remembers one vector, where in the obstacle it is anchored, x_a. With the
   * distance g, its gradient n and H = grad n at x = X + u,
   *
   *   p = eps <g(x_a) - g(x)>,   T = p n + T_friction(p, x - x_a),
   *   d(p n)/du = -eps n x n + p H   where p > 0.
   *
   * g(x_a) is zero but where the pressure is augmented: then it is p/eps, and x
   * comes to lie on the surface. T is per area at rest.
   *
   * After a load step x_a follows the skin: to its projection where it does not
   * touch, else so far that q = 1, see Friction. What is remembered of x_a is where it was
   * in the obstacle at time zero, less X.
   */
  class Contact : public SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    void
    initialize(const std::string &section, const Geometry &geometry) override;

    void
    set_scale(const SurfaceScale &scale) override;

    std::vector<Expression>
    expressions() const override;

    bool
    is_there_at_rest() const override
    {
      return true;
    }

    /** Where a point of the skin stands to the obstacle. */
    struct Standing
    {
      double                 gap = 0.; ///< g(x) [mm]
      dealii::Tensor<1, dim> n;        ///< grad g(x)
      dealii::Tensor<2, dim> H;        ///< grad n [1/mm]
      double                 p = 0.;   ///< pressure [N/mm^2]
      bool                   touches = false; ///< whether p > 0, or just not
      Friction::Response     friction;        ///< traction, slip
      dealii::Point<dim>     anchor;          ///< x_a [mm]
      double                 anchor_gap = 0.; ///< g(x_a) [mm]
      dealii::Tensor<2, dim> dTn_du;          ///< d(p n)/du [N/mm^3]

      /** T = p n + T_friction [N/mm^2]. */
      dealii::Tensor<1, dim>
      traction() const
      {
        return p * n + friction.T;
      }
    };

    /** What @p point does, with what it remembers. */
    Standing
    standing(const SurfacePoint &point) const;

    void
    surface(const SurfacePoint &point,
            SurfaceResponse    &response) const override;

    bool
    symmetric() const override;

    bool
    may_slide() const override;

    double
    pull_back(const SurfacePoint           &point,
              const dealii::Tensor<1, dim> &du) const override;

    Regime
    regime(const SurfacePoint &point) const override;

    std::vector<dealii::Tensor<1, dim>>
    elastic_directions(const SurfacePoint &point) const override;

    std::vector<dealii::Tensor<1, dim>>
    possible_directions(const SurfacePoint &point) const override;

    bool
    remembers() const override
    {
      return true;
    }

    void
    remember(const SurfacePoint     &point,
             dealii::Tensor<1, dim> &history) const override;

    bool
    is_augmented(const SurfacePoint &point) const override;

    dealii::Tensor<1, dim>
    augment(const SurfacePoint     &point,
            dealii::Tensor<1, dim> &history) const override;

    /** What the skin cannot go through. */
    const Obstacle &
    obstacle() const
    {
      return *shape;
    }

    /** The kind of obstacle, "plane". */
    const std::string &
    obstacle_name() const
    {
      return shape.chosen_name();
    }

    /** What holds the skin there. */
    const Friction &
    friction() const
    {
      return friction_law;
    }

    /** The thickness of the cells at the skin that lengths are relative to
     * [mm]. */
    double
    cell_thickness() const
    {
      return scale.thickness;
    }

  private:
    /** What friction at @p point hangs on; how the skin stands to the obstacle is
     * in @p found. */
    Friction::Point
    friction_point(const SurfacePoint &point, const Standing &found) const;

    /** What is remembered of the anchor @p x_a. */
    dealii::Tensor<1, dim>
    history_of(const dealii::Point<dim> &x_a, const SurfacePoint &point) const;

    Choice<Obstacle> shape = {"Obstacle",
                              "plane",
                              "What the skin cannot go through."};
    Friction         friction_law;
    double           given_stiffness = 0.;
    double           penetration     = 1e-3;
    double           stiffness       = 0.;
    SurfaceScale     scale;
  };
} // namespace lumbricus

#endif
