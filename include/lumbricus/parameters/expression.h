// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_expression_h
#define lumbricus_parameters_expression_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_time.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace lumbricus
{
  /**
   * A formula in the time t and the reference position x, y, z, with further
   * constants by name (pi is always one), read by muParser: a type that
   * parameters have, as numbers are. Copies are cheap and share the parser.
   */
  class Expression
  {
  public:
    /** Constants by name. */
    using Constants = std::map<std::string, double>;

    /**
     * @param entry the name of the parameter in its section.
     * Throws ExcParameter where @p formula does not parse.
     */
    Expression(const std::string &entry,
               const std::string &formula,
               const Constants   &constants = {});

    /**
     * Declare the parameter in the current section, with this formula as its
     * default. From now on this object is what it is set to: it must not be
     * moved. Setting it throws ExcParameter where the formula does not parse.
     */
    void
    declare_parameter(dealii::ParameterHandler &prm,
                      const std::string        &documentation);

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

    /** Whether x, y or z is in it. */
    bool
    depends_on_place() const;

    /** Whether t is in it. */
    bool
    depends_on_time() const;

    /** The name of the parameter in its section. */
    const std::string &
    parameter() const
    {
      return entry;
    }

    /** The formula as the user wrote it. */
    const std::string &
    formula() const
    {
      return text;
    }

    /** The same formula with @p constants of the same names. */
    Expression
    with(const Constants &constants) const
    {
      return Expression(entry, text, constants);
    }

  private:
    std::string                                  entry;
    std::string                                  text;
    Constants                                    constants;
    std::optional<double>                        number; ///< if it is but one
    std::shared_ptr<dealii::FunctionParser<dim>> parser;
  };



  /** "(x, y, z)" for messages. */
  std::string
  point_text(const dealii::Point<dim> &X);
} // namespace lumbricus

#endif
