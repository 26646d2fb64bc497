// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/refinement_levels.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    const std::string of_tissues_name = "Levels of tissues";
  } // namespace



  void
  RefinementLevels::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Coarsest level",
                      common.coarsest,
                      "[-] How often every cell of the coarse mesh is cut at "
                      "least. It is never less than 'Mesh/Global refinements', "
                      "up to which cells follow the curved surfaces.",
                      dealii::Patterns::Integer(0, 12));
    prm.add_parameter("Finest level",
                      common.finest,
                      "[-] How often a cell of the coarse mesh is cut at "
                      "most, global refinements included.",
                      dealii::Patterns::Integer(0, 12));
    prm.add_parameter(of_tissues_name,
                      of_tissues,
                      "[list of name: coarsest - finest] Levels of tissues "
                      "that differ from these, like 'liquid: 1 - 2, septum: "
                      "1 - 4'.",
                      dealii::Patterns::Map(dealii::Patterns::Anything(),
                                            dealii::Patterns::Anything(),
                                            0,
                                            Region::max_n_tissues));
  }



  RefinementLevels::Range
  RefinementLevels::parse(const std::string &tissue, const std::string &text)
  {
    const auto parts = dealii::Utilities::split_string_list(text, '-');
    const dealii::Patterns::Integer level(0, 12);
    AssertThrow(parts.size() == 2 && level.match(parts[0]) &&
                  level.match(parts[1]) &&
                  std::stoul(parts[0]) <= std::stoul(parts[1]),
                ExcParameter(of_tissues_name,
                             "has '" + text + "' as the levels of '" + tissue +
                               "'. Give the coarsest and the finest level, "
                               "two numbers of 0 to 12, like '1 - 3'."));
    return {static_cast<unsigned int>(std::stoul(parts[0])),
            static_cast<unsigned int>(std::stoul(parts[1]))};
  }



  void
  RefinementLevels::check_parameters() const
  {
    AssertThrow(common.coarsest <= common.finest,
                ExcParameter("Finest level",
                             "is " + std::to_string(common.finest) +
                               ", less than 'Coarsest level', " +
                               std::to_string(common.coarsest) +
                               ". Raise it, or lower that."));
    for (const auto &[tissue, text] : of_tissues)
      parse(tissue, text);
  }



  void
  RefinementLevels::initialize(const Anatomy &anatomy, const unsigned int least)
  {
    by_tissue.clear();
    auto                     unknown = of_tissues;
    std::vector<std::string> names;
    for (const TissueName &tissue : anatomy.geometry().tissues())
      {
        const auto own = of_tissues.find(tissue.name);
        Range      range =
          own == of_tissues.end() ? common : parse(own->first, own->second);
        range.coarsest = std::max(range.coarsest, least);
        range.finest   = std::max(range.finest, least);
        by_tissue.push_back(range);
        unknown.erase(tissue.name);
        names.push_back(tissue.name);
      }

    AssertThrow(unknown.empty(),
                ExcInput(about_parameter(
                  "Adaptivity/" + of_tissues_name,
                  "names the tissue '" +
                    (unknown.empty() ? "" : unknown.begin()->first) +
                    "', which the body does not have. Name one that it has: " +
                    quoted_list(names) + ".")));
  }



  unsigned int
  RefinementLevels::coarsest(const unsigned int tissue) const
  {
    return by_tissue[tissue].coarsest;
  }



  unsigned int
  RefinementLevels::finest(const unsigned int tissue) const
  {
    return by_tissue[tissue].finest;
  }
} // namespace lumbricus
