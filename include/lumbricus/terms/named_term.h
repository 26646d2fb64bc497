// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_named_term_h
#define lumbricus_terms_named_term_h

#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/parameters/registry.h>

#include <string>

namespace lumbricus
{
  /** What the user has named in a section: a @p Base that its entry 'Type'
   * chooses. Where it acts is for derived classes to know. */
  template <class Base>
  class NamedTerm : public PartOfBody
  {
  public:
    /** That of the section @p name. */
    explicit NamedTerm(const std::string &name)
      : name(name)
      , type("Type", "", "What acts there.")
    {}

    /** The entry 'Type'. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      type.declare_parameters(prm);
    }

    /** The section of what was chosen. */
    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      return type.extend_parameters(prm, extent);
    }

    /** Something has to be chosen. */
    void
    check_parameters() const override
    {
      type.check_parameters();
    }

    /** That of what was chosen. */
    void
    initialize(const std::string &section, const Geometry &geometry) override
    {
      type_section = type.section_in(section);
      type.get()->initialize(type_section, geometry);
    }

    /** The name of the section. */
    const std::string name;
    /** What acts there. */
    Choice<Base> type;
    /** The full name of the section with its parameters, by initialize(). */
    std::string type_section;
  };
} // namespace lumbricus

#endif
