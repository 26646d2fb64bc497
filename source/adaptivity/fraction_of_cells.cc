// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/marking_rule.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace lumbricus
{
  /**
   * Fixed parts of the mesh: of n cells ceil(f_r n) are refined, and as many
   * families merged as there are whole ones in f_m n cells.
   */
  class FractionOfCells : public MarkingRule
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Refine",
                        refine,
                        "[-] Fraction of all cells to refine, those of the "
                        "largest estimated error.",
                        dealii::Patterns::Double(0., 1.));
      prm.add_parameter("Merge",
                        merge,
                        "[-] Fraction of all cells to merge, those of the "
                        "smallest.",
                        dealii::Patterns::Double(0., 1.));
    }

    Counts
    counts(const std::vector<double> & /*of_cells*/,
           const std::vector<double> & /*of_families*/,
           const Mesh &mesh) const override
    {
      return {static_cast<std::size_t>(std::ceil(refine * mesh.n_cells)),
              static_cast<std::size_t>(merge * mesh.n_cells / 8.)};
    }

  private:
    double refine = 0.1;
    double merge  = 0.05;
  };



  static const Register<MarkingRule, FractionOfCells>
    fraction_of_cells("fraction of cells", "a fixed fraction of them.");
} // namespace lumbricus
