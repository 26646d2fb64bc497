// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_parameters.h"

#include <lumbricus/core/number_in_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lumbricus
{
  namespace
  {
    using Values = EarlierRun::Values;

    const std::string global_refinements = "Mesh/Global refinements";
    const std::string local_refinements  = "Mesh/Local refinements";

    // How equal two ways are that are the same: numbers of cells are whole.
    constexpr double difference_of_ways = 0.05;



    bool
    begins(const std::string &path, const std::string &with)
    {
      return path.compare(0, with.size(), with) == 0;
    }



    // What only says what is written, solved or watched, and how.
    bool
    changes_no_result(const std::string &path)
    {
      if (path == "Title" || path == "Time/End")
        return true;
      for (const std::string section :
           {"Output/", "Checkpoints/", "Linear solver/", "Stability/"})
        if (begins(path, section))
          return true;
      return false;
    }



    std::string
    value_of(const Values &values, const std::string &path)
    {
      const auto found = values.find(path);
      return found == values.end() ? "" : found->second;
    }



    double
    number_of(const Values &values, const std::string &path)
    {
      double number = 0.;
      return read_number(value_of(values, path), number) ? number : 0.;
    }



    // Numbers may be written in several ways.
    bool
    has_same(const std::string &path, const Values &one, const Values &other)
    {
      const std::string a = value_of(one, path), b = value_of(other, path);
      double            x = 0., y = 0.;
      return a == b || (read_number(a, x) && read_number(b, y) && x == y);
    }



    // Whether it is a number of cells, or several, as all of a shape are called.
    bool
    counts_cells(const std::string &path, const Values &values)
    {
      return begins(path,
                    "Geometry/" + value_of(values, "Geometry/Shape") + "/Cells");
    }
  } // namespace



  std::optional<Refinement>
  refinement(const EarlierRun::Values &coarse, const EarlierRun::Values &fine)
  {
    const auto change = [&](const std::string &path) {
      return number_of(fine, path) - number_of(coarse, path);
    };
    const double global = change(global_refinements);
    Refinement   found;
    for (const auto &[path, value] : fine)
      if (counts_cells(path, fine))
        {
          const auto before =
            dealii::Utilities::split_string_list(value_of(coarse, path));
          const auto after = dealii::Utilities::split_string_list(value);
          if (before.size() != after.size())
            return std::nullopt;
          for (std::size_t i = 0; i < after.size(); ++i)
            {
              double a = 0., b = 0.;
              if (before[i] == after[i])
                found.push_back(global);
              else if (read_number(before[i], a) && read_number(after[i], b) &&
                       a > 0. && b > 0.)
                found.push_back(global + std::log2(b / a));
              else
                return std::nullopt;
            }
        }
    if (found.empty())
      found.push_back(global);
    if (value_of(fine, "Mesh/Refine where") != "0")
      found.push_back(global + change(local_refinements));
    return found;
  }



  double
  main_element(const Refinement &refinement)
  {
    return *std::max_element(refinement.begin(),
                             refinement.end(),
                             [](const double x, const double y) {
                               return std::abs(x) < std::abs(y);
                             });
  }



  bool
  same_way(const Refinement &one, const Refinement &other)
  {
    const double a = main_element(one), b = main_element(other);
    if (one.size() != other.size() || a == 0. || b == 0.)
      return false;
    for (std::size_t k = 0; k < one.size(); ++k)
      if (std::abs(one[k] / a - other[k] / b) > difference_of_ways)
        return false;
    return true;
  }



  std::vector<std::string>
  parameters_that_differ(const EarlierRun::Values &one,
                         const EarlierRun::Values &other)
  {
    std::set<std::string> paths;
    for (const Values *values : {&one, &other})
      for (const auto &[path, value] : *values)
        if (!has_same(path, one, other) && !changes_no_result(path) &&
            !counts_cells(path, *values) && path != global_refinements &&
            path != local_refinements)
          paths.insert(path);
    return {paths.begin(), paths.end()};
  }
} // namespace lumbricus
