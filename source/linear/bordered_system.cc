// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/bordered_system.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    // The part of C x that the owned entries make.
    std::vector<double>
    owned_products(const std::vector<BorderVector> &rows, const Vector &x)
    {
      std::vector<double> sums;
      for (const BorderVector &row : rows)
        sums.push_back(row.product(x));
      return sums;
    }



    // C x, for all ranks.
    std::vector<double>
    products(const std::vector<BorderVector> &rows, const Vector &x)
    {
      std::vector<double> sums = owned_products(rows, x);
      dealii::Utilities::MPI::sum(sums, x.get_mpi_communicator(), sums);
      return sums;
    }



    // The first rank owns them.
    void
    set_globals(BorderedVector &x, const std::vector<double> &g)
    {
      Vector &owned = x.block(1);
      for (unsigned int k = 0; k < owned.locally_owned_size(); ++k)
        owned.local_element(k) = g[k];
    }



    void
    check_regular(const bool is_regular)
    {
      AssertThrow(is_regular,
                  ExcNotConverged(
                    "The linear system does not determine its global unknowns, "
                    "or is singular without them"));
    }
  } // namespace



  BorderedVector
  bordered_vector(const Vector &b, const std::vector<double> &c)
  {
    const MPI_Comm   comm = b.get_mpi_communicator();
    const auto       n    = c.size();
    dealii::IndexSet owned(n);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      owned.add_range(0, n);
    BorderedVector x(2);
    x.block(0) = b;
    x.block(1).reinit(owned, comm);
    x.collect_sizes();
    set_globals(x, c);
    return x;
  }



  std::vector<double>
  globals_of(const BorderedVector &x)
  {
    const Vector       &owned = x.block(1);
    std::vector<double> g(owned.begin(), owned.end());
    g.resize(owned.size());
    MPI_Bcast(
      g.data(), g.size(), MPI_DOUBLE, 0, owned.get_mpi_communicator());
    return g;
  }



  BorderedTangent::BorderedTangent(const Tangent &tangent, const Border &border)
    : tangent(tangent)
    , border(border)
  {}



  void
  BorderedTangent::vmult(BorderedVector &y, const BorderedVector &x) const
  {
    const std::vector<double> g = globals_of(x);
    tangent.vmult(y.block(0), x.block(0));
    std::vector<double> s = products(border.rows, x.block(0));
    for (unsigned int k = 0; k < g.size(); ++k)
      {
        border.columns[k].add_to(y.block(0), g[k]);
        for (unsigned int l = 0; l < g.size(); ++l)
          s[k] += border.corner(k, l) * g[l];
      }
    set_globals(y, s);
  }



  bool
  BorderedTangent::is_solved(const BorderedVector &x,
                             const BorderedVector &b,
                             const double          tolerance) const
  {
    constexpr double about = 100.;
    BorderedVector   r(b);
    vmult(r, x);
    r.sadd(-1., 1., b);

    // The loads may be small, and what they are balanced by large.
    const std::vector<double> g = globals_of(x);
    std::vector<double>       squares;
    for (const BorderVector &column : border.columns)
      squares.push_back(column.square());
    dealii::Utilities::MPI::sum(squares,
                                b.block(0).get_mpi_communicator(),
                                squares);
    double level = b.l2_norm();
    for (unsigned int k = 0; k < g.size(); ++k)
      level = std::max(level, std::abs(g[k]) * std::sqrt(squares[k]));
    return r.l2_norm() <= about * tolerance * level;
  }



  BorderedInverse::BorderedInverse(const ApproximateInverse &inverse,
                                   const Border             &border,
                                   const Vector             &like)
    : inverse(inverse)
    , Z(border.size())
    , rows(border.rows)
    , row_scale(border.size())
    , S(border.size())
  {
    const unsigned int  n = border.size();
    std::vector<double> CZ; // by columns
    Vector              column(like);
    for (unsigned int l = 0; l < n; ++l)
      {
        Z[l].reinit(like);
        border.columns[l].copy_to(column);
        inverse.vmult(Z[l], column);
        const std::vector<double> of_rows = owned_products(rows, Z[l]);
        CZ.insert(CZ.end(), of_rows.begin(), of_rows.end());
      }
    dealii::Utilities::MPI::sum(CZ, like.get_mpi_communicator(), CZ);
    dealii::FullMatrix<double> sum(border.corner);
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int k = 0; k < n; ++k)
        sum(k, l) -= CZ[l * n + k];

    // Rows are in different units.
    for (unsigned int k = 0; k < n; ++k)
      {
        double largest = 0.;
        for (unsigned int l = 0; l < n; ++l)
          largest = std::max(largest, std::abs(sum(k, l)));
        row_scale[k] = 1. / largest;
        check_regular(std::isfinite(row_scale[k]));
        for (unsigned int l = 0; l < n; ++l)
          S(k, l) = row_scale[k] * sum(k, l);
      }
    try
      {
        S.compute_lu_factorization();
      }
    catch (const dealii::LACExceptions::ExcSingular &)
      {
        check_regular(false);
      }
  }



  std::vector<double>
  BorderedInverse::solve_globals(const std::vector<double> &c) const
  {
    dealii::Vector<double> x(c.size());
    for (unsigned int k = 0; k < c.size(); ++k)
      x[k] = row_scale[k] * c[k];
    S.solve(x);
    return {x.begin(), x.end()};
  }



  void
  BorderedInverse::vmult(BorderedVector &x, const BorderedVector &r) const
  {
    inverse.vmult(x.block(0), r.block(0));
    std::vector<double>       c  = globals_of(r);
    const std::vector<double> Cy = products(rows, x.block(0));
    for (unsigned int k = 0; k < c.size(); ++k)
      c[k] -= Cy[k];
    const std::vector<double> g = solve_globals(c);
    for (unsigned int k = 0; k < g.size(); ++k)
      x.block(0).add(-g[k], Z[k]);
    set_globals(x, g);
  }
} // namespace lumbricus
