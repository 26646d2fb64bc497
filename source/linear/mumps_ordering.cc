// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mumps_ordering.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lumbricus
{
  std::vector<int>
  ordering_with(std::vector<int>                 positions,
                const MoreEntries               &more,
                const std::vector<unsigned int> &not_eliminated,
                const MPI_Comm                   comm)
  {
    const unsigned int n = positions.size();

    // Where the others come among them.
    std::vector<int> last(more.n_unknowns, 0);
    for (unsigned int k = 0; k < more.own.rows.size(); ++k)
      for (const auto &[global, other] :
           {std::make_pair(more.own.rows[k], more.own.columns[k]),
            std::make_pair(more.own.columns[k], more.own.rows[k])})
        if (global >= n && other < n)
          last[global - n] = std::max(last[global - n], positions[other]);
    dealii::Utilities::MPI::max(last, comm, last);
    for (const unsigned int number : not_eliminated)
      if (number >= n)
        last[number - n] = n;

    // Each goes behind the last one that it hangs together with.
    std::vector<int> shift(n + 2, 0);
    for (const int position : last)
      ++shift[position + 1];
    std::partial_sum(shift.begin(), shift.end(), shift.begin());
    for (int &position : positions)
      position += shift[position];
    for (const int position : last)
      positions.push_back(position + shift[position]++ + 1);
    return positions;
  }
} // namespace lumbricus
