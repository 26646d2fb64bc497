// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/continuation/continuation.h>
#include <lumbricus/core/item_lines.h>
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/output/output_format.h>
#include <lumbricus/parameters/registry.h>

#include <cstdint>
#include <iomanip>
#include <limits>
#include <memory>
#include <ostream>
#include <set>

namespace lumbricus
{
  namespace
  {
    // More would not be counted on by one.
    constexpr unsigned int most_steps =
      std::numeric_limits<unsigned int>::max() / 2;

    constexpr unsigned int most_past = 100;

    constexpr unsigned int most_globals = 1000000;

    constexpr double any_number = std::numeric_limits<double>::lowest();



    // "segments.csv": in the folder of the run itself.
    bool
    is_name_of_a_table(const std::string &name)
    {
      const std::string ending = ".csv";
      return name.size() > ending.size() && name.front() != '.' &&
             name.substr(name.size() - ending.size()) == ending &&
             name.find('/') == std::string::npos;
    }
  } // namespace



  // A line per item: its name, then its values; names of files come last. The
  // item of a picture has the name of its format.
  void
  RunProgress::write(std::ostream &out) const
  {
    out << std::setprecision(std::numeric_limits<double>::max_digits10)
        << "time " << time << "\nstep " << step << "\nelapsed_seconds "
        << elapsed_seconds << "\nvtu_is_current " << picture_is_current
        << "\ncontrol " << control << '\n';
    for (const auto &[name, value] : numbers)
      out << "number " << name << ' ' << value << '\n';
    for (const std::string &name : histories)
      out << "history " << name << '\n';
    for (const auto &[name, values] : globals)
      {
        out << "global " << name << ' ' << values.size();
        for (const double value : values)
          out << ' ' << value;
        out << '\n';
      }
    for (const double t : past)
      out << "past " << t << '\n';
    for (const auto &[name, content] : tables)
      out << "table " << content.size << ' ' << content.checksum << ' ' << name
          << '\n';
    for (const auto &[t, name] : pictures)
      out << format << ' ' << t << ' ' << name << '\n';
  }



  RunProgress
  RunProgress::read(const std::string &text)
  {
    RunProgress                   progress;
    std::set<std::string>         seen;
    ItemLines                     lines(text);
    std::unique_ptr<OutputFormat> format;
    while (lines.next())
      {
        const std::string item = lines.item();
        if (item == "table")
          {
            Fingerprint content;
            content.size = lines.get_count(Fingerprint::largest_size);
            content.checksum =
              lines.get_count(Fingerprint::largest_checksum);
            const std::string name = lines.get_word();
            if (!is_name_of_a_table(name) ||
                !progress.tables.emplace(name, content).second)
              lines.fail();
            continue;
          }
        if (Registry<OutputFormat>::entries().count(item) > 0)
          {
            if (progress.pictures.empty())
              {
                progress.format = item;
                format          = Registry<OutputFormat>::create(item);
              }
            const double      t    = lines.get_number(0.);
            const std::string name = lines.get_word();
            if (item != progress.format ||
                name != format->file_name(progress.pictures.size()))
              lines.fail();
            progress.pictures.emplace_back(t, name);
            continue;
          }
        if (item == "history")
          {
            const std::string name = lines.get_word();
            AssertThrow(NodalHistory::is_known(name),
                        ExcUnknownItem("history " + name));
            if (!progress.histories.insert(name).second)
              lines.fail();
            continue;
          }
        if (item == "number")
          {
            const std::string name  = lines.get_word();
            const double      value = lines.get_number(any_number);
            if (!progress.numbers.emplace(name, value).second)
              lines.fail();
            continue;
          }
        if (item == "global")
          {
            const std::string   name = lines.get_word();
            const auto          n    = lines.get_count(most_globals);
            std::vector<double> values;
            while (values.size() < n)
              values.push_back(lines.get_number(any_number));
            if (n == 0 || !progress.globals.emplace(name, values).second)
              lines.fail();
            continue;
          }
        if (item == "past")
          {
            progress.past.push_back(lines.get_number(0.));
            continue;
          }
        if (item == "time")
          progress.time = lines.get_number(0.);
        else if (item == "step")
          progress.step = lines.get_count(most_steps);
        else if (item == "elapsed_seconds")
          progress.elapsed_seconds = lines.get_number(0.);
        else if (item == "control")
          progress.control = lines.get_rest();
        else if (item == "vtu_is_current")
          progress.picture_is_current = lines.get_count(1);
        else
          AssertThrow(false, ExcUnknownItem(item));
        if (!seen.insert(item).second)
          lines.fail();
      }
    for (const std::string item :
         {"time", "step", "control", "elapsed_seconds", "vtu_is_current"})
      AssertThrow(seen.count(item) > 0,
                  ExcDamaged("does not have '" + item + "'."));
    for (const std::string &name : NodalHistory::names())
      AssertThrow(progress.histories.count(name) > 0,
                  ExcDamaged("does not have 'history " + name + "'."));
    // The control of a user's library is not known yet.
    bool may_go_back = true;
    if (Registry<Continuation>::entries().count(progress.control) > 0)
      {
        const auto control = Registry<Continuation>::create(progress.control);
        AssertThrow(control->set_numbers(progress.numbers),
                    ExcDamaged("has numbers that are not those of control '" +
                               progress.control + "'."));
        may_go_back = control->time_may_go_back();
      }
    // Times that are not apart would be divided by.
    double later = progress.time;
    for (const double t : progress.past)
      {
        AssertThrow(t < later || (may_go_back && t > later),
                    ExcDamaged("has a past that is not one of its time."));
        later = t;
      }
    AssertThrow(progress.past.size() <= most_past,
                ExcDamaged("has more of a past than any run."));
    AssertThrow(!progress.picture_is_current || !progress.pictures.empty(),
                ExcDamaged("does not have the picture of its state."));
    return progress;
  }
} // namespace lumbricus
