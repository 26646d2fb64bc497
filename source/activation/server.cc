// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/activation/held_values.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <sys/un.h>

#include <memory>
#include <string>

namespace lumbricus
{
  /** What a running program of the user's says, asked before every load step
   * (HeldValues). Only a Continuation knows when that is, and asks. */
  class ServerActivation : public Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      // No file that is read: a restart has nothing to compare.
      prm.add_parameter("Address",
                        address,
                        "[path] The Unix socket of the controller, a program that "
                        "is asked before every load step what the muscle does at "
                        "the end of the step: see doc/controllers.md. Muscles "
                        "with the same address are asked for together. A relative "
                        "path starts at the working directory.",
                        dealii::Patterns::Anything());
      prm.add_parameter("Late after",
                        late_after,
                        "[s] How long the controller may take for an answer "
                        "before the run ends.",
                        PositiveNumber());
    }

    /** Throws ExcInput where the address cannot be one. */
    void
    initialize(const std::string &section, const Geometry &geometry) override
    {
      AssertThrow(!address.empty(),
                  ExcParameter(section + "/Address",
                               "is not set. Give the path of the Unix socket at "
                               "which the controller answers."));
      constexpr std::size_t most = sizeof(sockaddr_un::sun_path) - 1;
      AssertThrow(address.size() <= most,
                  ExcParameter(section + "/Address",
                               "has " + std::to_string(address.size()) +
                                 " bytes, but the path of a Unix socket has at "
                                 "most " +
                                 std::to_string(most) +
                                 ". Give a path from the working directory."));
      held = std::make_shared<HeldValues>(section,
                                          address,
                                          late_after,
                                          geometry.n_segments(),
                                          contracted_by(0.));
    }

    double
    value(const double       t,
          const unsigned int segment,
          const dealii::Point<dim> & /*X*/) const override
    {
      return held->value(t, segment);
    }

    std::shared_ptr<HeldValues>
    held_values() const override
    {
      return held;
    }

  private:
    std::string                 address;
    double                      late_after = 60.;
    std::shared_ptr<HeldValues> held;
  };



  static const Register<Activation, ServerActivation>
    server_activation("server",
                      "what a running controller says, asked before every load "
                      "step.");
} // namespace lumbricus
