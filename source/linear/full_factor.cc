// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/full_factor.h>

namespace lumbricus
{
  FullFactor::FullFactor(const Tangent &tangent, const MPI_Comm comm)
    : tangent(tangent)
    , numbering(tangent.unknowns, true, comm)
    , mumps(comm, {tangent.symmetric, true, 0.}, numbering)
  {
    mumps.analyse(tangent.unknowns, tangent.unknowns.n_cells(), 0);
  }



  void
  FullFactor::factor()
  {
    const CellUnknowns &unknowns = tangent.unknowns;
    std::vector<double> K;
    mumps.begin();
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      {
        tangent.exact_cell_matrix(i, K);
        unknowns.apply_constraints(i, K);
        mumps.add(unknowns.free_unknowns(i).size(), K.data());
      }
    mumps.factor();
  }



  void
  FullFactor::vmult(Vector &y, const Vector &x) const
  {
    numbering.extract(x, values);
    mumps.solve(values);
    y = x; // in the constrained unknowns
    numbering.insert(values, y);
  }



  double
  FullFactor::cost() const
  {
    return mumps.factor_cost();
  }
} // namespace lumbricus
