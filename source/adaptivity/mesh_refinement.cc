// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/mesh_refinement.h>
#include <lumbricus/core/available_memory.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>

#include <cmath>
#include <sstream>
#include <string>

namespace lumbricus
{
  void
  MeshRefinement::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    prm.add_parameter("Global refinements",
                      n_global,
                      "[-] How often every cell of the coarse mesh is cut into "
                      "eight.",
                      dealii::Patterns::Integer(0, 8));
    prm.add_parameter("Local refinements",
                      n_local,
                      "[-] How often, after that, the cells chosen by 'Refine "
                      "where' are cut into eight. The pieces keep the shape "
                      "of the whole.",
                      dealii::Patterns::Integer(0, 8));
    where.declare_parameter(prm,
                            "A formula in the place at rest x, y, z: cells at "
                            "whose centre it is positive are refined.");
    prm.leave_subsection();
  }



  void
  MeshRefinement::refine(ParallelMesh          &triangulation,
                         const IsSlipInterface &is_slip_interface) const
  {
    check_memory(triangulation);
    triangulation.refine_global(n_global);
    for (unsigned int i = 0; i < n_local; ++i)
      {
        mark(triangulation);
        triangulation.execute_coarsening_and_refinement();
      }
    while (mark_where(triangulation, [&](const auto &cell) {
      return coarser_across_interface(cell, is_slip_interface);
    }))
      triangulation.execute_coarsening_and_refinement();
  }



  void
  MeshRefinement::check_memory(const ParallelMesh &triangulation) const
  {
    // Without the factors of a matrix, which take more.
    constexpr double megabytes_of_cell = 0.01;
    const MPI_Comm   comm              = triangulation.get_communicator();
    const double     n_cells =
      std::pow(8., n_global) * triangulation.n_global_active_cells();
    const double needed = megabytes_of_cell * n_cells /
                          dealii::Utilities::MPI::n_mpi_processes(comm);
    const double       available = available_megabytes(comm);
    std::ostringstream message;
    message.precision(3);
    message << "is " << n_global << ": the mesh would have " << n_cells
            << " cells, which take more than " << needed / 1024.
            << " GB a rank, of " << available / 1024.
            << " GB available. Refine less often, or take more machines.";
    AssertThrow(n_global == 0 || needed <= available,
                ExcInput(
                  about_parameter("Mesh/Global refinements", message.str())));
  }



  unsigned int
  MeshRefinement::n_global_refinements() const
  {
    return n_global;
  }



  void
  MeshRefinement::mark(ParallelMesh &triangulation) const
  {
    std::string message;
    mark_where(triangulation, [&](const auto &cell) {
      const double value = where.value(cell->center(), 0.);
      if (!std::isfinite(value))
        message = about_parameter("Mesh/" + where.parameter(),
                                  ": the formula '" + where.formula() +
                                    "' has no value at the point " +
                                    point_text(cell->center()) +
                                    ". Give one that is defined in all of the "
                                    "body.");
      return value > 0.;
    });
    throw_on_all_ranks<ExcInput>(message, triangulation.get_communicator());
  }
} // namespace lumbricus
