// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/registry.h>

#include <vector>

namespace lumbricus
{
  /** lambda = a formula of t, s, n, x, y, z. */
  class ExpressionActivation : public Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      formula.declare_parameter(
        prm,
        "[1] The active stretch (less than 1 contracts) as a formula of the "
        "time t, the number s of the segment (from 1 at the head), the number "
        "n of segments, the reference position x, y, z, and pi.");
    }

    void
    initialize(const std::string & /*section*/,
               const Geometry &geometry) override
    {
      // s and n are constants to a parser, so each segment has its own.
      const unsigned int n = geometry.n_segments();
      lambda.clear();
      lambda.reserve(n);
      for (unsigned int s = 1; s <= n; ++s)
        lambda.push_back(formula.with({{"s", double(s)}, {"n", double(n)}}));
    }

    double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const override
    {
      Assert(1 <= segment && segment <= lambda.size(),
             dealii::ExcIndexRange(segment, 1, lambda.size() + 1));
      return lambda[segment - 1].value(X, t);
    }

  private:
    Expression              formula = {"Formula", "1", {{"s", 1.}, {"n", 1.}}};
    std::vector<Expression> lambda;
  };



  static const Register<Activation, ExpressionActivation>
    expression_activation("expression",
                          "a formula of time, segment and position.");
} // namespace lumbricus
