// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <cctype>
#include <iostream>
#include <sstream>
#include <streambuf>

namespace lumbricus
{
  namespace
  {
    // The variables and constants there are, for messages: "t, x, y, z, n, pi".
    std::string
    known_symbols(const Expression::Constants &constants)
    {
      std::string all = "t, x, y, z";
      for (const auto &constant : constants)
        all += ", " + constant.first;
      return all;
    }



    // deal.II prints what muParser says, and throws then. Once is enough.
    class Quiet
    {
    public:
      Quiet()
        : buffer(std::cerr.rdbuf(nullptr))
      {}

      ~Quiet()
      {
        std::cerr.rdbuf(buffer);
      }

    private:
      std::streambuf *buffer;
    };



    // Whether @p name stands in @p formula as a name of its own.
    bool
    uses(const std::string &formula, const std::string &name)
    {
      const auto in_name = [&](const std::size_t i) {
        return i < formula.size() &&
               (std::isalnum(static_cast<unsigned char>(formula[i])) ||
                formula[i] == '_');
      };
      for (auto at = formula.find(name); at != std::string::npos;
           at      = formula.find(name, at + 1))
        if ((at == 0 || !in_name(at - 1)) && !in_name(at + name.size()))
          return true;
      return false;
    }



    // What muParser takes, but hardly in the sense that was meant: a comma for
    // a decimal point, an assignment for a comparison, chance. Empty if there
    // is nothing.
    std::string
    misunderstanding(const std::string &formula)
    {
      for (const std::string chance : {"rand", "rand_seed"})
        if (uses(formula, chance))
          return "it has '" + chance +
                 "', which is another number whenever it is asked, on every "
                 "rank and after a restart. What differs from place to place "
                 "has to be a formula in x, y, z, as 'sin(91*x + 37*y)'.";
      int depth = 0;
      for (std::size_t i = 0; i < formula.size(); ++i)
        {
          const char c = formula[i];
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          if (c == ',' && depth == 0)
            return "it has a comma outside of a function. Decimals have a "
                   "point.";
          if (c == '=' && formula[i + 1] == '=')
            ++i;
          else if (c == '=' &&
                   (i == 0 || std::string("<>!").find(formula[i - 1]) ==
                                std::string::npos))
            return "it has '=', which is no comparison. That is '=='.";
        }
      return "";
    }



    // What muParser says, without what deal.II puts in front.
    std::string
    parser_message(const dealii::ExceptionBase &exception)
    {
      const std::string text    = plain_message(exception);
      const std::string opening = "The parser said: ";
      const auto        begin   = text.find(opening);
      const std::string what =
        begin == std::string::npos ? text : text.substr(begin + opening.size());
      return what.back() == '.' ? what : what + '.';
    }
  } // namespace



  Expression::Expression(const std::string &entry,
                         const std::string &formula,
                         const Constants   &user_constants)
    : entry(entry)
    , text(formula)
    , constants(user_constants)
    , parser(std::make_shared<dealii::FunctionParser<dim>>(1))
  {
    constants["pi"] = dealii::numbers::PI;

    std::string reason;
    if (formula.size() > InputLimits::formula)
      reason = "it has more than " + std::to_string(InputLimits::formula) +
               " characters.";
    else
      reason = misunderstanding(formula);
    if (!reason.empty())
      ; // muParser would not mind, or not come to an end
    else if (formula.find_first_not_of(" \t") == std::string::npos)
      reason = "it is empty.";
    else
      try
        {
          const Quiet quiet;
          parser->initialize("x,y,z,t", formula, constants, true);
          // muParser compiles at the first evaluation.
          parser->set_time(0.);
          parser->value(dealii::Point<dim>());
        }
      catch (const dealii::ExceptionBase &exception)
        {
          reason = parser_message(exception);
        }
    AssertThrow(reason.empty(),
                ExcParameter(entry,
                             ": the expression '" + shortened(formula) +
                               "' cannot be read: " + shortened(reason, 300) +
                               "\nIt may use " + known_symbols(constants) +
                               " and the functions of muParser (sin, exp, if, "
                               "min, ...)."));

    double value;
    if (read_number(formula, value))
      number = value;
  }



  void
  Expression::declare_parameter(dealii::ParameterHandler &prm,
                                const std::string        &documentation)
  {
    prm.declare_entry(entry, text, dealii::Patterns::Anything(), documentation);
    prm.add_action(entry, [this](const std::string &formula) {
      *this = Expression(entry, formula, constants);
    });
  }



  double
  Expression::value(const dealii::Point<dim> &x, const double t) const
  {
    // What is but a number needs no parser.
    if (number)
      return *number;
    parser->set_time(t);
    return parser->value(x);
  }



  double
  Expression::value(const dealii::Point<dim> &x, const LoadTime &t) const
  {
    return t.take([&](const double at) { return value(x, at); }, 0.);
  }



  bool
  Expression::depends_on_place() const
  {
    return uses(text, "x") || uses(text, "y") || uses(text, "z");
  }



  bool
  Expression::depends_on_time() const
  {
    return uses(text, "t");
  }



  std::string
  point_text(const dealii::Point<dim> &X)
  {
    std::ostringstream text;
    text << '(' << X[0] << ", " << X[1] << ", " << X[2] << ')';
    return text.str();
  }
} // namespace lumbricus
