// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expected_accuracy.h"

#include <lumbricus/core/user_text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "mesh_parameters.h"

namespace lumbricus
{
  namespace
  {
    // The order in which errors fall with the size of cells, where no two runs say
    // it: doc/accuracy.md has what was measured.
    constexpr double least_order = 1., largest_order = 3.5;
    // Two runs say no more than that.
    constexpr double highest_order = 4.;
    // More parameters are not named.
    constexpr std::size_t most_names = 4;



    /** An earlier run with the same parameters but for the mesh. */
    struct Comparable
    {
      const EarlierRun *run;
      Refinement        to_this; ///< from its mesh to that of this run
    };



    std::string
    digits(const double value, const int n)
    {
      std::ostringstream text;
      text << std::setprecision(n) << value;
      return text.str();
    }



    std::string
    in_per_cent(const double part)
    {
      return digits(100. * part, part < 1. ? 2 : 3);
    }



    std::string
    with_commas(const std::uint64_t number)
    {
      std::string text = std::to_string(number);
      for (std::size_t i = text.size(); i > 3;)
        text.insert(i -= 3, ",");
      return text;
    }



    std::string
    said(const EarlierRun &run)
    {
      std::string text = "An earlier run in '" + shortened(run.folder) +
                         "' on " + with_commas(run.n_unknowns) +
                         " unknowns, which came to the time " +
                         digits(run.time, 6) + ", estimated errors of at most ";
      for (const EarlierRun::Error &error : run.errors)
        text += (&error == &run.errors.front() ? "" : ", ") +
                shortened(error.name) + " " + in_per_cent(error.relative) + "%";
      return text + ".\n";
    }



    // "cells 2 times smaller", where all are.
    std::string
    cells_in_words(const Refinement &refinement)
    {
      const auto [from, to] =
        std::minmax_element(refinement.begin(), refinement.end());
      const auto times = [](const double element) {
        return digits(std::exp2(std::abs(element)), 3) + " times ";
      };
      const std::string smaller = times(*to) + "smaller",
                        larger  = times(*from) + "larger";
      if (*from < 0. && *to > 0.)
        return "cells up to " + smaller + " in some directions and " + larger +
               " in others";
      const std::string most = *to > 0. ? smaller : larger;
      return same_way(refinement, Refinement(refinement.size(), 1.)) ?
               "cells " + most :
               "cells up to " + most + ", not in all directions";
    }



    std::vector<Comparable>
    comparable(const EarlierRun::Values      &parameters,
               const std::uint64_t            n_unknowns,
               const std::vector<EarlierRun> &runs)
    {
      std::vector<Comparable> found;
      for (const EarlierRun &run : runs)
        {
          const auto to_this = refinement(run.parameters, parameters);
          // Of a mesh that adapts itself, or a file that is another by now, the
          // parameters do not say how large cells are.
          if (to_this &&
              parameters_that_differ(run.parameters, parameters).empty() &&
              (main_element(*to_this) == 0. ? run.n_unknowns == n_unknowns :
                                              !run.is_adapted))
            found.push_back({&run, *to_this});
        }
      return found;
    }



    // From the mesh of @p one to that of @p other.
    Refinement
    between(const Comparable &one, const Comparable &other)
    {
      Refinement found = one.to_this;
      for (std::size_t k = 0; k < found.size(); ++k)
        found[k] -= other.to_this[k];
      return found;
    }



    // A run from whose mesh that of @p nearest goes on in the same way as the one
    // of this run does from there; null where there is none.
    const Comparable *
    one_more(const Comparable &nearest, const std::vector<Comparable> &all)
    {
      for (const Comparable &other : all)
        if (same_way(between(other, nearest), nearest.to_this))
          return &other;
      return nullptr;
    }



    // "length 0.01 to 0.03%", or about so much where @p before says the order.
    std::string
    expected(const EarlierRun::Error &error,
             const Comparable        &nearest,
             const Comparable        *before)
    {
      const auto with = [&](const double order, const double element) {
        return error.relative * std::exp2(-order * element);
      };
      const std::string name = shortened(error.name);
      if (before != nullptr)
        for (const EarlierRun::Error &other : before->run->errors)
          if (other.name == error.name)
            {
              const double order =
                std::clamp(std::log2(other.relative / error.relative) /
                             main_element(between(*before, nearest)),
                           0.,
                           highest_order);
              return name + " about " +
                     in_per_cent(with(order, main_element(nearest.to_this))) +
                     "% (order " + digits(order, 2) + ")";
            }
      std::vector<double> values;
      for (const double element : nearest.to_this)
        for (const double order : {least_order, largest_order})
          values.push_back(with(order, element));
      const auto [from, to] = std::minmax_element(values.begin(), values.end());
      return name + " " + in_per_cent(*from) + " to " + in_per_cent(*to) + "%";
    }
  } // namespace



  std::string
  expected_accuracy(const EarlierRun::Values      &parameters,
                    const std::uint64_t            n_unknowns,
                    const std::string             &folder,
                    const std::vector<EarlierRun> &runs)
  {
    const std::vector<Comparable> all =
      comparable(parameters, n_unknowns, runs);
    const auto nearest =
      std::min_element(all.begin(),
                       all.end(),
                       [](const Comparable &a, const Comparable &b) {
                         return std::abs(main_element(a.to_this)) <
                                std::abs(main_element(b.to_this));
                       });
    if (nearest != all.end())
      {
        const EarlierRun &run  = *nearest->run;
        std::string       text = said(run) + "This mesh ";
        if (main_element(nearest->to_this) == 0.)
          return text + "is the same, and so may errors be expected to be.\n";
        text += "has " + with_commas(n_unknowns) + " unknowns and " +
                cells_in_words(nearest->to_this) + ". To be expected: ";
        const Comparable *before = one_more(*nearest, all);
        for (const EarlierRun::Error &error : run.errors)
          text += (&error == &run.errors.front() ? "" : ", ") +
                  expected(error, *nearest, before);
        if (before != nullptr)
          text += ", as errors fell from '" + shortened(before->run->folder) +
                  "' to there";
        return text + "; see doc/accuracy.md.\n";
      }
    for (const EarlierRun &run : runs)
      if (run.folder == folder)
        {
          auto       names = parameters_that_differ(run.parameters, parameters);
          const auto n     = names.size();
          if (names.empty())
            return said(run) + "Nothing follows from that for this mesh: how "
                               "large its cells are beside those there is not "
                               "known.\n";
          names.resize(std::min(n, most_names));
          return said(run) + "Nothing follows from that for this run, which "
                             "differs in " +
                 quoted_list(names) +
                 (n > most_names ?
                    " and " + std::to_string(n - most_names) + " more" :
                    "") +
                 ".\n";
        }
    return "";
  }
} // namespace lumbricus
