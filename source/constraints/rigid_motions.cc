// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/constraints/rigid_motions.h>

#include <cmath>
#include <numeric>

namespace lumbricus
{
  RigidMotions::RigidMotions(const dealii::Point<dim> &X0, const double L)
    : X0(X0)
    , L(L)
  {}



  bool
  RigidMotions::hold(const dealii::Point<dim>     &X,
                     const dealii::Tensor<1, dim> &d)
  {
    return add(row(X, d));
  }



  RigidMotions::Row
  RigidMotions::row(const dealii::Point<dim>     &X,
                    const dealii::Tensor<1, dim> &f) const
  {
    const auto moment = dealii::cross_product_3d(X - X0, f) / L;
    return {{f[0], f[1], f[2], moment[0], moment[1], moment[2]}};
  }



  RigidMotions::Row
  RigidMotions::unheld(const Row &row) const
  {
    // Gram-Schmidt, twice for accuracy.
    Row rest = row;
    for (unsigned int pass = 0; pass < 2; ++pass)
      for (const Row &b : basis)
        {
          const double s =
            std::inner_product(rest.begin(), rest.end(), b.begin(), 0.);
          for (unsigned int i = 0; i < rest.size(); ++i)
            rest[i] -= s * b[i];
        }
    return rest;
  }



  bool
  RigidMotions::add(const Row &row)
  {
    Row          rest = unheld(row);
    const double norm = std::sqrt(
      std::inner_product(rest.begin(), rest.end(), rest.begin(), 0.));
    if (norm < 1e-6)
      return false;
    for (double &entry : rest)
      entry /= norm;
    basis.push_back(rest);
    return true;
  }



  void
  RigidMotions::merge(const MPI_Comm comm)
  {
    const auto all = dealii::Utilities::MPI::all_gather(comm, basis);
    basis.clear();
    for (const auto &rank_basis : all)
      for (const Row &row : rank_basis)
        add(row);
  }



  bool
  RigidMotions::all_held() const
  {
    return basis.size() == 2 * dim;
  }



  std::string
  RigidMotions::free_motions() const
  {
    std::string free;
    for (unsigned int i = 0; i < 2 * dim; ++i)
      {
        // The part of the unit motion that lies in the span of what is held.
        double held = 0.;
        for (const Row &b : basis)
          held += b[i] * b[i];
        if (held < 1. - 1e-6)
          free += std::string(free.empty() ? "" : ", ") +
                  (i < dim ? "translation along " : "rotation about ") +
                  "xyz"[i % dim];
      }
    return free;
  }
} // namespace lumbricus
