// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_named_list_h
#define lumbricus_parameters_named_list_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/parameter_owner.h>
#include <lumbricus/parameters/patterns.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** An entry that lists names of the user's, and beside it a section for each,
   * which is a @p T: NamedSections. */
  template <class T>
  class NamedList : public ParameterOwner, public NamedSections<T>
  {
  public:
    /** The list is the entry @p entry. The reference has @p documentation of
     * it, and a section of the name @p placeholder. */
    NamedList(const std::string &entry,
              const std::string &placeholder,
              const std::string &documentation)
      : entry(entry)
      , placeholder(placeholder)
      , documentation(documentation)
    {}

    /** The list. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter(entry, names, documentation, NameList());
    }

    /** The sections. */
    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      return NamedSections<T>::extend_parameters(prm,
                                                 extent,
                                                 names,
                                                 placeholder);
    }

    /** Of every section, and that no name is there twice. */
    void
    check_parameters() const override
    {
      check_no_name_twice(entry, names);
      NamedSections<T>::check_parameters();
    }

  private:
    const std::string        entry;
    const std::string        placeholder;
    const std::string        documentation;
    std::vector<std::string> names;
  };
} // namespace lumbricus

#endif
