// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavity_contents_h
#define lumbricus_cavities_cavity_contents_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>

namespace lumbricus
{
  /** What is in the chambers without cells: the section Cavities. */
  class CavityContents : public Section<Choice<CavityContent>>
  {
  public:
    /** Of the body @p anatomy, which is kept by reference. */
    explicit CavityContents(const Anatomy &anatomy)
      : Section("Cavities",
                "Content",
                default_content,
                "What is in the chambers that have no cells inside.")
      , anatomy(anatomy)
    {}

    /** Also that there are such chambers, where anything else was chosen for them
     * than what they have anyway. */
    void
    check_parameters() const override
    {
      Section::check_parameters();
      AssertThrow(chosen_name() == default_content ||
                    !anatomy.geometry().cavities().empty(),
                  ExcParameter(section_name() + "/Content",
                               "is '" + chosen_name() +
                                 "', but the body has no chamber without "
                                 "cells. Let a segment chain have them: "
                                 "'Geometry/segment chain/Liquid' = 'cavity'."));
    }

  private:
    static constexpr const char *default_content = "liquid";

    const Anatomy &anatomy;
  };
} // namespace lumbricus

#endif
