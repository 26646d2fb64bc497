// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/multigrid/embedding.h>

#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  Embedding::Embedding()
  {
    const dealii::FE_Q<dim>   displacement(MixedSpace::degree);
    const dealii::FE_DGP<dim> pressure(MixedSpace::degree - 1);
    constexpr double          zero = 1e-12;
    for (unsigned int child = 0; child < n_children; ++child)
      {
        const auto &Q = displacement.get_prolongation_matrix(child);
        for (unsigned int i = 0; i < MixedSpace::n_nodes; ++i)
          for (unsigned int j = 0; j < MixedSpace::n_nodes; ++j)
            if (std::abs(Q(i, j)) > zero)
              for (unsigned int c = 0; c < dim; ++c)
                entries[child].push_back({CellUnknowns::displacement(c, i),
                                          CellUnknowns::displacement(c, j),
                                          Q(i, j)});
        const auto &R = pressure.get_prolongation_matrix(child);
        for (unsigned int i = 0; i < MixedSpace::n_pressure_modes; ++i)
          for (unsigned int j = 0; j < MixedSpace::n_pressure_modes; ++j)
            if (std::abs(R(i, j)) > zero)
              entries[child].push_back({CellUnknowns::pressure(i),
                                        CellUnknowns::pressure(j),
                                        R(i, j)});
      }
  }



  void
  Embedding::embed(const unsigned int c,
                   const double      *parent,
                   double            *child) const
  {
    std::fill(child, child + n_per_cell, 0.);
    for (const Entry &P : entries[c])
      child[P.row] += P.weight * parent[P.column];
  }



  void
  Embedding::add_transposed(const unsigned int c,
                            const double      *child,
                            double            *parent) const
  {
    for (const Entry &P : entries[c])
      parent[P.column] += P.weight * child[P.row];
  }



  void
  Embedding::add_galerkin(const unsigned int         c,
                          const std::vector<double> &child,
                          std::vector<double>       &parent) const
  {
    // half = P^T child, parent += half P; the second with the transposed, so
    // that both add whole rows.
    constexpr unsigned int n = n_per_cell;
    std::vector<double> half(n * n, 0.), transposed(n * n), result(n * n, 0.);
    const auto          multiply = [&](const double *from, double *to) {
      for (const Entry &P : entries[c])
        {
          const double *const source = from + P.row * n;
          double *const       target = to + P.column * n;
          for (unsigned int k = 0; k < n; ++k)
            target[k] += P.weight * source[k];
        }
    };
    multiply(child.data(), half.data());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        transposed[j * n + i] = half[i * n + j];
    multiply(transposed.data(), result.data());
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        parent[j * n + i] += result[i * n + j];
  }
} // namespace lumbricus
