// SPDX-License-Identifier: LGPL-2.1-or-later
// An activation, which is called as the build says.
#include <lumbricus/activation/activation.h>
#include <lumbricus/parameters/registry.h>

namespace
{
  /** A muscle that does nothing: lambda = 1. */
  class Still : public lumbricus::Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Patience", patience, "[-] Of no effect.");
    }

    double
    value(const double /*t*/,
          const unsigned int /*segment*/,
          const dealii::Point<lumbricus::dim> & /*X*/) const override
    {
      return 1.;
    }

  private:
    double patience = 2.;
  };

  const lumbricus::Register<lumbricus::Activation, Still>
    still(PLUGIN_NAME, "a muscle that does nothing.");
} // namespace
