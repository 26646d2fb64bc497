// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/adaptivity.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace lumbricus
{
  namespace
  {
    // Errors that differ by less than this, relative, count as the same.
    constexpr double tie = 1e-3;



    // The values of all ranks, rank by rank.
    std::vector<double>
    gather(const std::vector<double> &values, const MPI_Comm comm)
    {
      std::vector<double> all;
      for (const auto &of_rank :
           dealii::Utilities::MPI::all_gather(comm, values))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      return all;
    }



    unsigned int
    level(const ParallelMesh::cell_iterator &cell)
    {
      return cell->level();
    }



    unsigned int
    tissue(const ParallelMesh::cell_iterator &cell)
    {
      return Region::of(cell->material_id()).tissue;
    }
  } // namespace



  Adaptivity::Adaptivity()
    : estimator_choice("Estimator",
                       "stress jump",
                       "How the error of a cell is estimated.")
    , rule("Marking", "fraction of error", "How many cells are adapted.")
  {}



  void
  Adaptivity::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Adaptivity");
    prm.add_parameter("Every",
                      every,
                      "[-] Adapt the mesh after every so many load steps, once "
                      "the liquid is hydrostatic, and solve again at the same "
                      "load; 0 for never.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Cycles",
                      cycles,
                      "[-] How often in a row.",
                      dealii::Patterns::Integer(1));
    estimator_choice.declare_parameters(prm);
    rule.declare_parameters(prm);
    levels.declare_parameters(prm);
    prm.leave_subsection();
  }



  bool
  Adaptivity::extend_parameters(dealii::ParameterHandler &prm,
                                const Extent              extent)
  {
    prm.enter_subsection("Adaptivity");
    bool extended = estimator_choice.extend_parameters(prm, extent);
    extended |= rule.extend_parameters(prm, extent);
    prm.leave_subsection();
    return extended;
  }



  void
  Adaptivity::check_parameters() const
  {
    within_section("Adaptivity", [&]() {
      estimator_choice.check_parameters();
      rule.check_parameters();
      levels.check_parameters();
    });
  }



  void
  Adaptivity::initialize(const Anatomy &anatomy, const unsigned int least_level)
  {
    levels.initialize(anatomy, least_level);
    within_section("Adaptivity",
                   [&]() { estimator_choice.get()->initialize(anatomy); });
  }



  bool
  Adaptivity::due(const unsigned int number) const
  {
    return every > 0 && number % every == 0;
  }



  unsigned int
  Adaptivity::n_cycles() const
  {
    return cycles;
  }



  const ErrorEstimator &
  Adaptivity::estimator() const
  {
    return *estimator_choice;
  }



  bool
  Adaptivity::may_be_refined(const Cell &cell) const
  {
    return level(cell) < levels.finest(tissue(cell));
  }



  bool
  Adaptivity::may_be_merged(const Cell            &cell,
                            const IsSlipInterface &is_slip_interface) const
  {
    return cell->is_active() && cell->is_locally_owned() &&
           level(cell) > levels.coarsest(tissue(cell)) &&
           !at_slip_interface(cell, is_slip_interface);
  }



  std::vector<Adaptivity::Family>
  Adaptivity::families(const ErrorEstimate   &estimate,
                       const IsSlipInterface &is_slip_interface,
                       const ParallelMesh    &triangulation) const
  {
    std::vector<double> contributions(triangulation.n_active_cells());
    unsigned int        i = 0;
    for (const auto &cell : triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      contributions[cell->active_cell_index()] = estimate.contributions[i++];

    // Each is found at its first child; p4est keeps families on one rank.
    std::vector<Family> result;
    for (const auto &cell : triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        if (cell->level() == 0 || cell->parent()->child(0) != cell)
          continue;
        Family family{cell->parent(), 0.};
        bool   all = true;
        for (const auto &child : family.parent->child_iterators())
          {
            all = all && may_be_merged(child, is_slip_interface);
            if (all)
              family.contribution += contributions[child->active_cell_index()];
          }
        if (all)
          result.push_back(family);
      }
    return result;
  }



  bool
  Adaptivity::mark(const ErrorEstimate   &estimate,
                   const std::size_t      n_unknowns,
                   const IsSlipInterface &is_slip_interface,
                   ParallelMesh          &triangulation) const
  {
    const MPI_Comm comm  = triangulation.get_communicator();
    const auto     owned = triangulation.active_cell_iterators() |
                       dealii::IteratorFilters::LocallyOwnedCell();
    const auto families_here =
      families(estimate, is_slip_interface, triangulation);

    std::vector<double> of_cells, of_families;
    unsigned int        i = 0;
    for (const auto &cell : owned)
      {
        const double contribution = estimate.contributions[i++];
        if (may_be_refined(cell))
          of_cells.push_back(contribution);
      }
    for (const Family &family : families_here)
      of_families.push_back(family.contribution);
    of_cells    = gather(of_cells, comm);
    of_families = gather(of_families, comm);
    std::sort(of_cells.begin(), of_cells.end(), std::greater<double>());
    std::sort(of_families.begin(), of_families.end());

    const auto counts =
      rule->counts(of_cells,
                   of_families,
                   {triangulation.n_global_active_cells(), n_unknowns});
    const auto n_refined = std::min(counts.refined, of_cells.size());
    const auto n_merged  = std::min(counts.merged, of_families.size());

    const double refined_from = n_refined > 0 ?
                                  (1. - tie) * of_cells[n_refined - 1] :
                                  std::numeric_limits<double>::max();
    const double merged_upto =
      n_merged > 0 ? (1. + tie) * of_families[n_merged - 1] : -1.;

    unsigned int n_marked = 0;
    for (const Family &family : families_here)
      {
        const bool too_fine =
          level(family.parent) >= levels.finest(tissue(family.parent));
        if (!too_fine && family.contribution > merged_upto)
          continue;
        for (const auto &child : family.parent->child_iterators())
          child->set_coarsen_flag();
        ++n_marked;
      }
    i = 0;
    for (const auto &cell : owned)
      {
        const double contribution = estimate.contributions[i++];
        if (level(cell) >= levels.coarsest(tissue(cell)) &&
            (!may_be_refined(cell) || contribution < refined_from))
          continue;
        cell->clear_coarsen_flag();
        cell->set_refine_flag();
        ++n_marked;
      }
    return dealii::Utilities::MPI::sum(n_marked, comm) > 0;
  }
} // namespace lumbricus
