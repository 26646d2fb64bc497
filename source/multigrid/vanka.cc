// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/multigrid/vanka.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace lumbricus
{
  namespace
  {
    // Where displacements of a cell are held, or owned by another rank, fewer
    // may be left than there are pressures. So let the pressures, which are
    // those without stiffness, yield a little: A_pp -= eps sum_k A_pk^2/A_kk.
    void
    relax_pressures(dealii::LAPACKFullMatrix<double> &A)
    {
      constexpr double   eps = 1e-3;
      const unsigned int n   = A.m();
      for (unsigned int p = 0; p < n; ++p)
        {
          if (A(p, p) > 0.)
            continue;
          double sum = 0.;
          for (unsigned int k = 0; k < n; ++k)
            if (A(k, k) > 0.)
              sum += A(p, k) * A(p, k) / A(k, k);
          A(p, p) -= eps * sum;
        }
    }
  } // namespace



  void
  Vanka::reinit(const LevelMatrix                            &new_matrix,
                const std::vector<std::vector<unsigned int>> &cells_of_patches,
                const Options                                &new_options)
  {
    matrix  = &new_matrix;
    options = new_options;
    patches.assign(cells_of_patches.size(), {});
    for (unsigned int i = 0; i < patches.size(); ++i)
      {
        auto &places = patches[i].places;
        for (const unsigned int cell : cells_of_patches[i])
          {
            const auto &of_cell = matrix->unknowns_of_cell(cell);
            places.insert(places.end(), of_cell.begin(), of_cell.end());
          }
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
      }
    patch_weight.assign(matrix->n_places(), 0.);
    for (const Patch &patch : patches)
      for (const unsigned int place : patch.places)
        patch_weight[place] += 1.;
    Vector n_ranks;
    matrix->reinit_vector(n_ranks);
    touched.clear();
    for (unsigned int place = 0; place < patch_weight.size(); ++place)
      if (patch_weight[place] > 0.)
        {
          patch_weight[place] = 1. / patch_weight[place];
          touched.push_back(place);
          n_ranks.local_element(place) = 1.;
        }
    n_ranks.compress(dealii::VectorOperation::add);
    n_ranks.update_ghost_values();
    rank_weight.clear();
    for (const unsigned int place : touched)
      rank_weight.push_back(1. / n_ranks.local_element(place));
    before.resize(touched.size());
    if (!options.multiplicative)
      matrix->reinit_vector(frozen);
  }



  void
  Vanka::invert()
  {
    std::vector<int>                 position(matrix->n_places(), -1);
    dealii::LAPACKFullMatrix<double> A;
    std::string                      singular;
    for (Patch &patch : patches)
      {
        const unsigned int n = patch.places.size();
        A.reinit(n);
        for (unsigned int k = 0; k < n; ++k)
          position[patch.places[k]] = k;
        for (unsigned int k = 0; k < n; ++k)
          {
            const auto row = matrix->row(patch.places[k]);
            for (unsigned int e = 0; e < row.size; ++e)
              if (position[row.columns[e]] >= 0)
                A(k, position[row.columns[e]]) = row.values[e];
          }
        for (const unsigned int place : patch.places)
          position[place] = -1;
        if (n < CellUnknowns::n_per_cell)
          relax_pressures(A);
        try
          {
            A.invert();
          }
        catch (const dealii::ExceptionBase &)
          {
            singular = "A patch of the smoother is singular.";
            continue;
          }
        patch.inverse.resize(n * n);
        for (unsigned int r = 0; r < n; ++r)
          for (unsigned int s = 0; s < n; ++s)
            patch.inverse[r * n + s] = static_cast<float>(A(r, s));
      }
    throw_on_all_ranks<ExcNotConverged>(singular, matrix->communicator());
  }



  void
  Vanka::add_correction(const Patch &patch, const double *r, double *x) const
  {
    const unsigned int n = patch.places.size();
    for (unsigned int k = 0; k < n; ++k)
      {
        const float *const row = patch.inverse.data() + std::size_t(k) * n;
        double             sum = 0.;
#pragma omp simd reduction(+ : sum)
        for (unsigned int s = 0; s < n; ++s)
          sum += row[s] * r[s];
        const unsigned int place = patch.places[k];
        x[place] += options.damping *
                    (options.multiplicative ? 1. : patch_weight[place]) * sum;
      }
  }



  void
  Vanka::sweep(Vector       &x,
               const Vector &b,
               const bool    backward,
               const bool    x_is_zero) const
  {
    if (!x_is_zero)
      x.update_ghost_values();
    double *const entries = x.begin();
    for (unsigned int k = 0; k < touched.size(); ++k)
      before[k] = entries[touched[k]];
    if (!options.multiplicative)
      std::copy(entries, entries + matrix->n_places(), frozen.begin());

    const double *const seen =
      options.multiplicative ? entries : frozen.begin();
    const double *const rhs = b.begin();
    std::vector<double> r;
    for (unsigned int i = 0; i < patches.size(); ++i)
      {
        const Patch &patch = patches[backward ? patches.size() - 1 - i : i];
        r.resize(patch.places.size());
        for (unsigned int k = 0; k < r.size(); ++k)
          {
            const auto row = matrix->row(patch.places[k]);
            double     sum = rhs[patch.places[k]];
#pragma omp simd reduction(- : sum)
            for (unsigned int e = 0; e < row.size; ++e)
              sum -= row.values[e] * seen[row.columns[e]];
            r[k] = sum;
          }
        add_correction(patch, r.data(), entries);
      }

    for (unsigned int k = 0; k < touched.size(); ++k)
      before[k] = rank_weight[k] * (entries[touched[k]] - before[k]);
    const unsigned int n_owned = matrix->n_owned();
    // Of the ghost entries only the changes here are left to be added.
    for (unsigned int k = 0; k < touched.size(); ++k)
      if (touched[k] < n_owned)
        entries[touched[k]] += before[k] * (1. - 1. / rank_weight[k]);
    x.zero_out_ghost_values();
    for (unsigned int k = 0; k < touched.size(); ++k)
      if (touched[k] >= n_owned)
        entries[touched[k]] = before[k];
    x.compress(dealii::VectorOperation::add);
  }
} // namespace lumbricus
