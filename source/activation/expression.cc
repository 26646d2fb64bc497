// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

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
      prm.add_parameter(
        "Formula",
        formula,
        "[1] The active stretch (less than 1 contracts) as a formula of the "
        "time t, the number s of the segment (from 1 at the head), the number "
        "n of segments, the reference position x, y, z, and pi.",
        dealii::Patterns::Anything());
    }

    void
    initialize(const std::string &muscle,
               const unsigned int n_segments) override
    {
      // s and n are constants to a parser, so each segment has its own.
      const std::string name = "Muscles/" + muscle + "/expression/Formula";
      lambda.clear();
      lambda.reserve(n_segments);
      for (unsigned int s = 1; s <= n_segments; ++s)
        lambda.emplace_back(name,
                            formula,
                            std::map<std::string, double>{
                              {"s", double(s)}, {"n", double(n_segments)}});
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
    std::string             formula = "1";
    std::vector<Expression> lambda;
  };



  static const Register<Activation, ExpressionActivation>
    expression_activation("expression",
                          "a formula of time, segment and position.");
} // namespace lumbricus
