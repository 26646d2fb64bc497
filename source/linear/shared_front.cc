// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/shared_front.h>

#include <deal.II/lac/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace lumbricus
{
  SharedFront::SharedFront(
    const unsigned int                               node,
    const std::array<std::vector<SharedUnknown>, 2> &children)
  {
    std::map<unsigned int, unsigned int> nodes; // of all, by number
    for (const auto &child : children)
      for (const SharedUnknown &unknown : child)
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
    for (unsigned int i = 0; i < 2; ++i)
      for (const SharedUnknown &unknown : children[i])
        places[i].push_back(place_of[unknown.number]);
    of_eliminated.reinit(eliminated_numbers.size());
    of_left.reinit(left_unknowns.size());
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
  SharedFront::factor(const std::array<std::vector<float>, 2> &children,
                      std::vector<float>                      &left_matrix)
  {
    const unsigned int n_e = eliminated_numbers.size();
    const unsigned int n_l = left_unknowns.size();
    factors.reinit(n_e, n_e);
    lower.reinit(n_l, n_e);
    upper.reinit(n_e, n_l);
    left_matrix.assign(std::size_t(n_l) * n_l, 0.);
    for (unsigned int i = 0; i < 2; ++i)
      {
        const float *entry = children[i].data();
        for (const unsigned int r : places[i])
          for (const unsigned int s : places[i])
            {
              const float value = *entry++;
              if (r < n_e && s < n_e)
                factors(r, s) += value;
              else if (r < n_e)
                upper(r, s - n_e) -= value;
              else if (s < n_e)
                lower(r - n_e, s) -= value;
              else
                left_matrix[std::size_t(r - n_e) * n_l + s - n_e] += value;
            }
      }
    if (n_e == 0)
      return true;
    try
      {
        factors.compute_lu_factorization();
      }
    catch (const dealii::LACExceptions::ExcSingular &)
      {
        return false;
      }
    if (n_l > 0)
      {
        factors.solve(upper);
        dealii::LAPACKFullMatrix<float> change(n_l, n_l);
        lower.mmult(change, upper);
        for (unsigned int r = 0; r < n_l; ++r)
          for (unsigned int s = 0; s < n_l; ++s)
            left_matrix[std::size_t(r) * n_l + s] -= change(r, s);
      }
    return true;
  }



  void
  SharedFront::sum(const std::array<std::vector<float>, 2> &children,
                   std::vector<float>                      &all) const
  {
    all.assign(size(), 0.);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int k = 0; k < places[i].size(); ++k)
        all[places[i][k]] += children[i][k];
  }



  void
  SharedFront::reduce(std::vector<float> &all)
  {
    const unsigned int n_e = eliminated_numbers.size();
    if (n_e == 0)
      return;
    std::copy_n(all.begin(), n_e, of_eliminated.begin());
    factors.solve(of_eliminated);
    std::copy(of_eliminated.begin(), of_eliminated.end(), all.begin());
    if (of_left.size() > 0)
      {
        lower.vmult(of_left, of_eliminated);
        for (unsigned int k = 0; k < of_left.size(); ++k)
          all[n_e + k] += of_left[k];
      }
  }



  void
  SharedFront::expand(std::vector<float> &all)
  {
    const unsigned int n_e = eliminated_numbers.size();
    if (n_e == 0 || of_left.size() == 0)
      return;
    std::copy(all.begin() + n_e, all.end(), of_left.begin());
    upper.vmult(of_eliminated, of_left);
    for (unsigned int k = 0; k < n_e; ++k)
      all[k] += of_eliminated[k];
  }



  void
  SharedFront::extract(const unsigned int        i,
                       const std::vector<float> &all,
                       std::vector<float>       &of_child) const
  {
    of_child.clear();
    for (const unsigned int place : places[i])
      of_child.push_back(all[place]);
  }
} // namespace lumbricus
