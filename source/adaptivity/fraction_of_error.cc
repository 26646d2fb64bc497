// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/marking_rule.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <numeric>

namespace lumbricus
{
  /** The bulk criterion of Doerfler (SIAM J. Numer. Anal. 33, 1996). */
  class FractionOfError : public MarkingRule
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Refine",
                        refine,
                        "[-] Refine the fewest cells that have this fraction "
                        "of the sum of eta_K^2.",
                        dealii::Patterns::Double(0., 1.));
      prm.add_parameter("Merge",
                        merge,
                        "[-] Merge, eight to one, the most cells that have no "
                        "more than this fraction of it.",
                        dealii::Patterns::Double(0., 1.));
    }

    Counts
    counts(const std::vector<double> &of_cells,
           const std::vector<double> &of_families,
           const Mesh & /*mesh*/) const override
    {
      const double total =
        std::accumulate(of_cells.begin(), of_cells.end(), 0.);
      Counts counts;
      for (double sum = 0.;
           sum < refine * total && counts.refined < of_cells.size();
           ++counts.refined)
        sum += of_cells[counts.refined];
      double sum = 0.;
      while (counts.merged < of_families.size() &&
             (sum += of_families[counts.merged]) <= merge * total)
        ++counts.merged;
      return counts;
    }

  private:
    double refine = 0.5;
    double merge  = 1e-3;
  };



  static const Register<MarkingRule, FractionOfError> fraction_of_error(
    "fraction of error",
    "as many as have a fraction of the estimated error (Doerfler).");
} // namespace lumbricus
