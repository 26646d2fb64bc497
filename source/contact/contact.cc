// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contact.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    // Lengths that are less than this part of a cell are rounding.
    constexpr double just_touches = 1e-9;

    // Before a body weighs upon the ground there is no pressure, and friction
    // would hold nothing: it is as stiff as with this part of the shear modulus.
    constexpr double least_pressure = 1e-6;
  } // namespace



  void
  Contact::declare_parameters(dealii::ParameterHandler &prm)
  {
    shape.declare_parameters(prm);
    friction_law.declare_parameters(prm);
    prm.add_parameter("Stiffness",
                      given_stiffness,
                      "[N/mm^3] Pressure over penetration; 0 for 30 mu/h, with "
                      "the shear modulus mu and the thickness h of the coarse "
                      "cells at the boundary.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Penetration",
                      penetration,
                      "[-] Largest penetration, relative to h: more is augmented "
                      "away.",
                      PositiveNumber());
  }



  bool
  Contact::extend_parameters(dealii::ParameterHandler &prm,
                             const Extent              extent)
  {
    return shape.extend_parameters(prm, extent);
  }



  void
  Contact::check_parameters() const
  {
    shape.check_parameters();
    friction_law.check_parameters();
  }



  void
  Contact::initialize(const std::string &section, const Geometry &geometry)
  {
    shape.get()->initialize(shape.section_in(section), geometry);
    friction_law.initialize(section, geometry);
  }



  void
  Contact::set_scale(const SurfaceScale &new_scale)
  {
    scale     = new_scale;
    stiffness = given_stiffness > 0. ?
                  given_stiffness :
                  30. * scale.shear_modulus / scale.thickness;
  }



  std::vector<Expression>
  Contact::expressions() const
  {
    return shape->expressions();
  }



  Contact::Standing
  Contact::standing(const SurfacePoint &point) const
  {
    const Point<dim> x    = point.X + point.u;
    const auto       here = shape->distance(x, point.t);
    Standing         found;
    found.gap        = here.gap;
    found.n          = here.n;
    found.anchor     = shape->carried(point.X + point.history, point.t);
    found.anchor_gap = shape->distance(found.anchor, point.t).gap;

    const double closing = found.anchor_gap - found.gap;
    found.touches        = closing > -just_touches * scale.thickness;
    found.p              = stiffness * std::max(closing, 0.);
    found.H              = here.H;
    if (found.touches)
      found.dTn_du = -stiffness * dealii::outer_product(here.n, here.n) +
                     found.p * here.H;
    if (may_slide())
      found.friction = friction_law.evaluate(friction_point(point, found));
    return found;
  }



  Friction::Point
  Contact::friction_point(const SurfacePoint &point, const Standing &found) const
  {
    Friction::Point at;
    at.n   = found.n;
    at.H   = found.H;
    at.way = point.X + point.u - found.anchor;
    at.gap = found.gap;
    at.p   = found.p;
    if (found.touches)
      {
        at.dp             = -stiffness * found.n;
        at.least_pressure = least_pressure * scale.shear_modulus;
      }
    at.setae = friction_law.setae(point.segment, point.X, point.t);
    return at;
  }



  void
  Contact::surface(const SurfacePoint &point, SurfaceResponse &response) const
  {
    const Standing found = standing(point);
    response.T           = found.traction();
    response.dT_du       = found.dTn_du + found.friction.dT_dx;
    response.sticks        = found.friction.sticks;
    response.stabilisation = found.friction.stabilisation;
  }



  bool
  Contact::symmetric() const
  {
    return !may_slide();
  }



  bool
  Contact::may_slide() const
  {
    return friction_law.any_coefficient() || friction_law.any_strength();
  }



  double
  Contact::pull_back(const SurfacePoint &point, const Tensor<1, dim> &du) const
  {
    if (!may_slide())
      return 0.;
    const Standing  found = standing(point);
    Friction::Point at    = friction_point(point, found);
    at.way += du;
    return (found.friction.T - friction_law.evaluate(at).T) * du;
  }



  SurfaceTerm::Regime
  Contact::regime(const SurfacePoint &point) const
  {
    const Standing found = standing(point);
    return !found.friction.holds && !(found.p > 0.) ? Regime::free :
           found.friction.slides                    ? Regime::slides :
                                                      Regime::sticks;
  }



  std::vector<Tensor<1, dim>>
  Contact::elastic_directions(const SurfacePoint &point) const
  {
    const Standing found = standing(point);
    if (!found.friction.holds)
      return found.touches ? std::vector<Tensor<1, dim>>{found.n} :
                             std::vector<Tensor<1, dim>>();
    std::vector<Tensor<1, dim>> all;
    for (unsigned int i = 0; i < dim; ++i)
      {
        const Tensor<1, dim> e = Point<dim>::unit_vector(i);
        all.push_back(found.touches ? e : e - (e * found.n) * found.n);
      }
    return all;
  }



  std::vector<Tensor<1, dim>>
  Contact::possible_directions(const SurfacePoint &point) const
  {
    const auto                  n = standing(point).n;
    std::vector<Tensor<1, dim>> all{n};
    if (!friction_law.isotropic())
      all.push_back(friction_law.forward(n));
    return all;
  }



  void
  Contact::remember(const SurfacePoint &point, Tensor<1, dim> &history) const
  {
    const Point<dim> x     = point.X + point.u;
    const Standing   found = standing(point);
    Point<dim>       x_a   = found.anchor;
    const auto       lift  = [&](const double gap) {
      const auto there = shape->distance(x_a, point.t);
      x_a += (gap - there.gap) * there.n;
    };
    // At rest x_a is x to rounding, wherever that is.
    const bool presses = found.p > just_touches * stiffness * scale.thickness;
    if (!found.friction.holds || (!presses && friction_law.mucus(found.gap) == 0.))
      x_a = x;
    else if (found.friction.slides)
      x_a += found.friction.s - found.friction.kept;
    lift(presses ? found.anchor_gap : 0.);
    history = history_of(x_a, point);
  }



  bool
  Contact::is_augmented(const SurfacePoint &point) const
  {
    const Standing found = standing(point);
    return !(found.p > 0.) ||
           std::abs(found.gap) <= penetration * scale.thickness;
  }



  Tensor<1, dim>
  Contact::augment(const SurfacePoint &point, Tensor<1, dim> &history) const
  {
    const Standing found = standing(point);
    const auto     there = shape->distance(found.anchor, point.t);
    history = history_of(found.anchor +
                           (found.p / stiffness - there.gap) * there.n,
                         point);
    // On the surface it has the pressure that it had.
    return -found.gap * found.n;
  }



  Tensor<1, dim>
  Contact::history_of(const Point<dim>   &x_a,
                      const SurfacePoint &point) const
  {
    return shape->carried_back(x_a, point.t) - point.X;
  }



  static const Register<BoundaryCondition, Contact>
    contact("contact",
            "an obstacle that the surface cannot go through, as the ground or a "
            "burrow, with friction.");
} // namespace lumbricus
