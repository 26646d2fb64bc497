// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_named_sections_h
#define lumbricus_parameters_named_sections_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * One section per name, each an object of type @p T made with its name: the
   * tissues, the muscles, the loads. The order is that of the names.
   */
  template <class T>
  class NamedSections
  {
  public:
    /**
     * Declare a section for every name of @p names that has none yet, and
     * extend those that were there: what is new has to be read first. With
     * Extent::everything, a section for @p placeholder shows what one looks
     * like. @p prepare is called with every new one before. Throws ExcInput
     * where a parameter beside the sections has the name of one.
     */
    bool
    extend_parameters(dealii::ParameterHandler       &prm,
                      const Extent                    extent,
                      const std::vector<std::string> &names,
                      const std::string              &placeholder,
                      const std::function<void(T &)> &prepare = {})
    {
      bool              extended = false;
      const std::size_t n_before = sections.size();
      const auto        all      = extent == Extent::everything ?
                              std::vector<std::string>{placeholder} :
                              names;
      for (const std::string &name : all)
        {
          if (find(name) == nullptr)
            {
              check_no_parameter(prm, name);
              sections.emplace_back(name, std::make_unique<T>(name));
              if (prepare)
                prepare(*sections.back().second);
              prm.enter_subsection(name);
              sections.back().second->declare_parameters(prm);
              prm.leave_subsection();
              extended = true;
            }
        }
      for (std::size_t i = 0; i < n_before; ++i)
        {
          prm.enter_subsection(sections[i].first);
          extended |= sections[i].second->extend_parameters(prm, extent);
          prm.leave_subsection();
        }
      return extended;
    }

    /** Check those of every section; what is thrown names the section. Throws
     * ExcInput. */
    void
    check_parameters() const
    {
      for (const auto &section : sections)
        within_section(section.first,
                       [&]() { section.second->check_parameters(); });
    }

    /** The object of that name, or nullptr. */
    const T *
    find(const std::string &name) const
    {
      for (const auto &section : sections)
        if (section.first == name)
          return section.second.get();
      return nullptr;
    }

    /** How many sections there are. */
    std::size_t
    size() const
    {
      return sections.size();
    }

    /** The name of number @p i. */
    const std::string &
    name(const std::size_t i) const
    {
      return sections[i].first;
    }

    /** Object number @p i, in the order of the names. */
    T &
    operator[](const std::size_t i)
    {
      return *sections[i].second;
    }

    /** Object number @p i, in the order of the names. */
    const T &
    operator[](const std::size_t i) const
    {
      return *sections[i].second;
    }

  private:
    // Where there is one, all ends here, so that its value may be spoilt.
    static void
    check_no_parameter(dealii::ParameterHandler &prm, const std::string &name)
    {
      bool is_parameter = true;
      try
        {
          prm.set(name, "");
        }
      catch (const dealii::ParameterHandler::ExcEntryUndeclared &)
        {
          is_parameter = false;
        }
      catch (const dealii::ExceptionBase &)
        {
          // There is one, and it does not take that.
        }
      AssertThrow(!is_parameter,
                  ExcInput("'" + name +
                           "' cannot be a name of yours there, because a "
                           "parameter in the same section is called so. "
                           "Choose another name."));
    }

    std::vector<std::pair<std::string, std::unique_ptr<T>>> sections;
  };
} // namespace lumbricus

#endif
