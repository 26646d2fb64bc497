// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/surface_matrix.h>

#include <cmath>

namespace lumbricus
{
  std::vector<double> &
  SurfaceMatrix::entries()
  {
    if (all.empty())
      {
        all.assign(n * n, 0.);
        add_to(all);
        places.clear();
        packed.clear();
      }
    return all;
  }



  void
  SurfaceMatrix::vmult_add(const double *x, double *y) const
  {
    pack();
    const unsigned int n_places = places.size();
    double             x_there[n];
    for (unsigned int k = 0; k < n_places; ++k)
      x_there[k] = x[places[k]];
    const double *row = packed.data();
    for (unsigned int k = 0; k < n_places; ++k, row += n_places)
      {
        double sum = 0.;
        for (unsigned int l = 0; l < n_places; ++l)
          sum += row[l] * x_there[l];
        y[places[k]] += sum;
      }
  }



  void
  SurfaceMatrix::add_to(std::vector<double> &K) const
  {
    if (&K != &all)
      pack();
    const unsigned int n_places = places.size();
    for (unsigned int k = 0; k < n_places; ++k)
      for (unsigned int l = 0; l < n_places; ++l)
        K[places[k] * n + places[l]] += packed[k * n_places + l];
  }



  void
  SurfaceMatrix::add_diagonal_to(double *d) const
  {
    pack();
    for (unsigned int k = 0; k < places.size(); ++k)
      d[places[k]] += packed[k * (places.size() + 1)];
  }



  void
  SurfaceMatrix::pack() const
  {
    if (all.empty())
      return;
    // In the order of memory, since this is done for every linearisation.
    double of_row[n] = {}, of_column[n] = {};
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int s = 0; s < n; ++s)
        {
          const double size = std::abs(all[r * n + s]);
          of_row[r] += size;
          of_column[s] += size;
        }
    places.clear();
    for (unsigned int r = 0; r < n; ++r)
      if (of_row[r] != 0. || of_column[r] != 0.)
        places.push_back(r);
    packed.clear();
    packed.reserve(places.size() * places.size());
    for (const unsigned int r : places)
      for (const unsigned int s : places)
        packed.push_back(all[r * n + s]);
    std::vector<double>().swap(all);
  }
} // namespace lumbricus
