// SPDX-License-Identifier: LGPL-2.1-or-later
#include "controller_answer.h"

#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/json_nesting.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    const std::string limit = "largest_dt";



    // What is wrong with a name in an object, or with the object.
    std::string
    wrong_names(const Tree &tree, const std::vector<AskedMuscle> &muscles)
    {
      const auto of_all = [&]() {
        std::vector<std::string> names;
        for (const AskedMuscle &muscle : muscles)
          names.push_back(muscle.name);
        return quoted_list(names);
      };
      if (tree.empty() || tree.front().first.empty())
        return "is no object with the muscles " + of_all();
      for (const AskedMuscle &muscle : muscles)
        if (tree.count(muscle.name) == 0)
          return "does not have the muscle '" + muscle.name + "'";
      for (const auto &entry : tree)
        {
          if (tree.count(entry.first) > 1)
            return "has '" + shortened(entry.first) + "' twice";
          if (entry.first != limit &&
              std::none_of(muscles.begin(),
                           muscles.end(),
                           [&](const AskedMuscle &muscle) {
                             return muscle.name == entry.first;
                           }))
            return "has '" + shortened(entry.first) +
                   "', which is neither '" + limit +
                   "' nor a muscle that is asked for, " + of_all();
        }
      return "";
    }



    // What Boost has left of a value: the text of a scalar.
    std::string
    text_of(const Tree &value)
    {
      return value.empty() ? value.data() : "[...]";
    }



    // The numbers of a muscle; what is wrong with them goes into the answer.
    std::vector<double>
    numbers(const Tree         &value,
            const AskedMuscle  &muscle,
            const unsigned int  n_segments,
            std::string        &fault)
    {
      std::vector<double> found;
      // An array without elements is as a text without any.
      const bool is_one = value.empty() && !value.data().empty();
      const std::size_t n = is_one ? n_segments : value.size();
      if (n != n_segments)
        {
          fault = "has " + std::to_string(n) + " values for the muscle '" +
                  muscle.name + "', but the body has " +
                  std::to_string(n_segments) + " segment" +
                  (n_segments == 1 ? "" : "s");
          return {};
        }
      const auto add = [&](const Tree &element) {
        double            number = 0.;
        const std::string where  = muscle.quantity + " of muscle '" +
                                  muscle.name + "' in segment " +
                                  std::to_string(found.size() + 1);
        if (!read_number(text_of(element), number))
          fault = "has '" + shortened(text_of(element)) + "' as the " + where +
                  ", which is no number";
        else if (const std::string needed = muscle.requirement(number);
                 !needed.empty())
          fault = "has " + text_of(element) + " as the " + where +
                  ", which has to be " + needed;
        found.push_back(number);
      };
      if (is_one)
        while (found.size() < n_segments && fault.empty())
          add(value);
      else
        for (const auto &[name, element] : value)
          if (fault.empty() && !name.empty())
            fault = "has an object for the muscle '" + muscle.name + "'";
          else if (fault.empty())
            add(element);
      return found;
    }



    Tree
    parsed(const std::string &json, std::string &fault)
    {
      Tree tree;
      if (where_nested_deeper(json, InputLimits::sections) < json.size())
        {
          fault = "has too many objects and arrays in each other";
          return tree;
        }
      try
        {
          std::istringstream text(json);
          boost::property_tree::read_json(text, tree);
        }
      catch (const boost::property_tree::json_parser_error &error)
        {
          fault = "is no JSON, " + error.message();
        }
      return tree;
    }
  } // namespace



  ControllerAnswer
  read_answer(const std::string              &json,
              const std::vector<AskedMuscle> &muscles,
              const unsigned int              n_segments,
              const double                    smallest_step)
  {
    ControllerAnswer answer;
    const Tree       tree = parsed(json, answer.fault);
    if (answer.fault.empty())
      answer.fault = wrong_names(tree, muscles);
    for (const AskedMuscle &muscle : muscles)
      if (answer.fault.empty())
        answer.values.push_back(numbers(tree.find(muscle.name)->second,
                                        muscle,
                                        n_segments,
                                        answer.fault));
    if (!answer.fault.empty() || tree.count(limit) == 0)
      return answer;
    const std::string given = text_of(tree.find(limit)->second);
    double            dt    = 0.;
    if (!read_number(given, dt) || !(dt >= smallest_step))
      {
        std::ostringstream text;
        text << "has '" << shortened(given) << "' as '" << limit
             << "', which has to be a number that is not less than "
                "'Time/Smallest step', "
             << smallest_step;
        answer.fault = text.str();
      }
    answer.largest_dt = dt;
    return answer;
  }
} // namespace lumbricus
