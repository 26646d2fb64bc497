// SPDX-License-Identifier: LGPL-2.1-or-later
// Obstacles, friction and what a point of the skin does there: derivatives
// against finite differences, what moves with an obstacle, and what is left of a
// slip.
#include <lumbricus/contact/contact.h>
#include <lumbricus/geometry/geometry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "read_plugin.h"
#include "sample_point.h"

using namespace lumbricus;
using dealii::Point;
using dealii::Tensor;

namespace
{
  using sample_point::Gradient;

  // An obstacle that moves, and a place near its surface.
  struct Shape
  {
    std::string name;
    std::string text;
    Point<dim>  near;
  };

  std::ostream &
  operator<<(std::ostream &out, const Shape &shape)
  {
    return out << shape.name << " (" << shape.text << ")";
  }

  const Shape plane = {"plane",
                       "set Point = 0.1*t; 0.2; -t\n"
                       "set Normal = 0.3 + t; 0.2 - t; 1\n",
                       Point<dim>(0.5, -0.3, -0.4)};
  const Shape ball  = {"sphere",
                       "set Centre = t; 0.1; 0.2*t^2\n"
                        "set Radius = 0.7 + 0.4*t\n",
                       Point<dim>(0.9, 0.5, 0.6)};
  const Shape pipe  = {"burrow",
                       "set Point = 0.1; 0.2*t; 0\n"
                        "set Radius = 1.3 - 0.3*t\n"
                        "set Axis = 2, 0.4, 0.3\n",
                       Point<dim>(1.1, 0.9, -0.6)};
  const Shape bent_pipe = {"burrow",
                           "set Point = 0.1*t; 0; -0.2*t\n"
                           "set Radius = 1.2\n"
                           "set Axis = 2, 0.4, 0.3\n"
                           "set Curvature = 0.3\n"
                           "set Bends towards = 0.1, -1, 0.5\n",
                           Point<dim>(1.1, 0.9, -0.6)};

  constexpr double now = 0.4;

  class Obstacles : public ::testing::TestWithParam<Shape>
  {
  protected:
    const std::unique_ptr<Obstacle> obstacle =
      read_plugin<Obstacle>(GetParam().name, GetParam().text);
  };

  INSTANTIATE_TEST_SUITE_P(All,
                           Obstacles,
                           ::testing::Values(plane, ball, pipe, bent_pipe));



  TEST_P(Obstacles, NormalAndCurvatureAreDerivativesOfTheDistance)
  {
    constexpr double h = 1e-5;
    for (const double lift : {-0.1, 0., 0.2})
      {
        const auto       there = obstacle->distance(GetParam().near, now);
        const Point<dim> x = GetParam().near + (lift - there.gap) * there.n;
        const auto       found = obstacle->distance(x, now);
        EXPECT_NEAR(found.gap, lift, 1e-14);
        EXPECT_NEAR(found.n.norm(), 1., 1e-14);
        for (unsigned int c = 0; c < dim; ++c)
          {
            const Tensor<1, dim> e     = h * Point<dim>::unit_vector(c);
            const auto           plus  = obstacle->distance(x + e, now);
            const auto           minus = obstacle->distance(x - e, now);
            EXPECT_NEAR(found.n[c], (plus.gap - minus.gap) / (2. * h), 1e-8);
            const Tensor<1, dim> dn = (plus.n - minus.n) / (2. * h);
            for (unsigned int i = 0; i < dim; ++i)
              EXPECT_NEAR(found.H[i][c], dn[i], 1e-8);
          }
      }
  }



  // What is on its surface stays there; what is not, at the same part of its
  // radius.
  TEST_P(Obstacles, CarriesItsPointsWithIt)
  {
    const Point<dim> near = GetParam().near;
    const double     gap  = obstacle->distance(near, 0.).gap;
    const auto       up   = obstacle->distance(near, 0.).n;
    for (const double t : {0., 0.2, now})
      for (const double lift : {0., -0.1, 0.3})
        {
          const Point<dim> x0 = near + (lift - gap) * up;
          const Point<dim> x  = obstacle->carried(x0, t);
          EXPECT_LT(obstacle->carried_back(x, t).distance(x0), 1e-14);
          const double growth =
            GetParam().text == ball.text ? (0.7 + 0.4 * t) / 0.7 :
            GetParam().text == pipe.text ? (1.3 - 0.3 * t) / 1.3 :
                                           1.;
          EXPECT_NEAR(obstacle->distance(x, t).gap, growth * lift, 1e-13);
          EXPECT_EQ(x.distance(x0) < 1e-14, t == 0.);
        }
  }



  // Contact at a block whose boundaries are one cell of 0.2 mm thick.
  constexpr double delta = 0.05, thickness = 0.2, mu = 0.23;
  constexpr double mucus_thickness = 0.1;

  std::unique_ptr<BoundaryCondition>
  contact_with(const Shape &shape, const std::string &friction)
  {
    auto result =
      read_plugin<BoundaryCondition>("contact",
                                     "set Obstacle = " + shape.name +
                                       "\nsubsection " + shape.name + "\n" +
                                       shape.text + "end\n" + friction);
    result->initialize("Boundary conditions/ground/contact",
                       *Registry<Geometry>::create("block"));
    dynamic_cast<Contact &>(*result).set_scale({thickness, mu});
    return result;
  }

  const std::string slip_of_0_05 = "set Elastic slip = 0.05\n";

  // How the skin is held.
  struct Grip
  {
    std::string what;
    std::string text;
  };

  const std::vector<Grip> grips = {
    {"none", ""},
    {"equal", slip_of_0_05 + "set Friction = 0.7, 0.7, 0.7\n"},
    {"setae", slip_of_0_05 + "set Friction = 0.6, 2.4, 1.2\n"},
    {"setae that are raised",
     slip_of_0_05 + "set Friction = 0.6, 0.6, 1.2\nset Setae = 1 + 3*t\n"},
    {"no setae",
     slip_of_0_05 + "set Friction = 0.6, 2.4, 1.2\nset Setae = 0\n"},
    {"none forward", slip_of_0_05 + "set Friction = 0, 2.4, 1.2\n"},
    {"none sideways", slip_of_0_05 + "set Friction = 0.6, 2.4, 0\n"},
    {"mucus", slip_of_0_05 + "set Shear strength = 0.001, 0.004, 0.002\n"},
    {"mucus and setae",
     slip_of_0_05 + "set Friction = 0.6, 2.4, 1.2\n"
                    "set Shear strength = 0.01, 0.004, 0.02\n"
                    "set Forward = -1, 0.2, 0.1\n"}};

  // A point of the skin whose anchor is on the surface, or above it, and where
  // it is seen from there: along the normal and within the surface.
  struct Stand
  {
    double lift;      // of the skin above the surface
    double augmented; // of the anchor
  };

  const std::vector<Stand> stands = {{-0.02, 0.},
                                     {-0.001, 0.01},
                                     {0.002, 0.01},
                                     {0.04, 0.},
                                     {0.2, 0.}};

  class ContactPoints : public ::testing::TestWithParam<Shape>
  {
  protected:
    // The slip is @p forward along the forward direction and @p across to the
    // side.
    static SurfacePoint
    point_at(const Contact &contact,
             const Stand   &stand,
             const double   forward,
             const double   across)
    {
      const Obstacle &obstacle = contact.obstacle();
      const auto      there    = obstacle.distance(GetParam().near, now);
      const auto      on = GetParam().near - there.gap * there.n;
      const auto      f  = contact.friction().forward(there.n);
      SurfacePoint    point;
      point.X = Point<dim>(0.1, 0.2, 0.3);
      point.t = now;
      point.u = on + stand.lift * there.n + forward * f +
                across * dealii::cross_product_3d(there.n, f) - point.X;
      point.history =
        obstacle.carried_back(Point<dim>(on + stand.augmented * there.n), now) -
        point.X;
      return point;
    }

    // The traction, and its derivative without what only stabilises.
    static Tensor<1, dim>
    traction(const Contact &contact, const SurfacePoint &point)
    {
      SurfaceResponse response;
      contact.surface(point, response);
      return response.T;
    }

    static Gradient
    derivative(const Contact &contact, const SurfacePoint &point)
    {
      SurfaceResponse response;
      contact.surface(point, response);
      return response.dT_du;
    }
  };

  INSTANTIATE_TEST_SUITE_P(All,
                           ContactPoints,
                           ::testing::Values(plane, ball, pipe, bent_pipe));

  // Slips in elastic slips: that stick and that slide, along, across and between,
  // and none on an edge between two regimes.
  const std::vector<std::array<double, 2>> slips = {{{0.3, 0.01}},
                                                    {{3., 0.1}},
                                                    {{-0.1, 0.02}},
                                                    {{-0.7, 0.05}},
                                                    {{-4., 0.2}},
                                                    {{0.02, 0.5}},
                                                    {{0.1, -3.}},
                                                    {{-0.1, 3.}},
                                                    {{1.5, 2.}},
                                                    {{-1.5, -2.}}};



  TEST_P(ContactPoints, DerivativeIsThatOfTheTraction)
  {
    constexpr double h = 1e-6;
    for (const Grip &grip : grips)
      {
        const auto condition = contact_with(GetParam(), grip.text);
        const auto &contact  = dynamic_cast<const Contact &>(*condition);
        for (const Stand &stand : stands)
          for (const auto &slip : slips)
            {
              SCOPED_TRACE(grip.what + ", " + std::to_string(stand.lift) +
                           " above, augmented " +
                           std::to_string(stand.augmented) + ", slip " +
                           std::to_string(slip[0]) + ", " +
                           std::to_string(slip[1]));
              const SurfacePoint point =
                point_at(contact, stand, delta * slip[0], delta * slip[1]);
              const Gradient dT = derivative(contact, point);
              Gradient       difference;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  SurfacePoint plus = point, minus = point;
                  plus.u[c] += h;
                  minus.u[c] -= h;
                  const auto dT_c =
                    (traction(contact, plus) - traction(contact, minus)) /
                    (2. * h);
                  for (unsigned int i = 0; i < dim; ++i)
                    difference[i][c] = dT_c[i];
                }
              EXPECT_LE((dT - difference).norm(), 1e-6 * difference.norm());
            }
      }
  }



  // From where the skin is anchored to far away, in small steps in which it can
  // change by no more than its stiffness allows.
  TEST_P(ContactPoints, TractionIsContinuous)
  {
    constexpr unsigned int n = 400;
    for (const Grip &grip : grips)
      {
        const auto condition = contact_with(GetParam(), grip.text);
        const auto &contact  = dynamic_cast<const Contact &>(*condition);
        // Of pressure and of friction, whose traction across falls the faster
        // the more the limits differ.
        const double steepest = 30. * mu / thickness + 10. * 2.4 / delta;
        const auto   check    = [&](const auto &point_of) {
          Tensor<1, dim> last;
          for (unsigned int i = 0; i <= n; ++i)
            {
              const SurfacePoint point = point_of(double(i) / n);
              const Tensor<1, dim> T   = traction(contact, point);
              if (i > 0)
                {
                  const double way =
                    (point.u - point_of(double(i - 1) / n).u).norm();
                  EXPECT_LE((T - last).norm(), steepest * way)
                    << grip.what << " at " << double(i) / n;
                }
              last = T;
            }
        };
        for (const auto &slip : slips)
          check([&](const double part) {
            return point_at(contact,
                            stands[0],
                            part * delta * slip[0],
                            part * delta * slip[1]);
          });
        for (const double radius : {0.5, 1.5})
          check([&](const double part) {
            return point_at(contact,
                            stands[0],
                            radius * delta * std::cos(6.3 * part),
                            radius * delta * std::sin(6.3 * part));
          });
        for (const auto &slip : slips)
          check([&](const double part) {
            return point_at(contact,
                            {-0.02 + 0.15 * part, 0.},
                            delta * slip[0],
                            delta * slip[1]);
          });
      }
  }



  // After a load step what slid is about to slide, with the same traction, and
  // what stuck has not moved.
  TEST_P(ContactPoints, AnchorsFollowSoThatTheTractionStays)
  {
    for (const Grip &grip : grips)
      {
        const auto condition = contact_with(GetParam(), grip.text);
        const auto &contact  = dynamic_cast<const Contact &>(*condition);
        for (const auto &slip : slips)
          {
            SCOPED_TRACE(grip.what + ", slip " + std::to_string(slip[0]) + ", " +
                         std::to_string(slip[1]));
            SurfacePoint point =
              point_at(contact, stands[0], delta * slip[0], delta * slip[1]);
            const auto   before = contact.standing(point);
            const double p      = before.p;
            contact.remember(point, point.history);
            const auto after = contact.standing(point);
            EXPECT_NEAR(after.p, p, 1e-12 * p);
            // Where it bends the slip turns with the surface.
            const double turned =
              GetParam().name == "plane" ? 1e-10 : 0.3;
            EXPECT_LE((after.friction.T - before.friction.T).norm(),
                      turned * std::max(p, 1e-3));
            if (!before.friction.holds)
              continue;
            EXPECT_LE((after.friction.s - before.friction.kept).norm(),
                      turned * delta);
            if (!before.friction.slides)
              {
                EXPECT_LT((after.anchor - before.anchor).norm(), 1e-14);
              }
          }
      }
  }



  // The skin comes to lie on the surface with the pressure that it had.
  TEST_P(ContactPoints, AugmentingTakesThePressureOver)
  {
    const auto condition = contact_with(GetParam(), grips[2].text);
    const auto &contact  = dynamic_cast<const Contact &>(*condition);
    for (const Stand &stand : {stands[0], stands[1], stands[2]})
      {
        SurfacePoint point  = point_at(contact, stand, 0., 0.);
        const auto   before = contact.standing(point);
        EXPECT_EQ(contact.is_augmented(point),
                  std::abs(stand.lift) <= 1e-3 * thickness);
        point.u += contact.augment(point, point.history);
        const auto after = contact.standing(point);
        EXPECT_NEAR(after.gap, 0., 1e-13);
        EXPECT_NEAR(after.p, before.p, 1e-12);
        EXPECT_TRUE(contact.is_augmented(point));
      }
  }
} // namespace
