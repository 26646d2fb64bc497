// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/friction.h>
#include <lumbricus/core/exceptions.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    using dealii::outer_product;
    using dealii::Tensor;

    // Which entry of a list is of which direction.
    constexpr unsigned int forwards = 0, backwards = 1, sideways = 2;

    // Where all of a skin slides this part of the stiffness against slip is left,
    // so that the tangent of a body that lies free has an inverse, and Newton's
    // method still converges as well as it has to.
    constexpr double part_of_stiffness = 1e-5;

    // A limit k of the traction and dk/dx.
    struct Limit
    {
      double                 k;
      dealii::Tensor<1, dim> dk;
    };
  } // namespace



  void
  Friction::declare_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::List three(dealii::Patterns::Double(0.), dim, dim);
    prm.add_parameter("Friction",
                      coefficients,
                      "[-] Coefficients of friction of what slides forward, "
                      "backward and sideways: shear traction over pressure.",
                      three);
    prm.add_parameter("Forward",
                      forward_vector,
                      "[x, y, z] The direction that is forward, a vector of any "
                      "length but zero: towards the head, which is at the "
                      "smallest x.",
                      dealii::Patterns::List(dealii::Patterns::Double(),
                                             dim,
                                             dim));
    prm.add_parameter("Shear strength",
                      strengths,
                      "[N/mm^2] Friction without pressure, as of mucus: the "
                      "shear traction at which the skin slides forward, "
                      "backward and sideways.",
                      three);
    prm.add_parameter("Mucus thickness",
                      thickness,
                      "[mm] The shear strength is that where the skin touches, "
                      "and falls linearly to zero where it is so far away.",
                      dealii::Patterns::Double(1e-100));
    setae_factor.declare_parameter(
      prm,
      "[-] A factor on backward friction and shear strength, an expression in "
      "t, x, y, z (reference position), the number s of the segment, from 1 at "
      "the head, and the number n of segments.");
    prm.add_parameter("Elastic slip",
                      given_slip,
                      "[mm] How far the skin slips elastically before it "
                      "slides; 0 for 5e-4 of the body's length.",
                      dealii::Patterns::Double(0.));
  }



  void
  Friction::check_parameters() const
  {
    AssertThrow(any_coefficient() || any_strength() || !(given_slip > 0.),
                ExcParameter("Elastic slip",
                             "is set, but nothing holds the skin. Set 'Friction' "
                             "or 'Shear strength' too."));
    AssertThrow(forward_vector.norm() > 0.,
                ExcParameter("Forward",
                             "has no direction, because its length is zero. "
                             "Give a vector like '-1, 0, 0'."));
  }



  void
  Friction::initialize(const std::string & /*section*/,
                       const Geometry &geometry)
  {
    setae_factor.initialize(geometry);
    delta = given_slip > 0. ? given_slip : 5e-4 * geometry.length();
  }



  Friction::Response
  Friction::evaluate(const Point &point) const
  {
    Response               response;
    const Tensor<1, dim>  &n = point.n, &d = point.way;
    const Tensor<2, dim>   I = dealii::unit_symmetric_tensor<dim, double>();
    const Tensor<2, dim>   P = I - outer_product(n, n);
    const Tensor<1, dim>   s = P * d;
    // ds/dx with n that turns.
    const Tensor<2, dim> ds =
      P - (n * d) * point.H - outer_product(n, point.H * d);
    response.s      = s;
    response.kept   = s;

    const double w      = mucus(point.gap);
    const bool   fades  = w > 0. && w < 1.;
    const auto   factor = [&](const unsigned int i) {
      return i == backwards ? point.setae : 1.;
    };
    const auto limit = [&](const unsigned int i) {
      return Limit{factor(i) * (coefficients[i] * point.p + strengths[i] * w),
                   factor(i) * (coefficients[i] * point.dp -
                                (fades ? strengths[i] / thickness : 0.) * n)};
    };

    // Where forward is along the normal all is sideways.
    const Tensor<1, dim> f   = forward(n);
    const double         s_1 = f * s;
    Tensor<2, dim>       df;
    if (f.norm_square() > 0.)
      {
        const Tensor<2, dim> dq = -(n * forward_vector) * point.H -
                                  outer_product(n, point.H * forward_vector);
        df = (I - outer_product(f, f)) * dq / (P * forward_vector).norm();
      }
    const Tensor<1, dim> ds_1 = transpose(df) * s + transpose(ds) * f;
    const Tensor<1, dim> s_2  = s - s_1 * f;
    const Tensor<2, dim> ds_2 = ds - outer_product(f, ds_1) - s_1 * df;

    const bool  is_forward = s_1 >= 0.;
    const Limit k_1        = limit(is_forward ? forwards : backwards);
    const Limit other      = limit(is_forward ? backwards : forwards);
    const Limit k_2        = limit(sideways);
    // Nothing holds what may slide freely in its direction.
    const bool  is_held = k_1.k > 1e-12 * other.k;
    const Limit K = !is_held ? Limit{0., {}} : k_1.k >= other.k ? k_1 : other;

    // The traction as long as the skin sticks, and how far that goes.
    const Tensor<1, dim> T  = -(K.k * s_1 * f + k_2.k * s_2) / delta;
    const Tensor<2, dim> dT = -(K.k * (outer_product(f, ds_1) + s_1 * df) +
                                s_1 * outer_product(f, K.dk) + k_2.k * ds_2 +
                                outer_product(s_2, k_2.dk)) /
                              delta;
    const double a   = is_held && K.k > 0. ? delta * k_1.k / K.k : 0.;
    const double q_1 = a > 0. ? s_1 / a : 0.;
    const double q   = std::sqrt(q_1 * q_1 + s_2.norm_square() / (delta * delta));
    response.slides  = q > 1. || (s_1 != 0. && !is_held && other.k > 0.);
    if (q <= 1.)
      {
        response.T     = T;
        response.dT_dx = dT;
        const auto missing = [&](const double k, const double mu) {
          return std::max(0., mu * point.least_pressure - k);
        };
        const double more_1 =
          missing(K.k,
                  std::max(factor(forwards) * coefficients[forwards],
                           factor(backwards) * coefficients[backwards]));
        const double more_2 = missing(k_2.k, coefficients[sideways]);
        response.stabilisation =
          -(more_2 * P + (more_1 - more_2) * outer_product(f, f)) / delta;
      }
    else
      {
        Tensor<1, dim> dq = transpose(ds_2) * s_2 / (delta * delta);
        if (a > 0.)
          {
            const Tensor<1, dim> da =
              delta * (k_1.dk - k_1.k / K.k * K.dk) / K.k;
            dq += q_1 * (ds_1 - q_1 * da) / a;
          }
        dq /= q;
        response.T             = T / q;
        response.dT_dx         = (dT - outer_product(response.T, dq)) / q;
        response.stabilisation = part_of_stiffness * outer_product(response.T, dq);
        response.kept          = s / q;
      }
    if (!is_held)
      response.kept -= (f * response.kept) * f;
    response.sticks = q < 1. && (K.k > 0. || k_2.k > 0.);
    response.holds  = k_1.k > 0. || other.k > 0. || k_2.k > 0. ||
                     response.stabilisation.norm_square() > 0.;
    return response;
  }



  Tensor<1, dim>
  Friction::forward(const Tensor<1, dim> &n) const
  {
    const Tensor<1, dim> f = forward_vector - (forward_vector * n) * n;
    return f.norm() > 1e-8 * forward_vector.norm() ? f / f.norm() :
                                                     Tensor<1, dim>();
  }



  double
  Friction::setae(const unsigned int        segment,
                  const dealii::Point<dim> &X,
                  const LoadTime           &t) const
  {
    return t.take(
      [&](const double at) { return setae_factor.of(segment).value(X, at); },
      1.);
  }



  double
  Friction::mucus(const double gap) const
  {
    return any_strength() ? std::clamp(1. - gap / thickness, 0., 1.) : 0.;
  }



  bool
  Friction::any_coefficient() const
  {
    return std::any_of(coefficients.begin(),
                       coefficients.end(),
                       [](const double mu) { return mu > 0.; });
  }



  bool
  Friction::any_strength() const
  {
    return std::any_of(strengths.begin(), strengths.end(), [](const double c) {
      return c > 0.;
    });
  }



  bool
  Friction::isotropic() const
  {
    const auto equal = [](const std::vector<double> &of) {
      return of[forwards] == of[backwards] && of[forwards] == of[sideways];
    };
    return equal(coefficients) && equal(strengths) && setae_factor.text() == "1";
  }
} // namespace lumbricus
