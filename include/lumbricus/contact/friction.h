// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_contact_friction_h
#define lumbricus_contact_friction_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/geometry/segment_expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /**
   * Friction that holds a point of the skin elastically until it has slipped by
   * delta, and then pulls at its limit: with the slip s in the tangent plane, s_1
   * forward and s_2 across,
   *
   *   T = -(K s_1 t_1 + k_2 s_2 t_2)/(delta max(1, q)),
   *   q^2 = (s_1/a)^2 + (s_2/delta)^2,   a = delta k_1/K,   k_i = mu_i p + c_i w,
   *
   * where k_1 is the limit of the direction that s_1 has, K the larger one of
   * forward and backward, mu_i are the coefficients of friction, c_i the shear
   * strengths of the mucus, and w is 1 where the skin touches and falls to zero
   * over the mucus's thickness. It sticks for q < 1, equally stiff forward and
   * backward, and what slides has |T_1| = k_1 or |T_2| = k_2, or lies on the
   * ellipse between.
   */
  class Friction : public PartOfBody
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** What the traction hangs on, at a point of the skin. */
    struct Point
    {
      dealii::Tensor<1, dim> n;      ///< away from the obstacle
      dealii::Tensor<2, dim> H;      ///< grad n [1/mm]
      dealii::Tensor<1, dim> way;    ///< from the anchor to the point [mm]
      double                 gap;    ///< [mm]
      double                 p;      ///< pressure [N/mm^2]
      dealii::Tensor<1, dim> dp;     ///< dp/dx [N/mm^3]
      double                 setae;  ///< factor on backward friction
      /** What Response::stabilisation makes a point that sticks at least as stiff
       * against slip as: this pressure; 0 for none [N/mm^2]. */
      double least_pressure = 0.;
    };

    /** The traction and its derivative by the place of the point. */
    struct Response
    {
      dealii::Tensor<1, dim> s; ///< slip: the way within the tangent plane [mm]
      bool                   slides = false; ///< whether q > 1
      /** Whether q < 1, and there is something to hold it. */
      bool sticks = false;
      /** What is left of s when the anchor has followed: q = 1 [mm]. */
      dealii::Tensor<1, dim> kept;
      /** k_1, k_2 at least one of which is not zero. */
      bool                   holds = false;
      dealii::Tensor<1, dim> T;     ///< [N/mm^2]
      dealii::Tensor<2, dim> dT_dx; ///< exact [N/mm^3]
      /** To be added to the derivative, not to the traction, where a body lies
       * free: a skin without pressure yet, or that slides all over, is not held
       * by dT_dx [N/mm^3]. */
      dealii::Tensor<2, dim> stabilisation;
    };

    /** The traction at @p point. */
    Response
    evaluate(const Point &point) const;

    /** The forward direction in the plane with the normal @p n; zero where it
     * is along @p n. */
    dealii::Tensor<1, dim>
    forward(const dealii::Tensor<1, dim> &n) const;

    /** The factor on backward friction in @p segment, from zero, at rest position
     * @p X and time @p t. */
    double
    setae(const unsigned int        segment,
          const dealii::Point<dim> &X,
          const LoadTime           &t) const;

    /** The formulas of setae of all segments. */
    const SegmentExpression &
    setae_formula() const
    {
      return setae_factor;
    }

    /** w at @p gap. */
    double
    mucus(const double gap) const;

    /** Whether any coefficient is not zero. */
    bool
    any_coefficient() const;

    /** Whether there is shear strength. */
    bool
    any_strength() const;

    /** Whether it is the same along and across. */
    bool
    isotropic() const;

    /** The slip delta, up to which the skin sticks [mm]. */
    double
    elastic_slip() const
    {
      return delta;
    }

  private:
    std::vector<double> coefficients   = {0., 0., 0.};
    std::vector<double> strengths      = {0., 0., 0.};
    dealii::Tensor<1, dim> forward_vector = dealii::Point<dim>(-1., 0., 0.);
    SegmentExpression   setae_factor   = {"Setae", "1"};
    double              thickness      = 0.1;
    double              given_slip     = 0.;
    double              delta          = 0.;
  };
} // namespace lumbricus

#endif
