// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_expression_h
#define lumbricus_parameters_expression_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_time.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/point.h>

#include <map>
#include <memory>
#include <string>

namespace lumbricus
{
  /**
   * A formula in the time t and the reference position x, y, z, with further
   * constants by name (pi is always one), read by muParser. Copies are cheap
   * and share the parser.
   */
  class Expression
  {
  public:
    /**
     * @param name the full name of the parameter, for messages.
     * Throws ExcInput where @p formula does not parse.
     */
    Expression(const std::string                   &name,
               const std::string                   &formula,
               const std::map<std::string, double> &constants = {});

    /**
     * The value at reference position @p x and time @p t. It may be NaN or
     * infinite (0/0, log of a negative number): who asks has to look.
     * @throw ExcInput where muParser cannot evaluate at all.
     */
    double
    value(const dealii::Point<dim> &x, const double t) const;

    /** The value when loads are taken at @p t, of a load that is zero at
     * rest. */
    double
    value(const dealii::Point<dim> &x, const LoadTime &t) const;

    /** The full name of the parameter. */
    const std::string &
    parameter() const
    {
      return name;
    }

    /** The formula as the user wrote it. */
    const std::string &
    formula() const
    {
      return text;
    }

  private:
    std::string                                  name;
    std::string                                  text;
    std::shared_ptr<dealii::FunctionParser<dim>> parser;
  };



  /** "(x, y, z)" for messages. */
  std::string
  point_text(const dealii::Point<dim> &X);
} // namespace lumbricus

#endif
