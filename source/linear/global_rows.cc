// SPDX-License-Identifier: LGPL-2.1-or-later
#include "global_rows.h"

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    // What rounding may do to a symmetric matrix.
    constexpr double rounding = 1e-10;



    // The factors f with f C = B^T and f D symmetric, if there are any.
    std::optional<std::vector<double>>
    factors_of_rows(const Border &border, const MPI_Comm comm)
    {
      const unsigned int  n = border.size();
      std::vector<double> sums; // C B, C C and B B of each
      for (unsigned int k = 0; k < n; ++k)
        {
          sums.push_back(border.rows[k].product(border.columns[k]));
          sums.push_back(border.rows[k].square());
          sums.push_back(border.columns[k].square());
        }
      dealii::Utilities::MPI::sum(sums, comm, sums);

      std::vector<double> factors(n, 1.);
      for (unsigned int k = 0; k < n; ++k)
        {
          const double CB = sums[3 * k], CC = sums[3 * k + 1],
                       BB = sums[3 * k + 2];
          if (CC == 0. && BB == 0.)
            continue;
          if (!(CB * CB >= (1. - rounding) * CC * BB && CB != 0.))
            return {};
          factors[k] = CB / CC;
        }
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int l = 0; l < k; ++l)
          {
            const double one   = factors[k] * border.corner(k, l);
            const double other = factors[l] * border.corner(l, k);
            if (std::abs(one - other) >
                rounding * std::max(std::abs(one), std::abs(other)))
              return {};
          }
      return factors;
    }
  } // namespace



  std::optional<GlobalRows>
  global_rows(const Border        &border,
              const FreeNumbering &numbering,
              const bool           symmetric,
              const MPI_Comm       comm)
  {
    const unsigned int n = border.size();
    bool               unnumbered = false;
    for (const auto *vectors : {&border.rows, &border.columns})
      for (const BorderVector &vector : *vectors)
        vector.for_each([&](const unsigned int place, const double value) {
          unnumbered =
            unnumbered || (value != 0. && !numbering.is_numbered(place));
        });
    if (dealii::Utilities::MPI::logical_or(unnumbered, comm))
      return {};

    GlobalRows rows;
    rows.scale.assign(n, 1.);
    if (symmetric)
      {
        const auto factors = factors_of_rows(border, comm);
        if (!factors)
          return {};
        rows.scale = *factors;
      }

    MoreEntries       &entries = rows.entries;
    const unsigned int first   = numbering.size();
    entries.n_unknowns         = n;
    for (unsigned int k = 0; k < n; ++k)
      {
        // Of a symmetric matrix the triangle below the diagonal is enough.
        const auto &row = symmetric ? border.columns[k] : border.rows[k];
        row.for_each([&](const unsigned int place, const double value) {
          if (numbering.is_numbered(place))
            entries.own.add(first + k, numbering.number(place), value);
        });
        if (!symmetric)
          border.columns[k].for_each(
            [&](const unsigned int place, const double value) {
              if (numbering.is_numbered(place))
                entries.own.add(numbering.number(place), first + k, value);
            });
      }
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int l = 0; l < (symmetric ? k + 1 : n); ++l)
        if (k == l || border.corner(k, l) != 0.)
          entries.common.add(first + k,
                             first + l,
                             rows.scale[k] * border.corner(k, l));
    return rows;
  }
} // namespace lumbricus
