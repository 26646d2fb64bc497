// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/marking_rule.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

namespace lumbricus
{
  /**
   * A cell refined is seven cells more, eight cells merged are seven fewer.
   * What is merged makes room for what is refined.
   */
  class NumberOfUnknowns : public MarkingRule
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Target",
                        target,
                        "[number] How many unknowns to have, about: hanging "
                        "nodes and the balance of levels add some.",
                        dealii::Patterns::Integer(1));
      prm.add_parameter("Refine",
                        refine,
                        "[-] At most this fraction of all cells at once, so "
                        "that a few adaptations find where they are needed.",
                        dealii::Patterns::Double(0., 1.));
      prm.add_parameter("Merge",
                        merge,
                        "[-] Fraction of all cells to merge, those of the "
                        "smallest estimated error.",
                        dealii::Patterns::Double(0., 1.));
    }

    Counts
    counts(const std::vector<double> & /*of_cells*/,
           const std::vector<double> &of_families,
           const Mesh                &mesh) const override
    {
      const double n_cells = mesh.n_cells;
      const double wanted  = target * n_cells / mesh.n_unknowns;

      // Above the target merge what has to go.
      const double n_merged =
        std::min<double>(of_families.size(),
                         std::max(merge * n_cells / 8.,
                                  (n_cells - wanted) / 7.));
      const double room = wanted - n_cells + 7. * n_merged;
      const double n_refined =
        std::min(refine * n_cells, std::max(room / 7., 0.));
      return {static_cast<std::size_t>(n_refined),
              static_cast<std::size_t>(n_merged)};
    }

  private:
    unsigned int target = 50000;
    double       refine = 0.2;
    double       merge  = 0.05;
  };



  static const Register<MarkingRule, NumberOfUnknowns>
    number_of_unknowns("number of unknowns",
                       "as many as make a number of unknowns.");
} // namespace lumbricus
