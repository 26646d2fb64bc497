// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_exchange.h>
#include <lumbricus/core/exceptions.h>

namespace lumbricus
{
  namespace
  {
    double
    conductance(const SegmentExpression &expression,
                const unsigned int       segment,
                const double             t)
    {
      const double g = expression.value(segment, t);
      AssertThrow(g >= 0.,
                  ExcParameter(expression.parameter(),
                               expression.value_text(segment,
                                                     t,
                                                     "mm^5/(N s)") +
                                 ", but nothing flows from low to high "
                                 "pressure. Give at least 0."));
      return g;
    }
  } // namespace



  void
  CavityExchange::declare_parameters(dealii::ParameterHandler &prm)
  {
    pores.declare_parameter(
      prm,
      "[mm^5/(N time)] What flows from a cavity into the next one towards the "
      "tail for a unit of pressure between them: a formula of the time t, the "
      "number s of the segment nearer to the head (from 1) and the number n of "
      "segments; 0 for closed septa.");
    leak.declare_parameter(
      prm,
      "[mm^5/(N time)] What flows out of the body for a unit of pressure in a "
      "cavity: a formula of t, s and n.");
    inflow.declare_parameter(
      prm,
      "[mm^3/time] What flows into the cavity from outside, whatever its "
      "pressure: a formula of t, s and n.");
  }



  void
  CavityExchange::initialize(const Geometry &geometry)
  {
    pores.initialize(geometry);
    leak.initialize(geometry);
    inflow.initialize(geometry);
    part = 1. / geometry.symmetry_factor();
  }



  bool
  CavityExchange::any() const
  {
    for (const SegmentExpression *expression : expressions())
      if (expression->text() != "0")
        return true;
    return false;
  }



  std::vector<const SegmentExpression *>
  CavityExchange::expressions() const
  {
    return {&pores, &leak, &inflow};
  }



  bool
  CavityExchange::pore_behind(const unsigned int segment, const double t) const
  {
    return conductance(pores, segment, t) > 0.;
  }



  bool
  CavityExchange::is_open(const unsigned int segment, const double t) const
  {
    return conductance(leak, segment, t) > 0. || inflow.value(segment, t) != 0.;
  }



  CavityExchange::Amounts
  CavityExchange::amounts(const std::vector<Cavity> &cavities,
                          const std::vector<double> &before,
                          const std::vector<double> &P,
                          const std::vector<double> &excess,
                          const LoadTime            &t,
                          const double               dt) const
  {
    const unsigned int n = cavities.size();
    AssertDimension(before.size(), n);
    AssertDimension(P.size(), n);
    Amounts amounts{before, dealii::FullMatrix<double>(n)};
    if (!any() || dt <= 0.)
      return amounts;

    // The volume dt (g (P[from] - P[to] + e) + q) out of one into another, where n
    // is outside.
    const auto flow = [&](const unsigned int from,
                          const unsigned int to,
                          const double       g,
                          const double       e,
                          const double       q) {
      const auto   pressure = [&](const unsigned int k) {
        return k < n ? P[k] : 0.;
      };
      const double volume =
        dt * (g * (pressure(from) - pressure(to) + e) + q);
      const auto change = [&](const unsigned int k, const double sign) {
        if (k == n || !cavities[k].keeps_amount)
          return;
        amounts.M[k] += sign * volume;
        if (from < n)
          amounts.dM_dP(k, from) += sign * dt * g;
        if (to < n)
          amounts.dM_dP(k, to) -= sign * dt * g;
      };
      change(from, -1.);
      change(to, 1.);
    };
    for (unsigned int k = 0; k < n; ++k)
      {
        const unsigned int s = cavities[k].segment;
        if (k + 1 < n && cavities[k + 1].segment == s + 1)
          flow(k,
               k + 1,
               part * pores.value(s, t),
               excess[k] - excess[k + 1],
               0.);
        flow(k, n, part * leak.value(s, t), 0., 0.);
        flow(n, k, 0., 0., part * inflow.value(s, t));
      }
    return amounts;
  }
} // namespace lumbricus
