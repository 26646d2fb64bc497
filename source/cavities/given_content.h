// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_given_content_h
#define lumbricus_cavities_given_content_h

#include <lumbricus/cavities/cavity_content.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A content of which one thing is given by a formula, whatever flows in or
   * out. */
  class GivenContent : public CavityContent
  {
  public:
    /** The entry @p entry with this default, and what it is. */
    GivenContent(const std::string &entry,
                 const std::string &formula,
                 const std::string &documentation)
      : given(entry, formula)
      , documentation(documentation)
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      given.declare_parameter(prm, documentation);
      prm.add_parameter("Density",
                        mass_density,
                        "[t/mm^3] Mass per volume of what is inside, for a body "
                        "force that is a weight; next to 0 for a gas.",
                        dealii::Patterns::Double(0.));
    }

    void
    initialize(const std::string & /*section*/,
               const Geometry &geometry) override
    {
      given.initialize(geometry);
    }

    double
    density() const override
    {
      return mass_density;
    }

    bool
    keeps_amount() const override
    {
      return false;
    }

    std::vector<const SegmentExpression *>
    expressions() const override
    {
      return {&given};
    }

  protected:
    /** What is given. */
    SegmentExpression given;

  private:
    const std::string documentation;
    double            mass_density = 0.;
  };
} // namespace lumbricus

#endif
