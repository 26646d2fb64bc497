// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_patterns_h
#define lumbricus_parameters_patterns_h

#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/names.h>

#include <deal.II/base/patterns.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace lumbricus
{
  /**
   * A number greater than zero: lengths, stiffnesses, time steps. It and its
   * cube have to be far from what a computer can hold.
   */
  class PositiveNumber : public dealii::Patterns::PatternBase
  {
  public:
    /** Whether @p text is one, and nothing else. */
    bool
    match(const std::string &text) const override
    {
      if (!dealii::Patterns::Double().match(text))
        return false;
      const double value = std::strtod(text.c_str(), nullptr);
      return value >= 1e-100 && value <= 1e100;
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



  /** A name of the user's own, which is that of a section too. */
  class Name : public dealii::Patterns::PatternBase
  {
  public:
    /** Whether @p text is one: see unfit_name(). */
    bool
    match(const std::string &text) const override
    {
      return unfit_name(text).empty();
    }

    /** "[Name]", as deal.II's messages have it. */
    std::string
    description(const OutputStyle /*style*/ = Machine) const override
    {
      return "[Name]";
    }

    /** A copy, as dealii::ParameterHandler keeps it. */
    std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<Name>();
    }
  };



  /** A list of names, as long as one may be. */
  class NameList : public dealii::Patterns::List
  {
  public:
    /** Of no name, or of some. */
    NameList()
      : List(Name(), 0, InputLimits::names)
    {}
  };
} // namespace lumbricus

#endif
