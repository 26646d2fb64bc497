// SPDX-License-Identifier: LGPL-2.1-or-later
// The tractions that loads and beddings have at a point of the boundary: their
// derivatives against finite differences, and what they do when no time passes.
#include <lumbricus/terms/surface_term.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  struct Traction
  {
    std::string name;
    std::string text;
    bool        symmetric;
  };

  std::ostream &
  operator<<(std::ostream &out, const Traction &traction)
  {
    return out << traction.name << " (" << traction.text << ")";
  }

  class Tractions : public ::testing::TestWithParam<Traction>
  {
  protected:
    // A point that has moved, in a body that is sheared and turned.
    static SurfacePoint
    place()
    {
      SurfacePoint point;
      point.X    = dealii::Point<dim>(0.3, -0.2, 0.5);
      point.N    = dealii::Point<dim>(0.6, 0., 0.8);
      point.u    = dealii::Point<dim>(0.1, 0.25, -0.3);
      point.F[0] = dealii::Point<dim>(1.1, 0.3, -0.2);
      point.F[1] = dealii::Point<dim>(-0.4, 0.9, 0.1);
      point.F[2] = dealii::Point<dim>(0.2, 0.15, 1.3);
      point.t    = 0.7;
      point.dt   = 0.2;
      point.history = dealii::Point<dim>(-0.1, 0.05, 0.1);
      return point;
    }

    static SurfaceResponse
    at(const SurfaceTerm &term, const SurfacePoint &point)
    {
      SurfaceResponse response;
      term.surface(point, response);
      return response;
    }
  };

  INSTANTIATE_TEST_SUITE_P(
    All,
    Tractions,
    ::testing::Values(
      Traction{"dead traction", "set Traction = t*x; 0.2; -0.3", true},
      Traction{"follower pressure", "set Pressure = 0.3 + x*t", false},
      Traction{"spring", "set Stiffness = 0.7", true},
      Traction{"spring", "set Only along the normal = true", true},
      Traction{"drag",
               "set Along the surface = 0.3\nset Against the surface = 0.3",
               true},
      Traction{"drag", "set Along the surface = 0.3", false},
      Traction{"drag",
               "set Along the surface = 0.2\nset Against the surface = 0.9",
               false}));



  TEST_P(Tractions, DerivativesAreThoseOfTheTraction)
  {
    const auto condition =
      read_plugin<BoundaryCondition>(GetParam().name, GetParam().text);
    const auto  &term     = dynamic_cast<const SurfaceTerm &>(*condition);
    const auto   point    = place();
    const auto   response = at(term, point);
    const double h        = 1e-6;
    const double scale =
      std::max({response.T.norm(), response.dT_du.norm(), 1e-3});
    for (unsigned int k = 0; k < dim; ++k)
      {
        SurfacePoint plus = point, minus = point;
        plus.u[k] += h;
        minus.u[k] -= h;
        const auto dT = (at(term, plus).T - at(term, minus).T) / (2. * h);
        for (unsigned int i = 0; i < dim; ++i)
          EXPECT_NEAR(response.dT_du[i][k], dT[i], 1e-8 * scale);
        for (unsigned int L = 0; L < dim; ++L)
          {
            plus = minus = point;
            plus.F[k][L] += h;
            minus.F[k][L] -= h;
            const auto dT_dF = (at(term, plus).T - at(term, minus).T) / (2. * h);
            for (unsigned int i = 0; i < dim; ++i)
              EXPECT_NEAR(response.dT_dF[i][k][L], dT_dF[i], 1e-8 * scale);
          }
      }
    EXPECT_EQ(term.symmetric(), GetParam().symmetric);
  }



  TEST_P(Tractions, WithoutTimeOnlyWhatDependsOnSpeedIsNotThere)
  {
    const auto condition =
      read_plugin<BoundaryCondition>(GetParam().name, GetParam().text);
    const auto &term  = dynamic_cast<const SurfaceTerm &>(*condition);
    auto        point = place();
    point.dt          = 0.;
    EXPECT_EQ(at(term, point).T.norm() == 0., term.depends_on_rate());
    // At rest what holds the surface pulls against motions in its directions.
    for (const auto &direction : term.elastic_directions(place()))
      {
        if (direction.norm() == 0.)
          continue;
        auto moved = place();
        moved.F    = 0.;
        for (unsigned int i = 0; i < dim; ++i)
          moved.F[i][i] = 1.;
        moved.history = 0.;
        moved.u       = direction;
        EXPECT_LT(at(term, moved).T * direction, 0.);
      }
  }
} // namespace
