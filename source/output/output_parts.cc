// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/output_parts.h>

#include <algorithm>
#include <set>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // Make those that are not there yet.
    template <class Part>
    void
    make_all(std::map<std::string, std::unique_ptr<Part>> &all)
    {
      for (const auto &[name, entry] : Registry<Part>::entries())
        if (all.count(name) == 0)
          all[name] = entry.create();
    }



    // A checkpoint has it as one word, and the shell is to need no quotes.
    bool
    can_be_a_file(const std::string &name)
    {
      const std::string letters = "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
      return !name.empty() &&
             name.find_first_not_of(letters) == std::string::npos;
    }
  } // namespace



  OutputParts::OutputParts()
    : format_choice("Format", "vtu", "How pictures are written.")
  {}



  void
  OutputParts::declare_parameters(dealii::ParameterHandler &prm)
  {
    // Not before: libraries of the user's may have been loaded since.
    make_all(all_tables);
    make_all(all_fields);
    for (const auto &[name, table] : all_tables)
      {
        AssertThrow(can_be_a_file(name),
                    ExcInput("A table has registered itself as '" + name +
                             "', which cannot be the name of its file. Give "
                             "it one of letters, digits, '_' and '-'."));
        table->declare_parameters(prm);
      }
    format_choice.declare_parameters(prm);
  }



  bool
  OutputParts::extend_parameters(dealii::ParameterHandler &prm,
                                 const Extent              extent)
  {
    bool extended = format_choice.extend_parameters(prm, extent);
    for (const auto &entry : all_tables)
      extended |= entry.second->extend_parameters(prm, extent);
    return extended;
  }



  void
  OutputParts::check_parameters() const
  {
    format_choice.check_parameters();
    for (const auto &entry : all_tables)
      entry.second->check_parameters();
  }



  void
  OutputParts::initialize(const Anatomy            &anatomy,
                          const BoundaryConditions &conditions)
  {
    empty_tables.clear();
    for (const auto &[name, table] : all_tables)
      if (!table->applies_to(conditions))
        empty_tables.insert(name);

    // Where two have the same place they are in the order of their names.
    std::vector<std::pair<std::string, const Field *>> in_order;
    for (const auto &[name, field] : all_fields)
      if (field->applies_to(conditions))
        in_order.emplace_back(name, field.get());
    std::stable_sort(in_order.begin(),
                     in_order.end(),
                     [](const auto &a, const auto &b) {
                       return a.second->place() < b.second->place();
                     });
    arrays.clear();
    for (const auto &[name, field] : in_order)
      if (!field->is_per_muscle())
        arrays.push_back({name, field, nullptr});
      else
        for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
          arrays.push_back({field->array_name(name, anatomy.muscle(m)),
                            field,
                            &anatomy.muscle(m)});

    std::set<std::string> names;
    for (const FieldArray &array : arrays)
      AssertThrow(names.insert(array.name).second,
                  ExcInput("Two fields are called '" + array.name +
                           "'. Give yours another name in its Register, or "
                           "the muscle that one of them is of another name."));
  }



  std::string
  OutputParts::check(const MixedSpace &space) const
  {
    std::string notes;
    for (const auto &entry : tables())
      notes += entry.second->check(space);
    return notes;
  }



  std::map<std::string, Table *>
  OutputParts::tables() const
  {
    std::map<std::string, Table *> wanted;
    for (const auto &[name, table] : all_tables)
      if (table->is_wanted() && empty_tables.count(name) == 0)
        wanted[name + ".csv"] = table.get();
    return wanted;
  }



  bool
  OutputParts::asks_for_work() const
  {
    const auto wanted = tables();
    return std::any_of(wanted.begin(), wanted.end(), [](const auto &entry) {
      return entry.second->asks_for_work();
    });
  }



  bool
  OutputParts::asks_for_errors() const
  {
    const auto wanted = tables();
    return std::any_of(wanted.begin(), wanted.end(), [](const auto &entry) {
      return entry.second->steps_between_errors() > 0;
    });
  }



  bool
  OutputParts::asks_for_errors(const unsigned int number) const
  {
    const auto wanted = tables();
    return std::any_of(wanted.begin(), wanted.end(), [&](const auto &entry) {
      const unsigned int every = entry.second->steps_between_errors();
      return every > 0 && number % every == 0;
    });
  }



  bool
  OutputParts::asks_for_errors_of_steps() const
  {
    const auto wanted = tables();
    return std::any_of(wanted.begin(), wanted.end(), [](const auto &entry) {
      return entry.second->asks_for_errors_of_steps();
    });
  }



  bool
  OutputParts::asks_for_errors_of_resets(const unsigned int number) const
  {
    const auto wanted = tables();
    return std::any_of(wanted.begin(), wanted.end(), [&](const auto &entry) {
      return entry.second->asks_for_errors_of_resets(number);
    });
  }



  const std::vector<FieldArray> &
  OutputParts::field_arrays() const
  {
    return arrays;
  }



  std::vector<FieldArray>
  OutputParts::field_arrays(const std::vector<std::string> &names) const
  {
    std::vector<FieldArray> some;
    for (const FieldArray &array : arrays)
      if (std::find(names.begin(), names.end(), array.name) != names.end())
        some.push_back(array);
    AssertDimension(some.size(), names.size());
    return some;
  }



  OutputFormat &
  OutputParts::format()
  {
    return *format_choice.get();
  }



  const std::string &
  OutputParts::format_name() const
  {
    return format_choice.chosen_name();
  }
} // namespace lumbricus
