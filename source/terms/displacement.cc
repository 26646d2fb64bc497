// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/vector_expression.h>
#include <lumbricus/terms/prescribed_displacement.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace lumbricus
{
  /** u_i = g_i(t, X) on the surface for the components listed. */
  class DisplacementOfFormulas : public PrescribedDisplacement
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter(
        "Components",
        component_names,
        "The components that are prescribed; the others are "
        "free.",
        dealii::Patterns::List(dealii::Patterns::Selection("x|y|z"), 1, dim));
      displacement.declare_parameter(
        prm,
        "[mm] Three expressions in t, x, y, z, separated by semicolons; those "
        "of free components are not used.");
    }

    std::vector<Expression>
    expressions() const override
    {
      return displacement.components();
    }

    std::array<bool, dim>
    components() const override
    {
      std::array<bool, dim> known;
      for (unsigned int i = 0; i < dim; ++i)
        known[i] = std::count(component_names.begin(),
                                   component_names.end(),
                                   std::string(1, "xyz"[i])) > 0;
      return known;
    }

    double
    value(const unsigned int        component,
          const dealii::Point<dim> &X,
          const double              t) const override
    {
      return displacement.components()[component].value(X, t);
    }

  private:
    std::vector<std::string> component_names = {"x", "y", "z"};
    VectorExpression         displacement    = {"Displacement", "0; 0; 0"};
  };

  static const Register<BoundaryCondition, DisplacementOfFormulas>
    displacement("displacement",
                 "displacements prescribed as functions of time.");
} // namespace lumbricus
