// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace lumbricus
{
  /** The number of an unknown, over all ranks. */
  using Index = dealii::types::global_dof_index;



  CellUnknowns::CellUnknowns(const MixedSpace &space)
    : space(space)
  {}



  void
  CellUnknowns::reinit(const dealii::AffineConstraints<double> &constraints)
  {
    std::vector<Index> of_cells;
    std::vector<Index> indices(n_per_cell);
    for (const auto &cell : space.owned_cells())
      {
        cell->get_dof_indices(indices);
        const std::size_t begin = of_cells.size();
        of_cells.resize(begin + n_per_cell);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            of_cells[begin + displacement(c, n)] =
              indices[space.displacement_dof[c][n]];
        for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
          of_cells[begin + pressure(m)] = indices[space.pressure_dof[m]];
        for (unsigned int k = 0; k < n_private; ++k)
          Assert(!constraints.is_constrained(of_cells[begin + k]),
                 dealii::ExcInternalError());
      }
    reinit(space.locally_owned, of_cells, constraints);
  }



  void
  CellUnknowns::reinit(const dealii::IndexSet                  &owned,
                       const std::vector<Index>                &of_cells,
                       const dealii::AffineConstraints<double> &constraints)
  {
    std::vector<Index> needed;
    for (const Index index : of_cells)
      {
        if (!owned.is_element(index))
          needed.push_back(index);
        if (const auto *entries = constraints.get_constraint_entries(index))
          for (const auto &[target, weight] : *entries)
            if (!owned.is_element(target))
              needed.push_back(target);
      }
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    dealii::IndexSet ghosts(owned.size());
    ghosts.add_indices(needed.begin(), needed.end());
    ghosts.compress();
    partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(
      owned, ghosts, space.communicator());

    constrained.assign(owned.n_elements(), false);
    for (const auto &line : constraints.get_lines())
      if (owned.is_element(line.index))
        constrained[owned.index_within_set(line.index)] = true;

    const unsigned int n_cells = of_cells.size() / n_per_cell;
    place.resize(of_cells.size());
    for (std::size_t k = 0; k < of_cells.size(); ++k)
      place[k] = partitioner->global_to_local(of_cells[k]);

    constrained_cells.clear();
    of_constrained_cell.assign(n_cells, -1);
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        const Index *index = of_cells.data() + std::size_t(i) * n_per_cell;
        if (std::none_of(index, index + n_per_cell, [&](const Index k) {
              return constraints.is_constrained(k);
            }))
          continue;

        Constrained C;
        const auto  column_of = [&](const Index k) {
          const unsigned int target = partitioner->global_to_local(k);
          const auto         found =
            std::find(C.free_unknowns.begin(), C.free_unknowns.end(), target);
          if (found == C.free_unknowns.end())
            {
              C.free_unknowns.push_back(target);
              return static_cast<unsigned int>(C.free_unknowns.size() - 1);
            }
          return static_cast<unsigned int>(found - C.free_unknowns.begin());
        };
        for (unsigned int r = 0; r < n_per_cell; ++r)
          {
            C.row_begin.push_back(C.column.size());
            if (!constraints.is_constrained(index[r]))
              {
                C.column.push_back(column_of(index[r]));
                C.weight.push_back(1.);
                continue;
              }
            C.rows.push_back(r);
            C.indices.push_back(index[r]);
            for (const auto &[target, weight] :
                 *constraints.get_constraint_entries(index[r]))
              {
                C.column.push_back(column_of(target));
                C.weight.push_back(weight);
              }
          }
        C.row_begin.push_back(C.column.size());
        of_constrained_cell[i] = constrained_cells.size();
        constrained_cells.push_back(C);
      }
    update_inhomogeneities(constraints);
  }



  bool
  CellUnknowns::update_weights(
    const dealii::AffineConstraints<double> &constraints)
  {
    CellUnknowns now(space);
    now.reinit(constraints);
    const bool differs = !now.is_like(*this);
    if (dealii::Utilities::MPI::max(differs ? 1 : 0, space.communicator()) > 0)
      return false;
    constrained_cells = std::move(now.constrained_cells);
    return true;
  }



  bool
  CellUnknowns::is_like(const CellUnknowns &other) const
  {
    return other.partitioner != nullptr &&
           partitioner->is_compatible(*other.partitioner) &&
           place == other.place && constrained == other.constrained &&
           of_constrained_cell == other.of_constrained_cell &&
           std::equal(constrained_cells.begin(),
                      constrained_cells.end(),
                      other.constrained_cells.begin(),
                      other.constrained_cells.end(),
                      [](const Constrained &a, const Constrained &b) {
                        return a.free_unknowns == b.free_unknowns &&
                               a.row_begin == b.row_begin &&
                               a.column == b.column && a.rows == b.rows &&
                               a.indices == b.indices;
                      });
  }



  void
  CellUnknowns::update_inhomogeneities(
    const dealii::AffineConstraints<double> &constraints)
  {
    for (Constrained &C : constrained_cells)
      {
        C.inhomogeneities.clear();
        for (const Index index : C.indices)
          C.inhomogeneities.push_back(constraints.get_inhomogeneity(index));
      }
  }



  void
  CellUnknowns::reinit_vector(Vector &x) const
  {
    x.reinit(partitioner);
  }



  void
  CellUnknowns::read(const unsigned int i,
                     const Vector      &x,
                     double            *values) const
  {
    const unsigned int *const of_cell = places(i);
    const double *const       entries = x.begin();
    for (unsigned int k = 0; k < n_per_cell; ++k)
      values[k] = entries[of_cell[k]];
  }



  void
  CellUnknowns::read_free(const unsigned int i,
                          const Vector      &x,
                          double            *values) const
  {
    if (of_constrained_cell[i] < 0)
      {
        read(i, x, values);
        return;
      }
    const Constrained  &C       = constrained_cells[of_constrained_cell[i]];
    const double *const entries = x.begin();
    for (unsigned int r = 0; r < n_per_cell; ++r)
      {
        values[r] = 0.;
        for (unsigned int e = C.row_begin[r]; e < C.row_begin[r + 1]; ++e)
          values[r] += C.weight[e] * entries[C.free_unknowns[C.column[e]]];
      }
  }



  bool
  CellUnknowns::read_inhomogeneity(const unsigned int i, double *values) const
  {
    if (of_constrained_cell[i] < 0)
      return false;
    const Constrained &C   = constrained_cells[of_constrained_cell[i]];
    bool               any = false;
    std::fill(values, values + n_per_cell, 0.);
    for (unsigned int k = 0; k < C.rows.size(); ++k)
      {
        values[C.rows[k]] = C.inhomogeneities[k];
        any               = any || C.inhomogeneities[k] != 0.;
      }
    return any;
  }



  void
  CellUnknowns::add(const unsigned int i, const double *values, Vector &x) const
  {
    double *const entries = x.begin();
    if (of_constrained_cell[i] < 0)
      {
        const unsigned int *const of_cell = places(i);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          entries[of_cell[k]] += values[k];
        return;
      }
    const Constrained &C = constrained_cells[of_constrained_cell[i]];
    for (unsigned int r = 0; r < n_per_cell; ++r)
      for (unsigned int e = C.row_begin[r]; e < C.row_begin[r + 1]; ++e)
        entries[C.free_unknowns[C.column[e]]] += C.weight[e] * values[r];
  }



  dealii::ArrayView<const unsigned int>
  CellUnknowns::free_unknowns(const unsigned int i) const
  {
    if (of_constrained_cell[i] < 0)
      return {places(i), n_per_cell};
    const auto &hung_on =
      constrained_cells[of_constrained_cell[i]].free_unknowns;
    return {hung_on.data(), hung_on.size()};
  }



  bool
  CellUnknowns::is_constrained(const unsigned int i, const unsigned int k) const
  {
    if (of_constrained_cell[i] < 0)
      return false;
    const auto &rows = constrained_cells[of_constrained_cell[i]].rows;
    return std::binary_search(rows.begin(), rows.end(), k);
  }



  std::vector<std::pair<unsigned int, double>>
  CellUnknowns::row(const unsigned int i, const unsigned int k) const
  {
    if (of_constrained_cell[i] < 0)
      return {{places(i)[k], 1.}};
    const Constrained &C = constrained_cells[of_constrained_cell[i]];
    std::vector<std::pair<unsigned int, double>> entries;
    for (unsigned int e = C.row_begin[k]; e < C.row_begin[k + 1]; ++e)
      entries.emplace_back(C.free_unknowns[C.column[e]], C.weight[e]);
    return entries;
  }



  void
  CellUnknowns::apply_constraints(const unsigned int   i,
                                  std::vector<double> &matrix) const
  {
    AssertDimension(matrix.size(), n_per_cell * n_per_cell);
    if (of_constrained_cell[i] < 0)
      return;
    const Constrained  &C      = constrained_cells[of_constrained_cell[i]];
    const unsigned int  n_free = C.free_unknowns.size();
    std::vector<double> half(n_per_cell * n_free, 0.); // matrix C
    for (unsigned int r = 0; r < n_per_cell; ++r)
      for (unsigned int s = 0; s < n_per_cell; ++s)
        for (unsigned int e = C.row_begin[s]; e < C.row_begin[s + 1]; ++e)
          half[r * n_free + C.column[e]] +=
            matrix[r * n_per_cell + s] * C.weight[e];
    matrix.assign(n_free * n_free, 0.);
    for (unsigned int r = 0; r < n_per_cell; ++r)
      for (unsigned int e = C.row_begin[r]; e < C.row_begin[r + 1]; ++e)
        for (unsigned int s = 0; s < n_free; ++s)
          matrix[C.column[e] * n_free + s] +=
            C.weight[e] * half[r * n_free + s];
  }
} // namespace lumbricus
