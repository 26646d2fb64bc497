// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_registry_h
#define lumbricus_core_registry_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/parameter_owner.h>

#include <deal.II/base/patterns.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * All implementations of the interface @p Base by the name users choose them
   * by. An implementation adds itself with one line at the end of its file,
   *
   *   static const Register<MaterialLaw, NeoHooke> neo_hooke("Neo-Hooke",
   * "...");
   */
  template <class Base>
  class Registry
  {
  public:
    struct Entry
    {
      std::string                            description;
      std::function<std::unique_ptr<Base>()> create;
    };

    static std::map<std::string, Entry> &
    entries()
    {
      static std::map<std::string, Entry> all;
      return all;
    }

    static std::unique_ptr<Base>
    create(const std::string &name)
    {
      const auto entry = entries().find(name);
      Assert(entry != entries().end(),
             dealii::ExcMessage("Nothing is registered as '" + name + "'."));
      return entry->second.create();
    }

    /** The names as "a|b|c", what Patterns::Selection takes. */
    static std::string
    names()
    {
      std::string all;
      for (const auto &entry : entries())
        all += (all.empty() ? "" : "|") + entry.first;
      return all;
    }

    /** The names as "'a', 'b', 'c'", for messages. */
    static std::string
    quoted_names()
    {
      std::string all;
      for (const auto &entry : entries())
        all += (all.empty() ? "'" : ", '") + entry.first + "'";
      return all;
    }

    /** One sentence per implementation, for the reference page. */
    static std::string
    descriptions()
    {
      std::string all;
      for (const auto &entry : entries())
        all += " '" + entry.first + "': " + entry.second.description;
      return all;
    }
  };



  template <class Base, class Derived>
  struct Register
  {
    Register(const std::string &name, const std::string &description)
    {
      Registry<Base>::entries()[name] = {description, []() {
                                           return std::make_unique<Derived>();
                                         }};
    }
  };



  /**
   * One entry that chooses an implementation of @p Base by name, and the
   * section of the same name with the parameters of the implementation chosen.
   */
  template <class Base>
  class Choice : public ParameterOwner
  {
  public:
    Choice(const std::string &entry,
           const std::string &default_name,
           const std::string &documentation)
      : entry(entry)
      , name(default_name)
      , documentation(documentation)
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      // An empty default means that the user has to choose.
      const std::string none = name.empty() ? "|" : "";
      prm.add_parameter(entry,
                        name,
                        documentation + Registry<Base>::descriptions(),
                        dealii::Patterns::Selection(Registry<Base>::names() +
                                                    none));
    }

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      bool extended = false;
      if (extent == Extent::everything)
        {
          for (const auto &alternative : Registry<Base>::entries())
            extended |= declare(alternative.first, prm);
        }
      else if (!name.empty())
        extended |= declare(name, prm);

      for (auto &object : objects)
        {
          prm.enter_subsection(object.first);
          extended |= object.second->extend_parameters(prm, extent);
          prm.leave_subsection();
        }
      return extended;
    }

    void
    check_parameters() const override
    {
      if (const auto *object = get())
        within_section(name, [&]() { object->check_parameters(); });
    }

    const std::string &
    chosen_name() const
    {
      return name;
    }

    /** The object chosen, or nullptr where the entry was left empty. */
    const Base *
    get() const
    {
      const auto object = objects.find(name);
      return object == objects.end() ? nullptr : object->second.get();
    }

    Base *
    get()
    {
      const auto object = objects.find(name);
      return object == objects.end() ? nullptr : object->second.get();
    }

    const Base &
    operator*() const
    {
      Assert(get() != nullptr, dealii::ExcInternalError());
      return *get();
    }

    const Base *
    operator->() const
    {
      return &**this;
    }

  private:
    bool
    declare(const std::string &which, dealii::ParameterHandler &prm)
    {
      if (objects.count(which) > 0)
        return false;
      objects[which] = Registry<Base>::create(which);
      prm.enter_subsection(which);
      objects[which]->declare_parameters(prm);
      prm.leave_subsection();
      return true;
    }

    const std::string                            entry;
    std::string                                  name;
    const std::string                            documentation;
    std::map<std::string, std::unique_ptr<Base>> objects;
  };
} // namespace lumbricus

#endif
