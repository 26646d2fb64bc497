// SPDX-License-Identifier: LGPL-2.1-or-later
// What a tissue answers: its law and what its muscles do. A kind of muscle that
// the program does not have, an active stress, is added here by its own class
// alone.
#include <lumbricus/anatomy/muscle.h>
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/output/output_parts.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "read_plugin.h"
#include "sample_point.h"
#include "specimen.h"

using namespace lumbricus;
using namespace lumbricus::sample_point;
using dealii::Tensor;

namespace
{
  /**
   * The activation is a tension T per area at rest, and with the stretch l = |F
   * f| of the fibre
   *
   *   P = T s(l) F f x f / l,   s = 1 - ((l - 1)/w)^2,
   *
   * which is the derivative of T (l - (l - 1)^3/(3 w^2)).
   */
  class Pull : public MuscleAction
  {
  public:
    Pull()
      : MuscleAction("pull", 0., 1., "How the tension changes with time.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      MuscleAction::declare_parameters(prm);
      prm.add_parameter("Width",
                        w,
                        "[1] By how much it has to be stretched to be lame.",
                        dealii::Patterns::Double(0.1));
    }

    std::string
    requirement(const double T) const override
    {
      return T >= 0. ? "" : "a number >= 0";
    }

    double
    strength(const double T, const double /*tension*/) const override
    {
      return T;
    }

    void
    add_stress(const Tensor<2, dim> &F,
               const MuscleFibre    &fibre,
               const bool            with_tangent,
               MaterialResponse     &response) const override
    {
      const Tensor<1, dim> a = F * fibre.f;
      const double         l = a.norm(), e = (l - 1.) / w;
      const Tensor<1, dim> n       = a / l;
      const double         tension = fibre.activation * (1. - e * e);
      response.P += tension * dealii::outer_product(n, fibre.f);
      if (!with_tangent)
        return;
      const double slope = -2. * fibre.activation * e / w;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int L = 0; L < dim; ++L)
              response.A[dim * i + J][dim * k + L] +=
                (slope * n[i] * n[k] +
                 tension / l * ((i == k) - n[i] * n[k])) *
                fibre.f[J] * fibre.f[L];
    }

    static double
    energy(const double T, const double l, const double w)
    {
      return T * (l - std::pow(l - 1., 3) / (3. * w * w));
    }

  private:
    double w = 0.5;
  };

  const Register<MuscleAction, Pull>
    pull_action("pull", "a tension along its fibres.");



  // A tissue of a parameter file's text, with muscles of two actions.
  class Flesh
  {
  public:
    explicit Flesh(const std::string &muscles = "pull, shorten")
    {
      read(tissue,
           "set Muscles = " + muscles +
             "\nsubsection Neo-Hooke\n set a = 0.7\nend\n");
      read(pull,
           "set Fibres = direction\nset Action = pull\n"
           "set Width = 0.8\nset Pull = expression\n"
           "subsection direction\n set Direction = 0.6, 0, 0.8\nend\n"
           "subsection expression\n set Formula = 0.3*t\nend\n");
      read(shorten,
           "set Fibres = direction\nset Active stretch = expression\n"
           "subsection direction\n set Direction = 0, 1, 0\nend\n"
           "subsection expression\n set Formula = 1 - 0.2*t\nend\n");
      std::vector<const Muscle *> in_it;
      for (const std::string &name : tissue.muscle_names())
        in_it.push_back(name == "pull" ? &pull : &shorten);
      const auto bar = Registry<Geometry>::create("block");
      pull.initialize("Muscles/pull", *bar);
      shorten.initialize("Muscles/shorten", *bar);
      tissue.set_muscles(in_it);
    }

    // The point of the tissue at a time.
    MaterialPoint
    point(const double t) const
    {
      MaterialPoint point;
      for (const Muscle *muscle : tissue.muscles())
        point.fibres.push_back({muscle->fibre_direction({}),
                                muscle->activation(t, 1, {})});
      point.reference = tissue.reference_map(point.fibres, {});
      return point;
    }

    static void
    read(ParameterOwner &owner, const std::string &text)
    {
      dealii::ParameterHandler prm;
      owner.declare_parameters(prm);
      do
        prm.parse_input_from_string(text, "", true);
      while (owner.extend_parameters(prm, Extent::chosen));
      prm.parse_input_from_string(text);
      owner.check_parameters();
    }

    Tissue tissue{"flesh"};
    Muscle pull{"pull"}, shorten{"shorten"};
  };
} // namespace



TEST(Tissues, MapIsThatOfTheMusclesThatShorten)
{
  const Flesh         flesh;
  const MaterialPoint point = flesh.point(0.5);
  EXPECT_EQ(point.fibres[0].activation, 0.15);
  EXPECT_EQ(point.fibres[1].activation, 0.9);
  const ReferencePoint map =
    active_stretch_map({{flesh.shorten.fibre_direction({}), 0.9}});
  EXPECT_EQ((point.reference.G_inverse - map.G_inverse).norm(), 0.);
  EXPECT_EQ(point.reference.J_v, 1.);

  // Without one that shortens it is the identity, to the last bit.
  const auto rest = Flesh("pull").point(0.5).reference;
  EXPECT_EQ((rest.G_inverse - ReferencePoint().G_inverse).norm(), 0.);
}



TEST(Tissues, GrowthMakesTheStressFreeVolume)
{
  // theta I, and I + (theta - 1) f x f, are J_v^(1/3) G.
  const dealii::Tensor<1, dim> f({0.6, 0., 0.8});
  const double                 theta = 1.3;
  const auto                   I = dealii::unit_symmetric_tensor<dim, double>();
  const auto                   ff =
    dealii::symmetrize(dealii::outer_product(f, f));
  for (const bool along : {false, true})
    {
      const auto grows =
        Registry<MuscleAction>::create(along ? "growth along fibres" : "growth");
      std::vector<ActiveFibre> stretches;
      grows->add_stretch({f, theta}, stretches);
      const ReferencePoint   map = active_stretch_map(stretches);
      dealii::Tensor<2, dim> shape =
        along ? I + (theta - 1.) * ff : theta * I;
      EXPECT_NEAR(map.J_v, determinant(shape), 1e-14);
      EXPECT_NEAR(determinant(map.G_inverse), 1., 1e-14);
      EXPECT_LT((std::cbrt(map.J_v) * invert(map.G_inverse) - shape).norm(),
                1e-14);

      // In that shape the tissue is free of stress and has no other volume.
      const Flesh      flesh("shorten");
      MaterialPoint    point;
      MaterialResponse response;
      point.reference = map;
      flesh.tissue.law().evaluate(shape, 0., point.reference, false, response);
      EXPECT_LT(response.P.norm(), 1e-14);
      EXPECT_NEAR(response.c, 0., 1e-14);
    }
}



TEST(Tissues, ResponseOfGrownTissueIsTheDerivativeOfItsEnergy)
{
  // P, A, Q, c and dc/dp where growth in both ways and a contraction have made G and
  // J_v, with nu = 0.5 and less.
  const dealii::Tensor<1, dim> f({0.6, 0., 0.8}), g({0., 1., 0.});
  std::vector<ActiveFibre>     stretches;
  Registry<MuscleAction>::create("growth")->add_stretch({f, 1.2}, stretches);
  Registry<MuscleAction>::create("growth along fibres")
    ->add_stretch({f, 1.3}, stretches);
  Registry<MuscleAction>::create("active stretch")->add_stretch({g, 0.9}, stretches);
  MaterialPoint point;
  point.reference = active_stretch_map(stretches);
  EXPECT_NEAR(point.reference.J_v, std::pow(1.2, 3) * 1.3, 1e-14);
  EXPECT_NEAR(determinant(point.reference.G_inverse), 1., 1e-14);
  for (const std::string nu : {"0.5", "0.4"})
    {
      Tissue tissue("grown");
      Flesh::read(tissue,
                  "set Law = Mooney-Rivlin\nsubsection Mooney-Rivlin\n"
                  " set a = 0.4\n set b = 0.2\n set nu = " +
                    nu + "\nend\n");
      tissue.set_muscles({});
      MaterialResponse at, plus, minus;
      tissue.evaluate(F_general, p, point, true, at);
      const auto energy = [&](const Tensor<2, dim> &F, const double p) {
        return tissue.energy(F, p, point.reference);
      };
      EXPECT_NEAR(at.c,
                  (energy(F_general, p + h) - energy(F_general, p - h)) / (2 * h),
                  1e-9);
      tissue.evaluate(F_general, p + h, point, false, plus);
      tissue.evaluate(F_general, p - h, point, false, minus);
      EXPECT_NEAR(at.dc_dp, (plus.c - minus.c) / (2 * h), 1e-9);
      EXPECT_LT((at.Q - (plus.P - minus.P) / (2 * h)).norm(), 1e-9);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int L = 0; L < dim; ++L)
          {
            Tensor<2, dim> F_plus = F_general, F_minus = F_general;
            F_plus[k][L] += h;
            F_minus[k][L] -= h;
            EXPECT_NEAR(at.P[k][L],
                        (energy(F_plus, p) - energy(F_minus, p)) / (2 * h),
                        1e-8);
            tissue.evaluate(F_plus, p, point, false, plus);
            tissue.evaluate(F_minus, p, point, false, minus);
            EXPECT_NEAR(at.Q[k][L], (plus.c - minus.c) / (2 * h), 1e-8);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int J = 0; J < dim; ++J)
                EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                            (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                            1e-7);
          }
    }
}



TEST(Tissues, ResponseIsThatOfLawAndMuscles)
{
  // Bit for bit the law's where muscles only shorten.
  const Flesh         shortens("shorten");
  const MaterialPoint point = shortens.point(0.5);
  MaterialResponse    law, all;
  shortens.tissue.law().evaluate(F_general, p, point.reference, true, law);
  shortens.tissue.evaluate(F_general, p, point, true, all);
  EXPECT_EQ((all.P - law.P).norm(), 0.);
  EXPECT_EQ((all.Q - law.Q).norm(), 0.);
  EXPECT_EQ(all.c, law.c);
  for (unsigned int iJ = 0; iJ < dim * dim; ++iJ)
    for (unsigned int kL = 0; kL < dim * dim; ++kL)
      EXPECT_EQ(all.A[iJ][kL], law.A[iJ][kL]);

  // A muscle that pulls adds to the stress, and not to the volume.
  const Flesh         both;
  const MaterialPoint pulled = both.point(0.5);
  both.tissue.law().evaluate(F_general, p, pulled.reference, true, law);
  both.tissue.evaluate(F_general, p, pulled, true, all);
  const Tensor<1, dim> f = pulled.fibres[0].f, a = F_general * f;
  const double         l = a.norm();
  const double         s = 1. - std::pow((l - 1.) / 0.8, 2);
  const auto expected    = law.P + 0.15 * s / l * dealii::outer_product(a, f);
  EXPECT_NEAR((all.P - expected).norm(), 0., 1e-15);
  EXPECT_GT((all.P - law.P).norm(), 0.1);
  EXPECT_EQ((all.Q - law.Q).norm(), 0.);
  EXPECT_EQ(all.c, law.c);
}



TEST(Tissues, StressAndTangentAreDerivatives)
{
  const Flesh         flesh;
  const MaterialPoint point = flesh.point(1.);
  const double        T     = point.fibres[0].activation;
  EXPECT_EQ(T, 0.3);
  const auto energy = [&](const Tensor<2, dim> &F) {
    return flesh.tissue.law().energy(F, p, point.reference) +
           Pull::energy(T, (F * point.fibres[0].f).norm(), 0.8);
  };
  MaterialResponse at, plus, minus;
  flesh.tissue.evaluate(F_general, p, point, true, at);
  for (unsigned int k = 0; k < dim; ++k)
    for (unsigned int L = 0; L < dim; ++L)
      {
        Tensor<2, dim> F_plus = F_general, F_minus = F_general;
        F_plus[k][L] += h;
        F_minus[k][L] -= h;
        EXPECT_NEAR(at.P[k][L],
                    (energy(F_plus) - energy(F_minus)) / (2 * h),
                    1e-9);
        flesh.tissue.evaluate(F_plus, p, point, false, plus);
        flesh.tissue.evaluate(F_minus, p, point, false, minus);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            {
              EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                          (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                          1e-7);
              EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                          at.A[dim * k + L][dim * i + J],
                          1e-13);
            }
      }
}



TEST(Tissues, PulledBarHasTheClosedForm)
{
  // A bar of incompressible rubber whose fibres are at the angle of f to x:
  // stretched by l along them and free across,
  //   sigma = a (l^2 - 1/l) + T s(l) l.
  const Flesh          flesh("pull");
  const MaterialPoint  point = flesh.point(1.);
  const Tensor<1, dim> f     = point.fibres[0].f;
  const auto           ff    = dealii::outer_product(f, f);
  const Tensor<2, dim> I     = dealii::unit_symmetric_tensor<dim>();
  for (const double l : {0.6, 0.9, 1., 1.4})
    {
      const Tensor<2, dim> F = l * ff + (I - ff) / std::sqrt(l);
      MaterialResponse     response;
      flesh.tissue.evaluate(F, 0., point, false, response);
      Tensor<2, dim> sigma = response.P * transpose(F);
      sigma -= sigma[1][1] * I; // the pressure that frees it across
      const double s = 1. - std::pow((l - 1.) / 0.8, 2);
      const auto   expected =
        (0.7 * (l * l - 1. / l) + point.fibres[0].activation * s * l) * ff;
      EXPECT_NEAR((sigma - expected).norm(), 0., 1e-14) << l;
    }
}



TEST(Tissues, MessagesNameWhatTheMuscleHas)
{
  const Flesh       flesh;
  const std::string message =
    input_error([&]() { flesh.pull.activation(-1., 1, {}); });
  EXPECT_TRUE(contains(message, "The pull of muscle 'pull'"))
    << message;
  EXPECT_TRUE(contains(message, "is -0.3; it has to be a number >= 0"))
    << message;
  EXPECT_TRUE(contains(message, "'Muscles/pull/expression'")) << message;
  const LoadCurve curve = flesh.pull.load_curve(1, {{}});
  EXPECT_EQ(curve.what, "the pull of muscle 'pull'");
  EXPECT_EQ(curve.at_rest, 0.);
  EXPECT_EQ(flesh.shorten.load_curve(1, {{}}).at_rest, 1.);
}



TEST(Tissues, PullThroughoutTheProgram)
{
  // From the file to residual, tangent, fields and equilibrium of a free bar.
  const std::string text = R"(
subsection Geometry
  set Shape = block
  subsection block
    set Lengths     = 2, 1, 1
    set Cells       = 2, 1, 1
    set Tissue name = flesh
  end
end
subsection Tissues
  subsection flesh
    set Muscles = pull
    subsection Neo-Hooke
      set a = 0.7
    end
  end
end
subsection Muscles
  subsection pull
    set Fibres = direction
    set Action = pull
    set Pull   = expression
    subsection direction
      set Direction = 1, 0, 0
    end
    subsection expression
      set Formula = 0.2*t
    end
  end
end
)";
  Specimen          body(text);
  ChainModel       &model = *body.model;
  body.state.time         = 0.5;
  model.references.update(body.state);
  const auto residual = [&](const Vector &u) {
    Vector r(model.space.locally_owned, body.comm);
    EXPECT_TRUE(model.assembler.residual(u, 0.5, r).valid());
    return r;
  };
  model.equilibrium.set_time(0.5, body.state.solution);
  model.equilibrium.start_from(body.state.solution);
  EXPECT_GT(residual(body.state.solution).l2_norm(), 1e-3);

  const Vector u = body.random(0.01, 1), d = body.random(1., 2);
  model.assembler.linearise(u, 0.5);
  const Tangent &tangent   = model.assembler.tangent();
  const auto     free_part = [&](const Vector &v) {
    Vector result;
    result.reinit(model.assembler.right_hand_side());
    const auto &constrained = tangent.unknowns.is_constrained();
    for (unsigned int i = 0; i < constrained.size(); ++i)
      result.local_element(i) = constrained[i] ? 0. : v.begin()[i];
    return result;
  };
  const double step = 1e-6;
  Vector       plus = u, minus = u;
  plus.add(step, d);
  minus.add(-step, d);
  Vector difference = residual(plus);
  difference.add(-1., residual(minus));
  difference /= 2. * step;
  Vector       Kd       = free_part(d);
  const Vector expected = free_part(difference);
  tangent.vmult(Kd, free_part(d));
  Kd -= expected;
  EXPECT_LT(Kd.l2_norm(), 1e-7 * expected.l2_norm());

  const auto &arrays = body.parameters.output_parts.field_arrays();
  EXPECT_EQ(std::count_if(arrays.begin(),
                          arrays.end(),
                          [](const FieldArray &array) {
                            return array.name == "pull_pull";
                          }),
            1);

  // Its length l at rest is where 0 = a (l^2 - 1/l) + T s(l) l.
  model.solve(body.state);
  double l = 0.5, longer = 1.;
  while (longer - l > 1e-13)
    {
      const double middle = (l + longer) / 2.;
      const double s      = 1. - std::pow((middle - 1.) / 0.5, 2);
      const double stress =
        0.7 * (middle * middle - 1. / middle) + 0.1 * s * middle;
      (stress < 0. ? l : longer) = middle;
    }
  EXPECT_LT(l, 0.97);
  const Vector solution = model.space.with_ghosts(body.state.solution);
  double       least = 1e9, most = -1e9;
  std::vector<dealii::types::global_dof_index> indices(
    model.space.fe.n_dofs_per_cell());
  for (const auto &cell : model.space.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        cell->get_dof_indices(indices);
        for (const unsigned int k : model.space.displacement_dof[0])
          {
            least = std::min<double>(least, solution(indices[k]));
            most  = std::max<double>(most, solution(indices[k]));
          }
      }
  least = dealii::Utilities::MPI::min(least, body.comm);
  most  = dealii::Utilities::MPI::max(most, body.comm);
  EXPECT_NEAR(most - least, 2. * (1. - l), 1e-7);
}



TEST(Tissues, ElasticFibresHaveAnEnergy)
{
  // Families that cross, one of them dispersed, beside a law with fibres of its
  // own, in a muscle that has contracted and in a body that has grown.
  Tissue tissue("crossed");
  Flesh::read(tissue,
              "set Law = Guccione\nsubsection Guccione\n set C = 0.2\n"
              " set b_f = 1.1\nend\n"
              "subsection Elastic fibres\n set Names = one, other\n"
              " subsection one\n  set Fibres = direction\n  set k1 = 0.4\n"
              "  set k2 = 0.7\n"
              "  subsection direction\n   set Direction = 0.8, 0.6, 0\n  end\n"
              " end\n"
              " subsection other\n  set Fibres = direction\n  set k1 = 0.3\n"
              "  set k2 = 0\n  set kappa = 0.1\n"
              "  subsection direction\n   set Direction = 0.8, -0.6, 0\n  end\n"
              " end\nend\n"
              "subsection Fibre couplings\n set Names = both\n"
              " subsection both\n  set Between = other, one\n  set a = 0.5\n"
              "  set b = 0.6\n end\nend\n");
  tissue.set_muscles({});
  tissue.initialize("Tissues/crossed", *Registry<Geometry>::create("block"));
  const auto fibres = tissue.elastic_fibres({});
  ASSERT_EQ(fibres.size(), 3u);
  EXPECT_EQ(fibres[0][0], 1.);
  EXPECT_NEAR(fibres[2][1], -0.6, 1e-15);

  Tensor<1, dim> f;
  f[0] = 0.6;
  f[2] = 0.8;
  for (const double lambda : {1., 0.8})
    for (const double J_v : {1., 0.9})
      {
        MaterialPoint point;
        point.reference     = active_stretch_map({{f, lambda}});
        point.reference.J_v = J_v;
        const auto G        = invert(point.reference.G_inverse);
        for (const auto &fibre : fibres)
          point.reference.fibres.push_back(G * fibre);

        // Free of stress in the shape that is.
        MaterialResponse at, plus, minus;
        tissue.evaluate(std::cbrt(J_v) * G, 0., point, false, at);
        EXPECT_NEAR(at.P.norm(), 0., 1e-14);

        tissue.evaluate(F_general, p, point, true, at);
        MaterialResponse law;
        tissue.law().evaluate(F_general, p, point.reference, false, law);
        EXPECT_GT((at.P - law.P).norm(), 0.05);
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            {
              Tensor<2, dim> F_plus = F_general, F_minus = F_general;
              F_plus[k][L] += h;
              F_minus[k][L] -= h;
              EXPECT_NEAR(at.P[k][L],
                          (tissue.energy(F_plus, p, point.reference) -
                           tissue.energy(F_minus, p, point.reference)) /
                            (2 * h),
                          1e-8);
              tissue.evaluate(F_plus, p, point, false, plus);
              tissue.evaluate(F_minus, p, point, false, minus);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int J = 0; J < dim; ++J)
                  EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                              (plus.P[i][J] - minus.P[i][J]) / (2 * h),
                              1e-6);
            }
      }
}



TEST(Tissues, FibreCouplingResistsShear)
{
  // In simple shear by g, f at rest and s sheared towards it, I8 = f . F s = g, and
  // the energy a/(2 b) (exp(b g^2) - 1) is felt either way, whatever the sign of
  // the vectors.
  const double a = 0.4, b = 1.3;
  for (const std::string turned : {"0, 1, 0", "0, -1, 0"})
    {
      const auto read = [&](Tissue &tissue, const std::string &more) {
        Flesh::read(tissue,
                    "subsection Elastic fibres\n set Names = f, s\n"
                    " subsection f\n  set Fibres = direction\n"
                    "  subsection direction\n   set Direction = 1, 0, 0\n  end\n"
                    " end\n"
                    " subsection s\n  set Fibres = direction\n"
                    "  subsection direction\n   set Direction = " +
                      turned + "\n  end\n end\nend\n" + more);
        tissue.set_muscles({});
        tissue.initialize("Tissues/sheared",
                          *Registry<Geometry>::create("block"));
      };
      Tissue without("without"), with("with");
      read(without, "");
      read(with,
           "subsection Fibre couplings\n set Names = c\n subsection c\n"
           "  set Between = f, s\n  set a = 0.4\n  set b = 1.3\n end\nend\n");
      MaterialPoint point;
      for (const auto &fibre : with.elastic_fibres({}))
        point.reference.fibres.push_back(fibre);
      for (const double g : {-0.5, 1e-3, 0.7})
        {
          Tensor<2, dim> F = dealii::unit_symmetric_tensor<dim>();
          F[0][1]          = g;
          EXPECT_NEAR(with.energy(F, 0., point.reference) -
                        without.energy(F, 0., point.reference),
                      a / (2. * b) * std::expm1(b * g * g),
                      1e-15);
          MaterialResponse one, other;
          with.evaluate(F, 0., point, false, one);
          without.evaluate(F, 0., point, false, other);
          const Tensor<2, dim> P     = one.P - other.P;
          const double         slope = a * g * std::exp(b * g * g);
          EXPECT_NEAR(P[0][1], slope, 1e-15);
          EXPECT_NEAR(P[1][0], slope, 1e-15);
          EXPECT_NEAR(P[0][0], g * slope, 1e-15);
        }
    }
}
