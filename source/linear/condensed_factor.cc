// SPDX-License-Identifier: LGPL-2.1-or-later
#include "condensed_factor.h"

#include <lumbricus/linear/scaled_inverse.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lumbricus
{
  CondensedFactor::CondensedFactor(const Tangent  &tangent,
                                   const Accuracy &accuracy,
                                   const MPI_Comm  comm)
    : tangent(tangent)
    , accuracy(accuracy)
    , comm(comm)
    , numbering(tangent.unknowns, false, comm)
    , inverses(tangent.unknowns.n_cells())
    , couplings(tangent.unknowns.n_cells())
  {
    tangent.unknowns.reinit_vector(reduced);
  }



  std::pair<double, double>
  CondensedFactor::shear_moduli() const
  {
    double softest = std::numeric_limits<double>::max(), stiffest = 0.;
    for (const double mu : tangent.shear_modulus)
      {
        softest  = std::min(softest, mu);
        stiffest = std::max(stiffest, mu);
      }
    return {dealii::Utilities::MPI::min(softest, comm),
            dealii::Utilities::MPI::max(stiffest, comm)};
  }



  void
  CondensedFactor::plan(const MoreEntries &more)
  {
    const bool is_new = factors == nullptr || !planned.is_like(more);
    if (!dealii::Utilities::MPI::logical_or(is_new, comm))
      return;
    factors.reset();
    const auto [softest, stiffest] = shear_moduli();
    Assert(stiffest > 0., dealii::ExcMessage("The tangent has no values yet"));
    factors                        = std::make_unique<DividedFactor>(
      comm,
      Mumps<float>::Options{tangent.symmetric,
                            accuracy.pivoting || !tangent.symmetric ||
                              stiffest > most_contrast * softest,
                            accuracy.compression},
      tangent.unknowns,
      n_private,
      numbering,
      more);
    planned = more;
  }



  void
  CondensedFactor::factor()
  {
    factor_with({});
  }



  bool
  CondensedFactor::factor_bordered(const Border &border)
  {
    const std::optional<GlobalRows> rows =
      global_rows(border, numbering, tangent.symmetric, comm);
    if (!rows)
      return false;
    row_scale = rows->scale;
    factor_with(rows->entries);
    return true;
  }



  void
  CondensedFactor::factor_with(const MoreEntries &more)
  {
    plan(more);
    const CellUnknowns        &unknowns = tangent.unknowns;
    constexpr unsigned int     n_modes  = MixedSpace::n_pressure_modes;
    std::vector<double>        K, S, row;
    dealii::FullMatrix<double> K_zz(n_private, n_private);

    const double stiffest = shear_moduli().second;
    factors->begin();
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      {
        tangent.cell_matrix(i, K);
        unknowns.apply_constraints(i, K);
        const unsigned int n        = unknowns.free_unknowns(i).size();
        const unsigned int n_shared = n - n_private;

        for (unsigned int r = 0; r < n_private; ++r)
          for (unsigned int s = 0; s < n_private; ++s)
            K_zz(r, s) = K[r * n + s];
        const auto   M = tangent.pressure_mass(i);
        const double compressibility =
          1. / (penalty * std::sqrt(stiffest * tangent.shear_modulus[i]));
        for (unsigned int r = 0; r < n_modes; ++r)
          for (unsigned int s = 0; s < n_modes; ++s)
            K_zz(CellUnknowns::pressure(r), CellUnknowns::pressure(s)) -=
              compressibility * M[r * n_modes + s];
        scaled_inverse(K_zz);
        std::copy(&K_zz(0, 0),
                  &K_zz(0, 0) + n_private * n_private,
                  inverses[i].begin());

        auto &W = couplings[i];
        S.resize(n_shared * n_shared);
        row.assign(n_private * n_shared, 0.);
        for (unsigned int r = 0; r < n_private; ++r)
          {
            double *const row_r = row.data() + r * n_shared;
            for (unsigned int s = 0; s < n_private; ++s)
              for (unsigned int k = 0; k < n_shared; ++k)
                row_r[k] += K_zz(r, s) * K[s * n + n_private + k];
          }
        W.assign(row.begin(), row.end());
        for (unsigned int r = 0; r < n_shared; ++r)
          {
            double *const S_r = S.data() + r * n_shared;
            const double *K_r = K.data() + (n_private + r) * n;
            std::copy(K_r + n_private, K_r + n, S_r);
            for (unsigned int z = 0; z < n_private; ++z)
              for (unsigned int k = 0; k < n_shared; ++k)
                S_r[k] -= K_r[z] * row[z * n_shared + k];
          }
        factors->add(n_shared, S.data());
      }
    factors->add(more);
    factors->factor();
  }



  void
  CondensedFactor::vmult(Vector &y, const Vector &x) const
  {
    std::vector<float> none;
    solve(y, x, none);
  }



  void
  CondensedFactor::vmult_bordered(BorderedVector       &y,
                                  const BorderedVector &x) const
  {
    // The first rank owns all of them.
    std::vector<float> globals;
    for (unsigned int k = 0; k < x.block(1).locally_owned_size(); ++k)
      globals.push_back(row_scale[k] * x.block(1).local_element(k));
    solve(y.block(0), x.block(0), globals);
    for (unsigned int k = 0; k < globals.size(); ++k)
      y.block(1).local_element(k) = globals[k];
  }



  void
  CondensedFactor::solve(Vector             &y,
                         const Vector       &x,
                         std::vector<float> &globals) const
  {
    const CellUnknowns &unknowns = tangent.unknowns;

    reduced = 0.;
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      {
        const auto          places   = unknowns.free_unknowns(i);
        const unsigned int  n_shared = places.size() - n_private;
        const unsigned int *shared   = places.data() + n_private;
        for (unsigned int z = 0; z < n_private; ++z)
          {
            const double r = x.local_element(places[z]);
            const float *W = couplings[i].data() + z * n_shared;
            for (unsigned int k = 0; k < n_shared; ++k)
              reduced.local_element(shared[k]) -= W[k] * r;
          }
      }
    reduced += x; // what is owned; each rank knows a part of what is shared
    factors->solve(reduced, globals);
    y = x; // in the constrained unknowns
    for (const unsigned int place : numbering.places())
      y.local_element(place) = reduced.local_element(place);
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      {
        const auto          places   = unknowns.free_unknowns(i);
        const unsigned int  n_shared = places.size() - n_private;
        const unsigned int *shared   = places.data() + n_private;
        for (unsigned int z = 0; z < n_private; ++z)
          {
            double       sum = 0.;
            const float *W   = couplings[i].data() + z * n_shared;
            for (unsigned int k = 0; k < n_shared; ++k)
              sum -= W[k] * reduced.local_element(shared[k]);
            for (unsigned int r = 0; r < n_private; ++r)
              sum +=
                inverses[i][z * n_private + r] * x.local_element(places[r]);
            y.local_element(places[z]) = sum;
          }
      }
    reduced.zero_out_ghost_values();
  }



  double
  CondensedFactor::cost() const
  {
    return factors->cost();
  }
} // namespace lumbricus
