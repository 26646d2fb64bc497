// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/errors/family_functions.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int none   = dealii::numbers::invalid_unsigned_int;
    constexpr unsigned int n_cell = CellUnknowns::n_per_cell;

    // Functions that are not zero on a child, and the same padded to whole vector
    // registers.
    constexpr unsigned int n_of_child =
      FamilyFunctions::n_displacements / 2 + FamilyFunctions::n_pressures;
    constexpr unsigned int n_padded = 88;
    static_assert(n_padded >= n_of_child && n_padded >= n_cell);

    // The quadratic that is 1 at i/2 and 0 at the two others of 0, 1/2, 1.
    double
    quadratic(const unsigned int i, const double xi)
    {
      return i == 0 ? 2. * (xi - 0.5) * (xi - 1.) :
             i == 1 ? -4. * xi * (xi - 1.) :
                      2. * xi * (xi - 0.5);
    }



    // Whether a child is the second one in a direction.
    unsigned int
    half(const unsigned int child, const unsigned int d)
    {
      return child >> d & 1;
    }
  } // namespace



  FamilyFunctions::FamilyFunctions()
  {
    embed_displacements();
    embed_pressures();
    for (const Child &child : children)
      {
        (void)child;
        AssertDimension(child.functions.size(), n_of_child);
      }
  }



  void
  FamilyFunctions::add(Child             &child,
                       const unsigned int row,
                       const unsigned int function,
                       const double       weight)
  {
    auto      &functions = child.functions;
    const auto found = std::find(functions.begin(), functions.end(), function);
    child.entries.push_back(
      {row,
       static_cast<unsigned int>(found - functions.begin()),
       weight});
    if (found == functions.end())
      functions.push_back(function);
  }



  void
  FamilyFunctions::embed_displacements()
  {
    const auto order =
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(
        MixedSpace::degree);
    all_nodes.fill({none, none});
    for (unsigned int child = 0; child < n_children; ++child)
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        {
          // Where the node is in the large cell, in quarters.
          std::array<unsigned int, dim> x;
          unsigned int                  rest = order[n], n_between = 0;
          for (unsigned int d = 0; d < dim; ++d)
            {
              x[d] = rest % 3 + 2 * half(child, d);
              n_between += x[d] % 2;
              rest /= 3;
            }
          if (x[0] % 2 + x[1] % 2 + x[2] % 2 == 0)
            for (unsigned int c = 0; c < dim; ++c)
              children[child].of_large_cell[CellUnknowns::displacement(c, n)] =
                true;
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int line = 0; line < n_lines && x[d] % 2 == 1; ++line)
              {
                const double weight =
                  quadratic(line % 3, 0.25 * x[(d + 1) % dim]) *
                  quadratic(line / 3, 0.25 * x[(d + 2) % dim]);
                if (weight == 0.)
                  continue;
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    const unsigned int row = CellUnknowns::displacement(c, n);
                    const unsigned int function =
                      dim * ((d * n_lines + line) * 2 + x[d] / 2) + c;
                    add(children[child], row, function, weight);
                    if (n_between == 1 && all_nodes[function].first == none)
                      all_nodes[function] = {child, row};
                  }
              }
        }
  }



  void
  FamilyFunctions::embed_pressures()
  {
    // x_d x_e without its mean and slopes on the large cell, with x from its
    // middle; the modes of a child are 1 and sqrt(3) (2 xi - 1).
    const double of_slope = 1. / (4. * std::sqrt(3.));
    for (unsigned int child = 0; child < n_children; ++child)
      {
        const auto x = [child](const unsigned int d) {
          return half(child, d) == 1 ? 0.25 : -0.25;
        };
        unsigned int function = n_displacements;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = d; e < dim; ++e, ++function)
            {
              Child &of = children[child];
              add(of,
                  CellUnknowns::pressure(0),
                  function,
                  x(d) * x(e) + (d == e ? 1. / 48. - 1. / 12. : 0.));
              add(of, CellUnknowns::pressure(1 + d), function, of_slope * x(e));
              add(of, CellUnknowns::pressure(1 + e), function, of_slope * x(d));
            }
      }
  }



  void
  FamilyFunctions::add_matrix(const unsigned int          child,
                              const std::vector<double>  &K,
                              dealii::FullMatrix<double> &sum) const
  {
    // (E^T K)^T, and then E^T of that, both by whole rows: E^T K^T E.
    const Child &of = children[child];
    alignas(64) static thread_local double rows[n_of_child][n_padded];
    alignas(64) static thread_local double turned[n_cell][n_padded];
    const auto add_rows = [&of](const double *const from,
                                const unsigned int  stride,
                                const unsigned int  width) {
      std::fill_n(&rows[0][0], n_of_child * n_padded, 0.);
      for (const Entry &entry : of.entries)
        {
          const double *const source = from + entry.row * stride;
          double *const       target = rows[entry.column];
          for (unsigned int s = 0; s < width; ++s)
            target[s] += entry.weight * source[s];
        }
    };
    add_rows(K.data(), n_cell, n_cell);
    for (unsigned int r = 0; r < n_of_child; ++r)
      for (unsigned int s = 0; s < n_cell; ++s)
        turned[s][r] = rows[r][s];
    add_rows(&turned[0][0], n_padded, n_of_child);
    for (unsigned int s = 0; s < n_of_child; ++s)
      {
        const unsigned int column = of.functions[s];
        for (unsigned int r = 0; r < n_of_child; ++r)
          sum(of.functions[r], column) += rows[s][r];
      }
  }



  void
  FamilyFunctions::add_transposed(const unsigned int child,
                                  const double      *r,
                                  double            *f) const
  {
    const Child &of              = children[child];
    double       sums[n_of_child] = {};
    for (const Entry &entry : of.entries)
      sums[entry.column] += entry.weight * r[entry.row];
    for (unsigned int s = 0; s < n_of_child; ++s)
      f[of.functions[s]] += sums[s];
  }



  void
  FamilyFunctions::evaluate(const unsigned int child,
                            const double      *f,
                            double            *x) const
  {
    const Child &of = children[child];
    double       values[n_of_child];
    for (unsigned int s = 0; s < n_of_child; ++s)
      values[s] = f[of.functions[s]];
    std::fill_n(x, n_cell, 0.);
    for (const Entry &entry : of.entries)
      x[entry.row] += entry.weight * values[entry.column];
  }



  FamilyFunctions::Elimination
  FamilyFunctions::eliminate_pressures(dealii::FullMatrix<double> &matrix)
  {
    const unsigned int         n_all = matrix.m();
    Elimination                result;
    dealii::FullMatrix<double> B(n_pressures, n_all);
    result.of_pressures.reinit(n_pressures, n_pressures);
    result.of_displacements.reinit(n_pressures, n_all);
    for (unsigned int k = 0; k < n_pressures; ++k)
      {
        const double *const row = &matrix(n_displacements + k, 0);
        std::copy_n(row, n_all, &B(k, 0));
        std::copy_n(row + n_displacements, n_pressures, &result.of_pressures(k, 0));
      }
    result.of_pressures.gauss_jordan();
    result.of_pressures.mmult(result.of_displacements, B);
    for (unsigned int r = 0; r < n_all; ++r)
      {
        if (r >= n_displacements && r < n)
          continue;
        double *const row = &matrix(r, 0);
        for (unsigned int k = 0; k < n_pressures; ++k)
          {
            const double        factor = row[n_displacements + k];
            const double *const of_k   = &result.of_displacements(k, 0);
            for (unsigned int s = 0; s < n_all; ++s)
              row[s] -= factor * of_k[s];
          }
      }
    return result;
  }
} // namespace lumbricus
