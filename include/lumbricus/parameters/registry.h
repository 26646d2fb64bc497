// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_registry_h
#define lumbricus_parameters_registry_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/parameter_owner.h>
#include <lumbricus/parameters/registration.h>

#include <deal.II/base/patterns.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeinfo>
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
    /** What is known of an implementation. */
    struct Entry
    {
      /** A sentence for the parameter reference. */
      std::string description;
      /** Makes one, with the default values of its parameters. */
      std::function<std::unique_ptr<Base>()> create;
    };

    /** All there are, by name: complete when the libraries that the input
     * names are loaded (SharedLibraries). */
    static std::map<std::string, Entry> &
    entries()
    {
      static std::map<std::string, Entry> all;
      return all;
    }

    /** Make the one called @p name, which has to be there. */
    static std::unique_ptr<Base>
    create(const std::string &name)
    {
      const auto entry = entries().find(name);
      Assert(entry != entries().end(),
             dealii::ExcMessage("Nothing is registered as '" + name + "'."));
      return entry->second.create();
    }

    /** The names, in their order. */
    static std::vector<std::string>
    names()
    {
      std::vector<std::string> all;
      for (const auto &entry : entries())
        all.push_back(entry.first);
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



  /** Adds @p Derived to the implementations of @p Base when the program, or the
   * library it is in, is loaded. */
  template <class Base, class Derived>
  struct Register
  {
    /**
     * Under @p name; @p description is a sentence for the parameter reference.
     * Where that name is taken the first keeps it, until the clash is an error
     * of the program's (clash_of_names()).
     */
    Register(const std::string &name, const std::string &description)
    {
      note_registration(typeid(Base), typeid(Derived), name, this);
      Registry<Base>::entries().insert(
        {name, {description, []() { return std::make_unique<Derived>(); }}});
    }
  };



  /** Where the parameters of an implementation are that an entry chooses: in a
   * section beside the entry that has its name, or beside the entry. */
  enum class Placement
  {
    own_section,
    beside_entry
  };



  /**
   * One entry that chooses an implementation of @p Base by name, and the
   * parameters of the implementation chosen.
   */
  template <class Base>
  class Choice : public ParameterOwner
  {
  public:
    /**
     * The entry @p entry with this default, where empty means that the user has
     * to choose, else @p what_is_missing, as in ": the muscle has no fibres";
     * the reference has @p documentation and a sentence for each
     * implementation, whose parameters are at @p placement.
     */
    Choice(const std::string &entry,
           const std::string &default_name,
           const std::string &documentation,
           const Placement    placement       = Placement::own_section,
           const std::string &what_is_missing = "")
      : entry(entry)
      , name(default_name)
      , documentation(documentation)
      , placement(placement)
      , what_is_missing(what_is_missing)
    {}

    /** Do this with every object before its parameters are declared, to change
     * their defaults. */
    void
    prepare_with(const std::function<void(Base &)> &preparation)
    {
      prepare = preparation;
    }

    /** The entry. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      // An empty default means that the user has to choose.
      std::string choices;
      for (const std::string &choice : Registry<Base>::names())
        choices += (choices.empty() ? "" : "|") + choice;
      prm.add_parameter(entry,
                        name,
                        documentation + Registry<Base>::descriptions(),
                        dealii::Patterns::Selection(
                          choices + (name.empty() ? "|" : "")));
    }

    /** The parameters of what was chosen, or of all there are. */
    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      // Those that are new have to be read first: what they choose themselves
      // is still the default, whose section nobody may ask for.
      bool extended = false;
      for (auto &object : objects)
        {
          enter_section(object.first, prm);
          extended |= object.second->extend_parameters(prm, extent);
          leave_section(prm);
        }

      if (extent == Extent::everything)
        {
          for (const auto &alternative : Registry<Base>::entries())
            extended |= declare(alternative.first, prm);
        }
      else if (!name.empty())
        extended |= declare(name, prm);
      return extended;
    }

    /** That something was chosen, and its parameters. */
    void
    check_parameters() const override
    {
      const auto *object = get();
      AssertThrow(object != nullptr,
                  ExcParameter(entry,
                               "is not set" + what_is_missing +
                                 ". Set it to one of " +
                                 quoted_list(Registry<Base>::names()) + "."));
      if (placement == Placement::own_section)
        within_section(name, [&]() { object->check_parameters(); });
      else
        object->check_parameters();
    }

    /** The full name of the section with the parameters of what was chosen,
     * where the entry is in @p section. */
    std::string
    section_in(const std::string &section) const
    {
      return placement == Placement::own_section ? section + "/" + name :
                                                   section;
    }

    /** What the entry says; empty where nothing was chosen. */
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

    /** The object chosen, or nullptr where the entry was left empty. */
    Base *
    get()
    {
      const auto object = objects.find(name);
      return object == objects.end() ? nullptr : object->second.get();
    }

    /** The object chosen, where there is one. */
    const Base &
    operator*() const
    {
      Assert(get() != nullptr, dealii::ExcInternalError());
      return *get();
    }

    /** The object chosen, where there is one. */
    const Base *
    operator->() const
    {
      return &**this;
    }

  private:
    void
    enter_section(const std::string &which, dealii::ParameterHandler &prm) const
    {
      if (placement == Placement::own_section)
        prm.enter_subsection(which);
    }

    void
    leave_section(dealii::ParameterHandler &prm) const
    {
      if (placement == Placement::own_section)
        prm.leave_subsection();
    }

    bool
    declare(const std::string &which, dealii::ParameterHandler &prm)
    {
      if (objects.count(which) > 0)
        return false;
      objects[which] = Registry<Base>::create(which);
      if (prepare)
        prepare(*objects[which]);
      enter_section(which, prm);
      objects[which]->declare_parameters(prm);
      leave_section(prm);
      return true;
    }

    const std::string                            entry;
    std::string                                  name;
    const std::string                            documentation;
    const Placement                              placement;
    const std::string                            what_is_missing;
    std::function<void(Base &)>                  prepare;
    std::map<std::string, std::unique_ptr<Base>> objects;
  };
} // namespace lumbricus

#endif
