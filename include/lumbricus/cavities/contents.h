// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_contents_h
#define lumbricus_cavities_contents_h

#include <lumbricus/cavities/content.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** What is in the cavities: the section Cavities. */
  class CavityContents : public ParameterOwner
  {
  public:
    /** A liquid in all of them. */
    CavityContents();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** The equation of the content of the cavity at @p point. */
    CavityEquation
    equation(const CavityPoint &point) const;

  private:
    Choice<CavityContent> content;
  };
} // namespace lumbricus

#endif
