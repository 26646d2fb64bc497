// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_patterns_h
#define lumbricus_core_patterns_h

#include <deal.II/base/patterns.h>

#include <cmath>
#include <memory>
#include <string>

namespace lumbricus
{
  /** A finite number greater than zero: lengths, stiffnesses, time steps. */
  class PositiveNumber : public dealii::Patterns::PatternBase
  {
  public:
    /** Whether @p text is one, and nothing else. */
    bool
    match(const std::string &text) const override
    {
      if (!dealii::Patterns::Double().match(text))
        return false;
      const double value = std::stod(text);
      return std::isfinite(value) && value > 0;
    }

    /** What messages and the parameter reference say. */
    std::string
    description(const OutputStyle /*style*/ = Machine) const override
    {
      return "[A number > 0]";
    }

    /** A copy, as dealii::ParameterHandler keeps it. */
    std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<PositiveNumber>();
    }
  };
} // namespace lumbricus

#endif
