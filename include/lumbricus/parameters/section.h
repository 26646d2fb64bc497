// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_section_h
#define lumbricus_parameters_section_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <utility>

namespace lumbricus
{
  /** A @p T, which is a ParameterOwner, with its parameters in a section. What
   * check_parameters() throws names that too. */
  template <class T>
  class Section : public T
  {
  public:
    /** In the section @p name; @p arguments are those of T. */
    template <class... Arguments>
    explicit Section(const std::string &name, Arguments &&...arguments)
      : T(std::forward<Arguments>(arguments)...)
      , section(name)
    {}

    /** Those of T, in the section. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.enter_subsection(section);
      T::declare_parameters(prm);
      prm.leave_subsection();
    }

    /** Those of T, in the section. */
    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      prm.enter_subsection(section);
      const bool extended = T::extend_parameters(prm, extent);
      prm.leave_subsection();
      return extended;
    }

    /** Those of T; messages name the section. */
    void
    check_parameters() const override
    {
      within_section(section, [&]() { T::check_parameters(); });
    }

    /** The name of the section. */
    const std::string &
    section_name() const
    {
      return section;
    }

  private:
    const std::string section;
  };
} // namespace lumbricus

#endif
