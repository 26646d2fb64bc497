// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_vector_expression_h
#define lumbricus_parameters_vector_expression_h

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Three expressions separated by semicolons, the components of a vector: a
   * type of parameters as Expression is. */
  class VectorExpression
  {
  public:
    /**
     * @param entry the name of the parameter in its section.
     * Throws ExcParameter where @p formulas are not three, or do not parse.
     */
    VectorExpression(const std::string &entry, const std::string &formulas);

    /** As Expression::declare_parameter(). */
    void
    declare_parameter(dealii::ParameterHandler &prm,
                      const std::string        &documentation);

    /** The vector at reference position @p x and time @p t, which may be a
     * LoadTime: see Expression::value(). */
    template <class Time>
    dealii::Tensor<1, dim>
    value(const dealii::Point<dim> &x, const Time &t) const
    {
      dealii::Tensor<1, dim> vector;
      for (unsigned int i = 0; i < dim; ++i)
        vector[i] = of_components[i].value(x, t);
      return vector;
    }

    /** The name of the parameter in its section. */
    const std::string &
    parameter() const
    {
      return of_components.front().parameter();
    }

    /** Those of the components, dim of them. */
    const std::vector<Expression> &
    components() const
    {
      return of_components;
    }

  private:
    std::string             text;
    std::vector<Expression> of_components;
  };
} // namespace lumbricus

#endif
