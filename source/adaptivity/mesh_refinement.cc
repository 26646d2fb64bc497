// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/mesh_refinement.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/patterns.h>

#include <deal.II/grid/filtered_iterator.h>

#include <cmath>

namespace lumbricus
{
  namespace
  {
    const std::string parameter = "Mesh/Refine where";
  } // namespace



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
    prm.add_parameter("Refine where",
                      formula,
                      "A formula in the place at rest x, y, z: cells at whose "
                      "centre it is positive are refined.");
    prm.leave_subsection();
  }



  void
  MeshRefinement::initialize()
  {
    where = std::make_unique<Expression>(parameter, formula);
  }



  void
  MeshRefinement::refine(ParallelMesh          &triangulation,
                         const IsSlipInterface &is_slip_interface) const
  {
    triangulation.refine_global(n_global);
    for (unsigned int i = 0; i < n_local; ++i)
      {
        mark(triangulation);
        triangulation.execute_coarsening_and_refinement();
      }
    match_levels(triangulation, is_slip_interface);
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
    for (const auto &cell : triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const double value = where->value(cell->center(), 0.);
        if (!std::isfinite(value))
          message = "Parameter '" + parameter + "': the formula '" + formula +
                    "' has no value at the point " +
                    point_text(cell->center()) +
                    ". Give one that is defined in all of the body.";
        else if (value > 0.)
          cell->set_refine_flag();
      }
    throw_on_all_ranks<ExcInput>(message, triangulation.get_communicator());
  }



  void
  match_levels(ParallelMesh          &triangulation,
               const IsSlipInterface &is_slip_interface)
  {
    for (bool all_match = false; !all_match;)
      {
        unsigned int n_marked = 0;
        for (const auto &cell : triangulation.active_cell_iterators() |
                                  dealii::IteratorFilters::LocallyOwnedCell())
          for (const unsigned int f : cell->face_indices())
            if (!cell->at_boundary(f) && cell->neighbor(f)->has_children() &&
                !cell->refine_flag_set() &&
                is_slip_interface(cell->material_id(),
                                  cell->neighbor(f)->material_id()))
              {
                cell->set_refine_flag();
                ++n_marked;
              }
        all_match =
          dealii::Utilities::MPI::sum(n_marked,
                                      triangulation.get_communicator()) == 0;
        if (!all_match)
          triangulation.execute_coarsening_and_refinement();
      }
  }
} // namespace lumbricus
