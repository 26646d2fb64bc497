// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <string>
#include <vector>

namespace
{
  using lumbricus::dim;

  /**
   * The table mean_stress.csv: a row per load step with the volume of the
   * body and its mean Cauchy stress along the axes,
   *
   *   V = int J dV,   s = 1/V int sigma J dV.
   */
  class MeanStress : public lumbricus::Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"step", "t", "volume", "sxx", "syy", "szz"};
    }

    void
    write(lumbricus::TableRows           &rows,
          const lumbricus::OutputContext &context) const override
    {
      // The volume, and the integrals of the stress.
      std::array<double, 1 + dim> sums = {};
      context.visit_points([&](const lumbricus::FieldPoint &point) {
        const double dv = point.J * point.dV;
        sums[0] += dv;
        for (unsigned int d = 0; d < dim; ++d)
          sums[1 + d] += point.sigma[d][d] * dv;
      });
      // Every rank has seen its own cells.
      for (double &sum : sums)
        sum =
          dealii::Utilities::MPI::sum(sum, context.body.space.communicator());

      rows << context.step.number << context.state.time << sums[0];
      for (unsigned int d = 0; d < dim; ++d)
        rows << sums[1 + d] / sums[0];
      rows.end_row();
    }
  };

  // The name is that of the file.
  const lumbricus::Register<lumbricus::Table, MeanStress>
    mean_stress("mean_stress", "the mean stress of the body.");
} // namespace
