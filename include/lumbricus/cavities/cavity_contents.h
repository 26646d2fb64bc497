// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_contents_h
#define lumbricus_cavities_cavity_contents_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>

namespace lumbricus
{
  /** What is in the chambers without cells: the section Cavities, which is there
   * where the body has any. */
  class CavityContents : public Section<Choice<CavityContent>>
  {
  public:
    /** Of the body @p anatomy, whose parameters are read before these. It is
     * kept by reference. */
    explicit CavityContents(const Anatomy &anatomy)
      : Section("Cavities",
                "Content",
                "liquid",
                "What is in the chambers that have no cells inside.")
      , anatomy(anatomy)
    {}

    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      if (is_declared)
        return Section::extend_parameters(prm, extent);
      is_declared = extent == Extent::everything ||
                    !anatomy.geometry().cavities().empty();
      if (is_declared)
        Section::declare_parameters(prm);
      return is_declared;
    }

    void
    check_parameters() const override
    {
      if (is_declared)
        Section::check_parameters();
    }

  private:
    const Anatomy &anatomy;
    bool           is_declared = false;
  };
} // namespace lumbricus

#endif
