// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/divided_factor.h>

#include <lumbricus/core/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "front_tree.h"

namespace lumbricus
{
  namespace
  {
    double
    square(const double x)
    {
      return x * x;
    }
  } // namespace



  DividedFactor::DividedFactor(const MPI_Comm               comm,
                               const Mumps<float>::Options &options,
                               const CellUnknowns          &unknowns,
                               const unsigned int           n_left_out,
                               const FreeNumbering         &numbering,
                               const MoreEntries           &more,
                               const double                 dense_entries,
                               const double                 shared_entries)
    : comm(comm)
    , rank(dealii::Utilities::MPI::this_mpi_process(comm))
    , symmetric(options.symmetric)
    , tree(dealii::Utilities::MPI::n_mpi_processes(comm))
    , numbering(numbering)
    , n_more(more.n_unknowns)
    , division(unknowns, n_left_out, numbering, more, tree, comm)
    , fronts(std::make_unique<FrontTree>(tree,
                                         division.shared,
                                         numbering.size(),
                                         shared_entries,
                                         // What MUMPS pivots is L U here.
                                         symmetric && !options.pivoting,
                                         comm))
  {
    const double largest =
      dealii::Utilities::MPI::max(square(
                                    std::max<double>(division.shared.size(),
                                                     fronts->largest_front())),
                                  comm);
    // MPI counts with an int.
    is_divided = largest <= std::min(dense_entries * numbering.size(),
                                     double(std::numeric_limits<int>::max()));
    if (is_divided)
      plan_inside(options, unknowns, n_left_out, more);
    else
      {
        fronts.reset();
        mumps = std::make_unique<Mumps<float>>(comm, options, numbering);
        mumps->analyse(unknowns, unknowns.n_cells(), n_left_out, more);
      }
  }



  void
  DividedFactor::plan_inside(const Mumps<float>::Options &options,
                             const CellUnknowns          &unknowns,
                             const unsigned int           n_left_out,
                             const MoreEntries           &more)
  {
    // What is inside comes first (where nothing is, an unknown that hangs
    // together with nothing: MUMPS wants one to eliminate), then what is shared,
    // then those that no cell has.
    Vector layout;
    unknowns.reinit_vector(layout);
    std::vector<unsigned int> number_at(
      layout.get_partitioner()->locally_owned_size() +
        layout.get_partitioner()->n_ghost_indices(),
      0);
    unsigned int n = 0;
    if (division.inside.empty())
      lonely = n++;
    for (const auto *places : {&division.inside, &division.shared_places})
      for (const unsigned int place : *places)
        number_at[place] = n++;
    inside_numbering = FreeNumbering(number_at, division.inside, n);

    for (const unsigned int place : division.shared_places)
      shared_numbers.push_back(number_at[place]);
    n += division.more_inside.size();
    while (shared_numbers.size() < division.shared.size())
      shared_numbers.push_back(n++);
    inside_values.resize(n);
    of_shared.resize(shared_numbers.size());

    mumps = std::make_unique<Mumps<float>>(MPI_COMM_SELF,
                                           options,
                                           inside_numbering,
                                           comm);
    mumps->analyse(unknowns,
                   unknowns.n_cells(),
                   n_left_out,
                   inside_entries(more),
                   shared_numbers);
  }



  MoreEntries
  DividedFactor::inside_entries(const MoreEntries &more) const
  {
    std::map<unsigned int, unsigned int> number_of; // of unknowns without cells
    for (unsigned int k = 0; k < division.more_inside.size(); ++k)
      number_of[division.more_inside[k]] = inside_numbering.size() + k;
    for (unsigned int k = division.shared_places.size();
         k < division.shared.size();
         ++k)
      number_of[division.shared[k].number - numbering.size()] =
        shared_numbers[k];
    const unsigned int first =
      numbering.n_owned() > 0 ? numbering.number(numbering.places()[0]) : 0;
    const auto here = [&](const unsigned int number) {
      return number >= numbering.size() ?
               number_of.at(number - numbering.size()) :
               inside_numbering.number(numbering.places()[number - first]);
    };

    MoreEntries result;
    result.n_unknowns = number_of.size();
    for (unsigned int k = 0; k < more.own.rows.size(); ++k)
      result.own.add(here(more.own.rows[k]),
                     here(more.own.columns[k]),
                     more.own.values[k]);
    for (const unsigned int k : division.common_entries)
      result.own.add(here(more.common.rows[k]),
                     here(more.common.columns[k]),
                     more.common.values[k]);
    if (lonely)
      result.own.add(*lonely, *lonely, 1.);
    return result;
  }



  DividedFactor::~DividedFactor() = default;



  double
  DividedFactor::planned_flops() const
  {
    const double on_all_ranks =
      dealii::Utilities::MPI::sum((is_divided || rank == 0 ?
                                     mumps->planned_flops() :
                                     0.) +
                                    (is_divided ? fronts->flops() : 0.),
                                  comm);
    return on_all_ranks;
  }



  double
  DividedFactor::planned_megabytes() const
  {
    const double entries =
      square(shared_numbers.size()) + (is_divided ? fronts->n_entries() : 0.);
    return dealii::Utilities::MPI::max(mumps->planned_megabytes() +
                                         entries * sizeof(float) / 1e6,
                                       comm);
  }



  void
  DividedFactor::begin()
  {
    mumps->begin();
  }



  void
  DividedFactor::add(const unsigned int n, const double *matrix)
  {
    mumps->add(n, matrix);
  }



  void
  DividedFactor::add(const MoreEntries &more)
  {
    mumps->add(is_divided ? inside_entries(more) : more);
  }



  void
  DividedFactor::factor()
  {
    mumps->factor();
    double flops   = mumps->factor_flops();
    double entries = mumps->factor_entries();
    if (is_divided)
      {
        factor_shared();
        flops += fronts->flops();
        entries += fronts->n_entries();
        flops   = dealii::Utilities::MPI::sum(flops, comm);
        entries = dealii::Utilities::MPI::sum(entries, comm);
      }
    factor_cost = Mumps<float>::cost(flops, entries);
  }



  void
  DividedFactor::factor_shared()
  {
    const std::size_t  n = shared_numbers.size();
    std::vector<float> matrix = mumps->left_matrix();
    for (std::size_t r = 0; symmetric && r < n; ++r)
      for (std::size_t s = 0; s < r; ++s)
        matrix[s * n + r] = matrix[r * n + s];
    const bool is_singular = !fronts->factor(std::move(matrix));
    AssertThrow(!dealii::Utilities::MPI::logical_or(is_singular, comm),
                ExcNotConverged("The tangent matrix is singular"));
  }



  void
  DividedFactor::solve(Vector &x, std::vector<float> &more)
  {
    if (!is_divided)
      {
        solve_undivided(x, more);
        return;
      }

    // The first rank has the unknowns that no cell has; others need some.
    std::vector<float> of_more = more;
    if (n_more > 0)
      {
        of_more.resize(n_more);
        MPI_Bcast(of_more.data(), n_more, MPI_FLOAT, 0, comm);
      }
    const unsigned int first_more = inside_numbering.size();
    for (const unsigned int place : division.inside)
      inside_values[inside_numbering.number(place)] = x.local_element(place);
    for (unsigned int k = 0; k < division.more_inside.size(); ++k)
      inside_values[first_more + k] = of_more[division.more_inside[k]];
    std::fill(of_shared.begin(), of_shared.end(), 0.);
    for (unsigned int k = 0; k < division.shared_places.size(); ++k)
      of_shared[k] = x.local_element(division.shared_places[k]);

    mumps->reduce(inside_values, of_shared);
    fronts->solve(of_shared, of_more);
    mumps->expand(of_shared, inside_values);

    for (unsigned int k = 0; k < division.shared_places.size(); ++k)
      x.local_element(division.shared_places[k]) = of_shared[k];
    for (const unsigned int place : division.inside)
      x.local_element(place) = inside_values[inside_numbering.number(place)];
    for (unsigned int k = 0; k < division.more_inside.size(); ++k)
      of_more[division.more_inside[k]] = inside_values[first_more + k];
    if (n_more > 0)
      MPI_Reduce(of_more.data(),
                 more.data(),
                 n_more,
                 MPI_FLOAT,
                 MPI_SUM,
                 0,
                 comm);
  }



  void
  DividedFactor::solve_undivided(Vector &x, std::vector<float> &more)
  {
    x.compress(dealii::VectorOperation::add);
    std::vector<float> values;
    numbering.extract(x, values);
    mumps->solve(values, more);
    numbering.insert(values, x);
    x.update_ghost_values();
  }
} // namespace lumbricus
