// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shared_front.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace lumbricus
{
  SharedFront::SharedFront(
    const unsigned int                               node,
    const std::array<std::vector<SharedUnknown>, 2> &halves)
    : own_eliminated(0, 0, 1)
    , own_left(0, 0, 1)
  {
    std::map<unsigned int, unsigned int> nodes; // of all, by number
    for (const auto &half : halves)
      for (const SharedUnknown &unknown : half)
        nodes[unknown.number] = unknown.node;
    std::map<unsigned int, unsigned int> place_of;
    for (const auto &[number, its_node] : nodes)
      if (its_node == node)
        {
          place_of[number] = eliminated_numbers.size();
          eliminated_numbers.push_back(number);
        }
    for (const auto &[number, its_node] : nodes)
      if (its_node != node)
        {
          place_of[number] = size();
          left_unknowns.push_back({number, its_node});
        }
    for (unsigned int k = 0; k < 2; ++k)
      for (const SharedUnknown &unknown : halves[k])
        places[k].push_back(place_of[unknown.number]);
    of_eliminated.reinit(eliminated_numbers.size());
    of_left.reinit(left_unknowns.size());
    share(0, 1);
  }



  void
  SharedFront::share(const unsigned int i, const unsigned int n)
  {
    own_eliminated = PartOfList(eliminated_numbers.size(), i, n);
    own_left       = PartOfList(left_unknowns.size(), i, n);
    uses_factors   = left_unknowns.empty() && n == 2;
    of_own_eliminated.reinit(own_eliminated.size());
    of_own_left.reinit(own_left.size());
  }



  double
  SharedFront::n_entries() const
  {
    const double n_e = eliminated_numbers.size(), n_l = left_unknowns.size();
    return n_e * (n_e + 2. * n_l);
  }



  double
  SharedFront::flops() const
  {
    const double n_e = eliminated_numbers.size(), n_l = left_unknowns.size();
    return 2. * n_e * (n_e * n_e / 3. + n_e * n_l + n_l * n_l);
  }



  bool
  SharedFront::factor(const std::array<std::vector<float>, 2> &halves,
                      const bool                               symmetric,
                      const RankGroup                         *group,
                      std::vector<float>                      &left_matrix)
  {
    const unsigned int              n_e = eliminated_numbers.size();
    const unsigned int              n_l = left_unknowns.size();
    dealii::LAPACKFullMatrix<float> lower(n_e, n_l); // each row a column
    dealii::LAPACKFullMatrix<float> upper(n_e, n_l);
    factors.reinit(n_e);
    left_matrix.assign(std::size_t(n_l) * n_l, 0.);
    for (unsigned int i = 0; i < 2; ++i)
      {
        const float *entry = halves[i].data();
        for (const unsigned int r : places[i])
          for (const unsigned int s : places[i])
            {
              const float value = *entry++;
              if (r < n_e && s < n_e)
                factors.entry(r, s) += value;
              else if (r < n_e)
                upper(r, s - n_e) += value;
              else if (s < n_e)
                lower(s, r - n_e) += value;
              else
                left_matrix[std::size_t(r - n_e) * n_l + s - n_e] += value;
            }
      }
    if (!factors.factor(symmetric, group))
      return false;
    if (n_e > 0 && !uses_factors)
      {
        compute_rows(lower, upper, left_matrix);
        factors.reinit(0);
      }
    return true;
  }



  void
  SharedFront::compute_rows(const dealii::LAPACKFullMatrix<float> &lower,
                            const dealii::LAPACKFullMatrix<float> &upper,
                            std::vector<float> &left_matrix)
  {
    const unsigned int n_e = eliminated_numbers.size();
    const unsigned int n_l = left_unknowns.size();
    inverse_rows.reinit(n_e, own_eliminated.size());
    for (unsigned int k = 0; k < own_eliminated.size(); ++k)
      inverse_rows(own_eliminated.first + k, k) = 1.;
    up_rows.reinit(n_e, own_left.size());
    for (unsigned int k = 0; k < own_left.size(); ++k)
      for (unsigned int r = 0; r < n_e; ++r)
        up_rows(r, k) = lower(r, own_left.first + k);
    for (dealii::LAPACKFullMatrix<float> *rows : {&inverse_rows, &up_rows})
      if (rows->n() > 0)
        factors.solve_transposed(*rows);
    down_rows.reinit(own_eliminated.size(), n_l);
    if (n_l > 0 && own_eliminated.size() > 0)
      inverse_rows.Tmmult(down_rows, upper);
    if (own_left.size() > 0)
      {
        dealii::LAPACKFullMatrix<float> change(own_left.size(), n_l);
        up_rows.Tmmult(change, upper);
        for (unsigned int r = 0; r < own_left.size(); ++r)
          for (unsigned int s = 0; s < n_l; ++s)
            left_matrix[std::size_t(own_left.first + r) * n_l + s] -=
              change(r, s);
      }
  }



  void
  SharedFront::sum(const std::array<std::vector<float>, 2> &halves,
                   std::vector<float>                      &all) const
  {
    all.assign(size(), 0.);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int k = 0; k < places[i].size(); ++k)
        all[places[i][k]] += halves[i][k];
  }



  void
  SharedFront::reduce(std::vector<float> &all)
  {
    const unsigned int n_e = eliminated_numbers.size();
    if (n_e == 0)
      return;
    std::copy_n(all.begin(), n_e, of_eliminated.begin());
    if (own_left.size() > 0)
      {
        up_rows.Tvmult(of_own_left, of_eliminated);
        for (unsigned int k = 0; k < own_left.size(); ++k)
          all[n_e + own_left.first + k] -= of_own_left[k];
      }
  }



  void
  SharedFront::solve_eliminated(std::vector<float> &all)
  {
    if (uses_factors && !eliminated_numbers.empty())
      {
        factors.solve(of_eliminated);
        std::copy(of_eliminated.begin(), of_eliminated.end(), all.begin());
      }
    else if (own_eliminated.size() > 0)
      {
        inverse_rows.Tvmult(of_own_eliminated, of_eliminated);
        std::copy(of_own_eliminated.begin(),
                  of_own_eliminated.end(),
                  all.begin() + own_eliminated.first);
      }
  }



  void
  SharedFront::expand(std::vector<float> &all)
  {
    if (own_eliminated.size() == 0 || of_left.size() == 0)
      return;
    std::copy(all.begin() + eliminated_numbers.size(), all.end(), of_left.begin());
    down_rows.vmult(of_own_eliminated, of_left);
    for (unsigned int k = 0; k < own_eliminated.size(); ++k)
      all[own_eliminated.first + k] -= of_own_eliminated[k];
  }



  void
  SharedFront::extract(const unsigned int        i,
                       const std::vector<float> &all,
                       std::vector<float>       &of_half) const
  {
    of_half.clear();
    for (const unsigned int place : places[i])
      of_half.push_back(all[place]);
  }
} // namespace lumbricus
