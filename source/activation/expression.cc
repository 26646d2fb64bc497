// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/geometry/segment_expression.h>
#include <lumbricus/parameters/registry.h>

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
        "[1] The active stretch (less than 1 contracts), or of an active stress "
        "the activation from 0 to 1, as a formula of the time t, the number s of the segment (from 1 at the head), the number "
        "n of segments, the reference position x, y, z, and pi.");
    }

    void
    initialize(const std::string & /*section*/,
               const Geometry &geometry) override
    {
      formula.initialize(geometry);
    }

    double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const override
    {
      return formula.of(segment - 1).value(X, t);
    }

  private:
    SegmentExpression formula = {"Formula", "1"};
  };



  static const Register<Activation, ExpressionActivation>
    expression_activation("expression",
                          "a formula of time, segment and position.");
} // namespace lumbricus
