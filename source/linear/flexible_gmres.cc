// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/state.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/flexible_gmres.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector_memory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // More of a vector than this does not stay in the cache beside others.
    constexpr std::size_t piece = 1024;

    // A basis is orthogonal to this.
    constexpr double most_defect = 1e-4;

    // The entries that a rank owns, which follow each other.
    struct Owned
    {
      double     *begin;
      std::size_t size;
    };

    std::array<Owned, 1>
    owned(Vector &x)
    {
      return {{{x.begin(), x.locally_owned_size()}}};
    }

    std::array<Owned, 2>
    owned(BorderedVector &x)
    {
      return {{owned(x.block(0))[0], owned(x.block(1))[0]}};
    }



    MPI_Comm
    communicator(const Vector &x)
    {
      return x.get_mpi_communicator();
    }

    MPI_Comm
    communicator(const BorderedVector &x)
    {
      return x.block(0).get_mpi_communicator();
    }



    // With several sums the compiler uses all of a vector unit.
    double
    product(const double *a, const double *b, const std::size_t n)
    {
      constexpr std::size_t  width = 16;
      std::array<double, width> sums{};
      std::size_t               i = 0;
      for (; i + width <= n; i += width)
        for (std::size_t k = 0; k < width; ++k)
          sums[k] += a[i + k] * b[i + k];
      double sum = 0.;
      for (const double of_one : sums)
        sum += of_one;
      for (; i < n; ++i)
        sum += a[i] * b[i];
      return sum;
    }



    template <typename VectorType>
    using Basis =
      std::vector<typename dealii::VectorMemory<VectorType>::Pointer>;

    // Call a function with every piece: the owned entries of all vectors of the
    // basis, of w, and their number.
    template <typename VectorType, typename Function>
    void
    for_pieces(Basis<VectorType>  &basis,
               const unsigned int  n,
               VectorType         &w,
               const Function     &function)
    {
      std::vector<const double *> v(n);
      const auto                  of_w = owned(w);
      for (std::size_t p = 0; p < of_w.size(); ++p)
        for (std::size_t first = 0; first < of_w[p].size; first += piece)
          {
            for (unsigned int i = 0; i < n; ++i)
              v[i] = owned(*basis[i])[p].begin + first;
            function(v,
                     of_w[p].begin + first,
                     std::min(piece, of_w[p].size - first));
          }
    }



    // w' = factor (w - sum h_i v_i), and, if asked, v_i . w' and w' . w' for all
    // ranks: entries of the basis are read once.
    template <typename VectorType>
    void
    subtract(Basis<VectorType>         &basis,
             const std::vector<double> &h,
             const double               factor,
             VectorType                &w,
             std::vector<double>       *products = nullptr)
    {
      const unsigned int n = h.size();
      for_pieces(basis,
                 n,
                 w,
                 [&](const auto &v, double *const of_w, const std::size_t size) {
                   for (unsigned int i = 0; i < n; ++i)
                     for (std::size_t k = 0; k < size; ++k)
                       of_w[k] -= h[i] * v[i][k];
                   if (factor != 1.)
                     for (std::size_t k = 0; k < size; ++k)
                       of_w[k] *= factor;
                   if (products != nullptr)
                     {
                       for (unsigned int i = 0; i < n; ++i)
                         (*products)[i] += product(v[i], of_w, size);
                       (*products)[n] += product(of_w, of_w, size);
                     }
                 });
    }



    template <typename VectorType>
    std::vector<double>
    subtract_and_multiply(Basis<VectorType>         &basis,
                          const std::vector<double> &h,
                          VectorType                &w)
    {
      std::vector<double> products(h.size() + 1, 0.);
      subtract(basis, h, 1., w, &products);
      dealii::Utilities::MPI::sum(products, communicator(w), products);
      return products;
    }



    // v_i . w of the first n vectors, and w . w.
    template <typename VectorType>
    std::vector<double>
    multiply(Basis<VectorType> &basis, const unsigned int n, VectorType &w)
    {
      std::vector<double> products(n + 1, 0.);
      for_pieces(basis,
                 n,
                 w,
                 [&](const auto &v, double *const of_w, const std::size_t size) {
                   for (unsigned int i = 0; i < n; ++i)
                     products[i] += product(v[i], of_w, size);
                   products[n] += product(of_w, of_w, size);
                 });
      dealii::Utilities::MPI::sum(products, communicator(w), products);
      return products;
    }



    // Split off the last entry, the square of a norm, and take from it what the
    // others are.
    double
    take_norm(std::vector<double> &products)
    {
      double square = products.back();
      products.pop_back();
      for (const double h : products)
        square -= h * h;
      return square > 0. ? std::sqrt(square) : 0.;
    }



    // A least-squares problem |beta e_1 - H y| that gets columns one after the
    // other, by rotations.
    class LeastSquares
    {
    public:
      explicit LeastSquares(const double beta)
        : right({beta})
      {}

      // @return whether y is determined.
      bool
      add(std::vector<double> column)
      {
        const unsigned int n = rotations.size();
        for (unsigned int i = 0; i < n; ++i)
          rotate(rotations[i], column[i], column[i + 1]);
        const double r = std::hypot(column[n], column[n + 1]);
        if (!(r > 0.))
          return false;
        rotations.push_back({{column[n] / r, column[n + 1] / r}});
        rotate(rotations[n], column[n], column[n + 1]);
        right.push_back(0.);
        rotate(rotations[n], right[n], right[n + 1]);
        columns.push_back(std::move(column));
        return true;
      }

      double
      residual() const
      {
        return std::abs(right.back());
      }

      std::vector<double>
      solution() const
      {
        std::vector<double> y(right.begin(), right.end() - 1);
        for (unsigned int i = y.size(); i-- > 0;)
          {
            y[i] /= columns[i][i];
            for (unsigned int k = 0; k < i; ++k)
              y[k] -= columns[i][k] * y[i];
          }
        return y;
      }

    private:
      using Rotation = std::array<double, 2>; // cosine and sine

      static void
      rotate(const Rotation &rotation, double &a, double &b)
      {
        const double rotated = rotation[0] * a + rotation[1] * b;
        b                    = rotation[0] * b - rotation[1] * a;
        a                    = rotated;
      }

      std::vector<double>              right;
      std::vector<Rotation>            rotations;
      std::vector<std::vector<double>> columns;
    };
  } // namespace



  template <typename VectorType>
  bool
  FlexibleGmres<VectorType>::solve(const Operator   &A,
                                   const Operator   &preconditioner,
                                   VectorType       &x,
                                   const VectorType &b,
                                   const double      tolerance)
  {
    dealii::GrowingVectorMemory<VectorType> memory;
    Basis<VectorType>                       V, Z;
    const auto add_to = [&](Basis<VectorType> &basis) -> VectorType & {
      basis.emplace_back(memory);
      basis.back()->reinit(b, true);
      return *basis.back();
    };
    const auto   sum_of = [](const std::vector<double> &h) {
      double sum = 0.;
      for (const double value : h)
        sum += std::abs(value);
      return sum;
    };

    n                 = 0;
    n_twice           = 0;
    const double beta = b.l2_norm();
    const double goal = tolerance * beta;
    LeastSquares least_squares(beta);
    double       defect = std::numeric_limits<double>::epsilon();
    bool         solved = beta <= goal;
    if (std::isfinite(beta) && !solved)
      add_to(V).equ(1. / beta, b);
    while (!V.empty() && !solved && n < most_iterations)
      {
        VectorType &z = add_to(Z);
        preconditioner(z, *V[n]);
        VectorType &w = add_to(V);
        A(w, z);
        ++n;

        // After w - V h rounding and what the basis lacks of being orthogonal
        // leave this in what is left, and its square is wrong by this times w.
        auto         h    = multiply(V, n, w);
        const double size = std::sqrt(h.back());
        double       norm = take_norm(h);
        const double left = (std::numeric_limits<double>::epsilon() * size +
                             defect * sum_of(h)) *
                            size;
        auto of_basis = h;
        if (left > most_defect * norm * norm)
          {
            ++n_twice;
            auto again = subtract_and_multiply(V, h, w);
            norm       = take_norm(again);
            for (unsigned int i = 0; i < n; ++i)
              h[i] += again[i];
            of_basis = std::move(again);
          }
        else
          defect = std::max(defect, left / (norm * norm));
        // Nothing is left of what is rounding.
        if (norm <= std::numeric_limits<double>::epsilon() * size)
          norm = 0.;
        subtract(V, of_basis, norm > 0. ? 1. / norm : 0., w);

        h.push_back(norm);
        if (!least_squares.add(std::move(h)))
          break;
        solved = least_squares.residual() <= goal;
        if (norm == 0.)
          break;
      }

    x                        = 0.;
    const std::vector<double> y = least_squares.solution();
    std::vector<double>       minus;
    for (const double value : y)
      minus.push_back(-value);
    subtract(Z, minus, 1., x);
    return solved;
  }



  template class FlexibleGmres<Vector>;
  template class FlexibleGmres<BorderedVector>;
} // namespace lumbricus
