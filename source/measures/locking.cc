// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/materials/locking_law.h>
#include <lumbricus/measures/locking.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace lumbricus
{
  namespace
  {
    // Empty for a law that does not lock.
    const LockingLaw *
    locking_law(const Tissue &tissue)
    {
      return dynamic_cast<const LockingLaw *>(&tissue.law());
    }



    // The largest of all ranks, of the lowest one that has it.
    Locking
    largest(const Locking &mine, const MPI_Comm comm)
    {
      const std::vector<double> all = {mine.share,
                                       1. * mine.segment,
                                       mine.X[0],
                                       mine.X[1],
                                       mine.X[2]};
      Locking                   most;
      for (const auto &of_rank : dealii::Utilities::MPI::all_gather(comm, all))
        if (of_rank[0] > most.share)
          most = {of_rank[0],
                  static_cast<unsigned int>(of_rank[1]),
                  dealii::Point<dim>(of_rank[2], of_rank[3], of_rank[4])};
      return most;
    }
  } // namespace



  std::map<unsigned int, Locking>
  locking_of_tissues(const Body           &body,
                     const ReferenceField &references,
                     const State          &state)
  {
    std::map<unsigned int, Locking> most;
    const unsigned int n_tissues = body.anatomy.geometry().tissues().size();
    for (unsigned int i = 0; i < n_tissues; ++i)
      if (locking_law(body.anatomy.tissue(i)) != nullptr)
        most[i] = Locking();
    if (most.empty())
      return most;

    const Vector  relevant = body.space.with_ghosts(state.solution);
    ElementKernel kernel;
    std::vector<dealii::types::global_dof_index> indices(
      body.space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const LockingLaw *const law = locking_law(cell.tissue);
        if (law == nullptr)
          continue;
        Locking &here = most.at(cell.region.tissue);
        kernel.read(body.space, cell.iterator, relevant, indices);
        kernel.compute_deformation(body.shapes.cell(cell.index));
        const MaterialPoint *const points = references.cell(cell.index);
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            const double share =
              law->locking(kernel.F[q], points[q].reference);
            if (share > here.share)
              here = {share,
                      cell.region.segment + 1,
                      body.shapes.quadrature_point(cell.index, q)};
          }
      }
    for (auto &[tissue, locking] : most)
      locking = largest(locking, body.space.communicator());
    return most;
  }
} // namespace lumbricus
