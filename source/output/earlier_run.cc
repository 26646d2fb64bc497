// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/json_nesting.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/output/earlier_run.h>
#include <lumbricus/output/run_description.h>
#include <lumbricus/parameters/entries_as_json.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

namespace lumbricus
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    // All of a file of the folder; nothing where it cannot be read, or is more
    // than a run writes.
    std::string
    content(const std::string &folder, const std::string &name)
    {
      const std::string    path = folder + "/" + name;
      std::error_code      error;
      const std::uintmax_t size = std::filesystem::file_size(path, error);
      if (error || size > InputLimits::bytes)
        return "";
      std::ifstream in = open_input_file(path);
      return std::string(std::istreambuf_iterator<char>(in), {});
    }



    std::optional<Tree>
    tree_of(const std::string &json)
    {
      if (where_nested_deeper(json, InputLimits::sections) < json.size())
        return std::nullopt;
      try
        {
          std::istringstream in(json);
          Tree               tree;
          boost::property_tree::read_json(in, tree);
          return tree;
        }
      catch (const boost::property_tree::json_parser_error &)
        {
          return std::nullopt;
        }
    }



    EarlierRun::Values
    values_in(const Tree &entries)
    {
      EarlierRun::Values values;
      for (const auto &[no_name, entry] : entries)
        if (const auto path = entry.get_optional<std::string>("path"))
          values[*path] = entry.get("value", std::string());
      return values;
    }



    /** A column of a table; what is no finite number is NaN. */
    struct Column
    {
      std::string         name;
      std::vector<double> values;
    };



    // Of the complete lines of a table.
    std::vector<Column>
    columns_of(const std::string &text)
    {
      std::vector<Column> columns;
      std::istringstream  in(text.substr(0, text.rfind('\n') + 1));
      for (std::string line; read_line(in, line);)
        {
          const auto cells = dealii::Utilities::split_string_list(line);
          if (columns.empty())
            for (const std::string &name : cells)
              columns.push_back({name, {}});
          else if (cells.size() == columns.size())
            for (std::size_t i = 0; i < cells.size(); ++i)
              {
                double value = 0.;
                columns[i].values.push_back(
                  read_number(cells[i], value) ?
                    value :
                    std::numeric_limits<double>::quiet_NaN());
              }
        }
      return columns;
    }



    // The values of a column; none where the table does not have it.
    std::vector<double>
    column_of(const std::vector<Column> &columns, const std::string &name)
    {
      for (const Column &column : columns)
        if (column.name == name)
          return column.values;
      return {};
    }



    double
    largest_of(const std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        largest = std::fmax(largest, std::abs(value));
      return largest;
    }



    // What is less is round-off, as of a pressure that is given.
    constexpr double least_error = 1e-10;



    // Of each number that has a column of its error too.
    std::vector<EarlierRun::Error>
    errors_in(const std::string &text)
    {
      const auto                     columns = columns_of(text);
      std::vector<EarlierRun::Error> errors;
      for (const auto &[name, values] : columns)
        {
          const double largest  = largest_of(values);
          const double of_error = largest_of(column_of(columns, name + "_error"));
          if (of_error > least_error * largest && largest > 0.)
            {
              std::string words = name;
              std::replace(words.begin(), words.end(), '_', ' ');
              errors.push_back({words, of_error / largest});
            }
        }
      return errors;
    }
  } // namespace



  std::optional<EarlierRun>
  earlier_run(const std::string &folder)
  {
    const std::string errors = content(folder, "errors.csv");
    if (errors.empty())
      return std::nullopt;
    const auto tree = tree_of(content(folder, RunDescription::file_name));
    if (!tree)
      return std::nullopt;
    const auto parameters = tree->get_child_optional("parameters");
    const auto time       = tree->get_optional<double>("status.time");
    const auto unknowns =
      column_of(columns_of(content(folder, "mesh.csv")), "unknowns");
    if (!parameters || !time || unknowns.empty() || !(unknowns[0] > 0.))
      return std::nullopt;

    EarlierRun run;
    run.folder     = folder;
    run.parameters = values_in(*parameters);
    run.time       = *time;
    run.n_unknowns = static_cast<std::uint64_t>(unknowns[0]);
    run.is_adapted = unknowns.size() > 1;
    run.errors     = errors_in(errors);
    if (run.parameters.empty() || run.errors.empty())
      return std::nullopt;
    return run;
  }



  std::vector<EarlierRun>
  earlier_runs(const std::string &folder)
  {
    namespace files = std::filesystem;
    // Of what cannot be looked at nothing is known.
    const auto canonical = [](const files::path &path) {
      std::error_code none;
      return files::canonical(path, none);
    };
    const files::path own  = canonical(folder);
    files::path       path = files::path(folder).lexically_normal();
    // As of "results/".
    if (!path.has_filename())
      path = path.parent_path();
    const files::path     parent = path.parent_path();
    std::set<std::string> beside;
    std::error_code       error;
    for (files::directory_iterator
           place(parent.empty() ? files::path(".") : parent, error),
         end;
         !error && place != end && beside.size() < InputLimits::files;
         place.increment(error))
      if (canonical(place->path()) != own)
        beside.insert(place->path().lexically_normal().string());

    std::vector<EarlierRun> runs;
    if (auto run = earlier_run(folder))
      runs.push_back(std::move(*run));
    for (const std::string &other : beside)
      if (auto run = earlier_run(other))
        runs.push_back(std::move(*run));
    return runs;
  }



  EarlierRun::Values
  values_of(const std::vector<ParameterEntry> &entries)
  {
    std::stringstream json;
    JsonValue::object().add("all", as_json(entries)).write(json);
    Tree tree;
    boost::property_tree::read_json(json, tree);
    return values_in(tree.get_child("all"));
  }
} // namespace lumbricus
