// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws and reference maps as tensors: against finite differences and closed
// forms.
#include <lumbricus/materials/flowing_liquid.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/reference_map/active_stretch.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <gtest/gtest.h>

#include <cmath>

#include "read_plugin.h"
#include "sample_point.h"

using namespace lumbricus;
using namespace lumbricus::sample_point;
using dealii::Tensor;

namespace
{
  const Gradient F_rest =
    gradient({0.9, -0.1, 0.2, 0.05, 1.2, 0.1, 0.15, -0.2, 1.05});

  struct Law
  {
    std::string name;
    std::string parameters;
  };

  // All laws, incompressible and not.
  const std::vector<Law> laws = {{"Neo-Hooke", "set a = 0.7"},
                                 {"Neo-Hooke", "set a = 0.7\nset nu = 0.45"},
                                 {"Mooney-Rivlin", "set a = 0.5\nset b = 0.3"},
                                 {"Mooney-Rivlin",
                                  "set a = 0.5\nset b = 0.3\nset nu = 0.4"},
                                 {"Yeoh",
                                  "set C1 = 0.3\nset C2 = -0.02\nset C3 = 0.01"},
                                 {"Yeoh", "set C2 = 0.4\nset nu = 0.45"},
                                 {"Gent", "set mu = 0.7\nset J_m = 3"},
                                 // Beyond its end: I1 - 3 is 0.59 there.
                                 {"Gent", "set mu = 2e-5\nset J_m = 0.4"},
                                 {"Demiray", "set a = 0.7\nset b = 0.6"},
                                 {"Ogden",
                                  "set Moduli = 0.63, 0.0012, -0.01\n"
                                  "set Exponents = 1.3, 5, -2"},
                                 {"Ogden",
                                  "set Moduli = -0.3\nset Exponents = -4\n"
                                  "set nu = 0.4"},
                                 {"Guccione",
                                  "set C = 0.2\nset b_f = 1.1\nset b_t = 0.4\n"
                                  "set b_fs = 0.6"},
                                 {"Guccione",
                                  "set C = 0.2\nset b_f = 0.4\nset b_t = 0.9\n"
                                  "set b_fs = 0.3\nset nu = 0.4"},
                                 {"Hooke", "set E = 0.7"},
                                 {"Hooke", "set E = 0.7\nset nu = 0.3"}};

  const Gradient unit = dealii::unit_symmetric_tensor<dim>();

  std::vector<ReferencePoint>
  reference_points()
  {
    Tensor<1, dim> f;
    f[0] = 0.6;
    f[2] = 0.8;
    std::vector<ReferencePoint> points = {ReferencePoint(),
                                          active_stretch_map({{f, 0.7}}),
                                          rest_shape_map(F_rest, unit),
                                          rest_shape_map(F_rest, F_rest)};
    // For laws with fibres.
    Tensor<1, dim> g;
    g[0] = 0.36;
    g[1] = -0.48;
    g[2] = 0.8;
    for (ReferencePoint &point : points)
      point.fibres = {invert(point.G_inverse) * g};
    return points;
  }
} // namespace



TEST(Laws, StressIsTheDerivativeOfTheEnergy)
{
  for (const Law &which : laws)
    for (const ReferencePoint &reference : reference_points())
      {
        const auto law = read_plugin<MaterialLaw>(which.name, which.parameters);
        MaterialResponse response;
        law->evaluate(F_general, p, reference, false, response);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            {
              Gradient plus = F_general, minus = F_general;
              plus[i][J] += h;
              minus[i][J] -= h;
              const double difference = (law->energy(plus, p, reference) -
                                         law->energy(minus, p, reference)) /
                                        (2 * h);
              EXPECT_NEAR(response.P[i][J], difference, 1e-8) << which.name;
            }
        const double c = (law->energy(F_general, p + h, reference) -
                          law->energy(F_general, p - h, reference)) /
                         (2 * h);
        EXPECT_NEAR(response.c, c, 1e-9);
      }
}



TEST(Laws, TangentIsTheDerivativeOfTheStress)
{
  for (const Law &which : laws)
    for (const ReferencePoint &reference : reference_points())
      {
        const auto law = read_plugin<MaterialLaw>(which.name, which.parameters);
        MaterialResponse at, plus, minus;
        law->evaluate(F_general, p, reference, true, at);
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            {
              Gradient F_plus = F_general, F_minus = F_general;
              F_plus[k][L] += h;
              F_minus[k][L] -= h;
              law->evaluate(F_plus, p, reference, false, plus);
              law->evaluate(F_minus, p, reference, false, minus);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int J = 0; J < dim; ++J)
                  {
                    EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                                (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                                1e-6)
                      << which.name << i << J << k << L;
                    EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                                at.A[dim * k + L][dim * i + J],
                                1e-12);
                  }
              EXPECT_NEAR(at.Q[k][L], (plus.c - minus.c) / (2 * h), 1e-8);
            }
        law->evaluate(F_general, p + h, reference, false, plus);
        law->evaluate(F_general, p - h, reference, false, minus);
        EXPECT_NEAR(((plus.P - minus.P) / (2 * h) - at.Q).norm(), 0., 1e-8);
        EXPECT_NEAR((plus.c - minus.c) / (2 * h), at.dc_dp, 1e-9);
      }
}



TEST(Laws, UniaxialTensionHasTheClosedForm)
{
  // sigma = (a + b/lambda)(lambda^2 - 1/lambda)
  const double a = 0.5, b = 0.3;
  const auto   law =
    read_plugin<MaterialLaw>("Mooney-Rivlin", "set a = 0.5\nset b = 0.3");
  for (const double lambda : {0.5, 0.9, 1.5, 3.})
    {
      const double     across = 1. / std::sqrt(lambda);
      const Gradient   F = gradient({lambda, 0, 0, 0, across, 0, 0, 0, across});
      MaterialResponse response;
      law->evaluate(F, 0., ReferencePoint(), false, response);
      const Gradient sigma = response.P * transpose(F);
      EXPECT_NEAR(sigma[0][0] - sigma[1][1],
                  (a + b / lambda) * (lambda * lambda - 1. / lambda),
                  1e-12);
    }
}



TEST(Laws, OgdenIsSmoothWhereStretchesAreEqual)
{
  // The tangent is the derivative of the stress at rest, where two stretches
  // are equal, and where they are so but for rounding.
  const auto law = read_plugin<MaterialLaw>(
    "Ogden", "set Moduli = 0.63, 0.0012, -0.01\nset Exponents = 1.3, 5, -2");
  for (const double other : {1., 1.3, 1.3 + 4e-16, 1.3 + 1e-12, 1.3 + 1e-7})
    {
      const Gradient   F = gradient({other, 0, 0, 0, 1.3, 0, 0, 0, 1.});
      MaterialResponse at, plus, minus;
      for (const Gradient &deformation : {F, Gradient(unit)})
        {
          law->evaluate(deformation, p, ReferencePoint(), true, at);
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int L = 0; L < dim; ++L)
              {
                Gradient F_plus = deformation, F_minus = deformation;
                F_plus[k][L] += h;
                F_minus[k][L] -= h;
                law->evaluate(F_plus, p, ReferencePoint(), false, plus);
                law->evaluate(F_minus, p, ReferencePoint(), false, minus);
                for (unsigned int i = 0; i < dim; ++i)
                  for (unsigned int J = 0; J < dim; ++J)
                    EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                                (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                                1e-8);
              }
        }
    }
}



TEST(Laws, OgdenIncludesMooneyRivlin)
{
  const auto ogden = read_plugin<MaterialLaw>(
    "Ogden", "set Moduli = 0.5, -0.3\nset Exponents = 2, -2");
  const auto mooney =
    read_plugin<MaterialLaw>("Mooney-Rivlin", "set a = 0.5\nset b = 0.3");
  EXPECT_NEAR(ogden->shear_modulus(), mooney->shear_modulus(), 1e-15);
  MaterialResponse one, other;
  for (const ReferencePoint &reference : reference_points())
    {
      ogden->evaluate(F_general, p, reference, true, one);
      mooney->evaluate(F_general, p, reference, true, other);
      EXPECT_NEAR((one.P - other.P).norm(), 0., 1e-13);
      for (unsigned int i = 0; i < dim * dim; ++i)
        for (unsigned int k = 0; k < dim * dim; ++k)
          EXPECT_NEAR(one.A[i][k], other.A[i][k], 1e-12);
    }
}



TEST(Laws, AreObjective)
{
  // P(R F) = R P(F) for a rotation R.
  const double   s = 0.6, c = 0.8;
  const Gradient R = gradient({c, -s, 0, s, c, 0, 0, 0, 1});
  for (const Law &which : laws)
    for (const ReferencePoint &reference : reference_points())
      {
        if (which.name == "Hooke") // which is what is wrong with it
          continue;
        const auto law = read_plugin<MaterialLaw>(which.name, which.parameters);
        MaterialResponse response, rotated;
        law->evaluate(F_general, p, reference, false, response);
        law->evaluate(R * F_general, p, reference, false, rotated);
        EXPECT_NEAR((rotated.P - R * response.P).norm(), 0., 1e-13);
      }
}



TEST(Laws, BulkModulusFollowsFromPoissonsRatio)
{
  const auto law =
    read_plugin<MaterialLaw>("Neo-Hooke", "set a = 0.7\nset nu = 0.45");
  MaterialResponse response;
  law->evaluate(F_general, p, ReferencePoint(), false, response);
  const double kappa = 2 * 0.7 * 1.45 / (3 * 0.1);
  EXPECT_NEAR(response.dc_dp, -1 / kappa, 1e-14);
  const auto incompressible = read_plugin<MaterialLaw>("Neo-Hooke", "");
  incompressible->evaluate(F_general, p, ReferencePoint(), false, response);
  EXPECT_EQ(response.dc_dp, 0.);
}



TEST(ActiveStretch, FreeMuscleTakesItsActiveLength)
{
  // With F = G there is no stress but pressure.
  Tensor<1, dim> f, g;
  f[0]                                                 = 1.;
  g[1]                                                 = 0.6;
  g[2]                                                 = 0.8;
  const std::vector<std::vector<ActiveFibre>> families = {{{f, 0.7}},
                                                          {{g, 1.3}},
                                                          {{f, 0.7}, {g, 1.2}},
                                                          {{f, 0.9}, {f, 0.8}}};
  for (const auto &fibres : families)
    {
      const ReferencePoint reference = active_stretch_map(fibres);
      EXPECT_NEAR(determinant(reference.G_inverse), 1., 1e-14);
      EXPECT_EQ(reference.J_v, 1.);
      const auto law =
        read_plugin<MaterialLaw>("Mooney-Rivlin", "set a = 0.5\nset b = 0.3");
      MaterialResponse response;
      law->evaluate(
        invert(reference.G_inverse), 0., reference, false, response);
      EXPECT_NEAR(response.P.norm(), 0., 1e-14);
    }
  // One family: the fibre has exactly its active length.
  const auto one = active_stretch_map({{g, 0.8}});
  EXPECT_NEAR((invert(one.G_inverse) * g - 0.8 * g).norm(), 0., 1e-14);
  // Twice the same family: the product of the stretches.
  const auto twice = active_stretch_map({{g, 0.9}, {g, 0.8}});
  EXPECT_NEAR((invert(twice.G_inverse) * g - 0.72 * g).norm(), 0., 1e-14);
}



TEST(ActiveStretch, FamiliesCommute)
{
  Tensor<1, dim> f, g;
  f[0]          = 1.;
  g[0]          = 0.6;
  g[1]          = 0.8;
  const auto fg = active_stretch_map({{f, 0.7}, {g, 1.2}});
  const auto gf = active_stretch_map({{g, 1.2}, {f, 0.7}});
  EXPECT_NEAR((fg.G_inverse - gf.G_inverse).norm(), 0., 1e-14);
}



TEST(ActiveStretch, HeldMuscleHasTheClosedFormStress)
{
  // Held at its rest length, free across: sigma = a (1/l^2 - l).
  Tensor<1, dim> f;
  f[0] = 1.;
  for (const double l : {0.7, 0.9, 1.2})
    {
      const auto       law = read_plugin<MaterialLaw>("Neo-Hooke", "set a = 2");
      MaterialResponse response;
      law->evaluate(Gradient(dealii::unit_symmetric_tensor<dim>()),
                    0.,
                    active_stretch_map({{f, l}}),
                    false,
                    response);
      EXPECT_NEAR(response.P[0][0] - response.P[1][1],
                  2 * (1 / (l * l) - l),
                  1e-13);
    }
}



TEST(Reset, ShearIsGoneWhileVolumeAndPressureStay)
{
  // At fixed u: after an isochoric reset to the present shape the deviator is
  // zero, J and c are what they were, and so is the pressure.
  for (const std::string nu : {"0.5", "0.49"})
    {
      const auto law =
        read_plugin<MaterialLaw>("Neo-Hooke", "set a = 0.7\nset nu = " + nu);
      MaterialResponse before, after;
      law->evaluate(F_general, p, ReferencePoint(), false, before);
      const auto reference = rest_shape_map(F_general, unit);
      EXPECT_NEAR(determinant(reference.G_inverse), 1., 1e-14);
      law->evaluate(F_general, p, reference, false, after);
      const double   J     = determinant(F_general);
      const Gradient sigma = after.P * transpose(F_general) / J;
      EXPECT_NEAR(
        (sigma - p * Gradient(dealii::unit_symmetric_tensor<dim>())).norm(),
        0.,
        1e-14);
      EXPECT_NEAR(after.c, before.c, 1e-15);
    }
}



TEST(Reset, FullResetForgetsTheVolumeToo)
{
  const auto law =
    read_plugin<MaterialLaw>("Neo-Hooke", "set a = 0.7\nset nu = 0.49");
  MaterialResponse after;
  const auto       reference = rest_shape_map(F_general, F_general);
  EXPECT_NEAR(reference.J_v, determinant(F_general), 1e-15);
  law->evaluate(F_general, 0., reference, false, after);
  EXPECT_NEAR(after.P.norm(), 0., 1e-14);
  EXPECT_NEAR(after.c, 0., 1e-15);
}



TEST(FlowingLiquid, HasTheResponseOfAResetShape)
{
  for (const Law &which : laws)
    {
      const auto law = read_plugin<MaterialLaw>(which.name, which.parameters);
      if (!law->may_flow())
        continue;
      // What is free of shear at F_general, with another stress-free volume.
      const auto       reference = rest_shape_map(F_general, F_rest);
      MaterialResponse reset, flowing;
      law->evaluate(F_general, p, reference, true, reset);
      flowing_response(*law, F_general, p, reference.J_v, true, flowing);
      EXPECT_NEAR((flowing.P - reset.P).norm(), 0., 1e-14);
      EXPECT_NEAR(flowing.c, reset.c, 1e-14);
      EXPECT_EQ(flowing.dc_dp, reset.dc_dp);

      // With what a preconditioner has more, A is that of twice the modulus.
      const double J = determinant(F_general);
      double       A[dim * dim][dim * dim];
      for (unsigned int a = 0; a < dim * dim; ++a)
        for (unsigned int b = 0; b < dim * dim; ++b)
          A[a][b] = flowing.A[a][b];
      add_shear_stiffness(flowing.mu_missing / J, flowing.Q, A);
      add_shear_stiffness(-law->shear_modulus() / J, flowing.Q, A);
      MaterialResponse twice;
      // Of a reset shape with the volume that it has.
      law->evaluate(
        F_general, p, rest_shape_map(F_general, F_general), true, twice);
      for (unsigned int a = 0; a < dim * dim; ++a)
        for (unsigned int b = 0; b < dim * dim; ++b)
          EXPECT_NEAR(A[a][b], twice.A[a][b], 1e-13) << which.name;
    }
}



TEST(FlowingLiquid, ResistsShearByATenThousandthOfItsModulusInTheTangentAlone)
{
  const auto law = read_plugin<MaterialLaw>("Mooney-Rivlin",
                                            "set a = 0.5\nset b = 0.3");
  MaterialResponse response;
  flowing_response(*law, F_general, p, 1., true, response);
  add_shear_stiffness(-1e-4 * law->shear_modulus() / determinant(F_general),
                      response.Q,
                      response.A);
  for (unsigned int k = 0; k < dim; ++k)
    for (unsigned int L = 0; L < dim; ++L)
      {
        MaterialResponse plus, minus;
        for (const double sign : {1., -1.})
          {
            Gradient F = F_general;
            F[k][L] += sign * h;
            flowing_response(
              *law, F, p, 1., false, sign > 0. ? plus : minus);
          }
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            EXPECT_NEAR(response.A[dim * i + J][dim * k + L],
                        (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                        1e-8);
      }
}
