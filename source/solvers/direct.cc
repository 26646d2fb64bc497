// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/linear_solver.h>
#include <lumbricus/solvers/mumps.h>

#include <deal.II/base/timer.h>

namespace lumbricus
{
  /** A factorisation in double precision, of all free unknowns, for every
   * tangent. */
  class Direct : public LinearSolver
  {
  public:
    void
    reinit(const Tangent &new_tangent) override
    {
      tangent = &new_tangent;
      mumps.reset();
    }

    void
    solve(CellVector &x, const CellVector &b, const double tolerance) override
    {
      dealii::Timer timer;
      factor();
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();

      // Iterative refinement makes up for pivots that were not the best.
      timer.restart();
      constexpr unsigned int most_refinements = 3;
      CellVector             r(b);
      x              = 0.;
      unsigned int n = 1;
      for (;; ++n)
        {
          numbering.extract(r, values);
          mumps->solve(values);
          correction.reinit(b);
          numbering.insert(values, correction);
          x += correction;
          tangent->vmult(r, x);
          r.sadd(-1., 1., b);
          if (n > most_refinements || r.l2_norm() <= tolerance * b.l2_norm())
            break;
        }
      count_iterations(n);
      ++counts.n_solves;
      counts.solve_seconds += timer.wall_time();
    }

  private:
    void
    factor()
    {
      const CellUnknowns &unknowns = tangent->unknowns;
      if (mumps == nullptr)
        {
          const MPI_Comm comm = tangent->space.communicator();
          numbering.reinit(unknowns, true, comm);
          mumps = std::make_unique<Mumps<double>>(
            comm,
            Mumps<double>::Options{tangent->symmetric, true, 0.},
            numbering);
          mumps->analyse(unknowns, unknowns.n_cells(), 0);
        }
      mumps->begin();
      std::vector<double> K;
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        {
          tangent->cell_matrix(i, K);
          unknowns.apply_constraints(i, K);
          mumps->add(unknowns.free_unknowns(i).size(), K.data());
        }
      mumps->factor();
    }

    const Tangent                 *tangent = nullptr;
    FreeNumbering                  numbering;
    std::unique_ptr<Mumps<double>> mumps;
    std::vector<double>            values;
    CellVector                     correction;
  };

  static const Register<LinearSolver, Direct>
    direct("direct", "MUMPS, with a factorisation for every Newton iteration.");
} // namespace lumbricus
