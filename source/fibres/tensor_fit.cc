// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tensor_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    using Values = std::vector<double>;

    // Less of a squared length than this, relative to what it was, is none.
    constexpr double rounding = 1e-10;
    // Points are apart along an axis if they are so much of the most along any, squared:
    // coordinates are rounded.
    constexpr double least_spread = 1e-6;
    // The largest rest over the mean, and more.
    constexpr double safety = 3.;
    // With fewer samples curvature cannot be told from being apart.
    constexpr std::size_t fewest_for_curvature = 10;



    class Fit
    {
    public:
      Fit(const std::vector<TensorSample> &samples, const double least_part);

      FittedTensor
      at_origin();

    private:
      double
      product(const Values &a, const Values &b) const
      {
        double sum = 0.;
        for (std::size_t i = 0; i < a.size(); ++i)
          sum += samples[i].weight * a[i] * b[i];
        return sum;
      }

      // What of a function no other in the basis has.
      Values
      remainder(Values function) const;

      void
      add_to_basis(const Values &function);

      // What says how the tensor changes along axis k; empty if nothing does.
      Values
      independent_part(const unsigned int k);

      const std::vector<TensorSample>     &samples;
      const double                         least_part;
      Tensor<1, dim>                       center;
      double                               sum = 0.;
      std::array<Tensor<1, dim>, dim>      axes;
      std::array<double, dim>              spread;
      std::array<Values, dim>              coordinates;
      // Orthogonal to each other, with their squared lengths.
      std::vector<std::pair<Values, double>> basis;
    };



    Fit::Fit(const std::vector<TensorSample> &samples, const double least_part)
      : samples(samples)
      , least_part(least_part)
    {
      for (const TensorSample &sample : samples)
        {
          sum += sample.weight;
          center += sample.weight * sample.x;
        }
      center /= sum;
      SymmetricTensor<2, dim> C;
      for (const TensorSample &sample : samples)
        C += sample.weight / sum *
             dealii::symmetrize(
               dealii::outer_product(sample.x - center, sample.x - center));
      const auto found = dealii::eigenvectors(C);
      for (unsigned int k = 0; k < dim; ++k)
        {
          spread[k] = found[k].first;
          axes[k]   = found[k].second;
          for (const TensorSample &sample : samples)
            coordinates[k].push_back((sample.x - center) * axes[k]);
        }
    }



    Values
    Fit::remainder(Values function) const
    {
      for (const auto &[other, length] : basis)
        {
          const double part = product(function, other) / length;
          for (std::size_t i = 0; i < function.size(); ++i)
            function[i] -= part * other[i];
        }
      return function;
    }



    void
    Fit::add_to_basis(const Values &function)
    {
      const Values rest   = remainder(function);
      const double length = product(rest, rest);
      if (length > rounding * product(function, function))
        basis.emplace_back(rest, length);
    }



    Values
    Fit::independent_part(const unsigned int k)
    {
      if (!(spread[k] > least_spread * spread[0]))
        return {};
      Values       rest   = remainder(coordinates[k]);
      const double length = product(rest, rest);
      if (!(length > least_part * product(coordinates[k], coordinates[k])))
        rest.clear();

      // For the next.
      add_to_basis(coordinates[k]);
      if (samples.size() >= fewest_for_curvature)
        for (unsigned int j = 0; j <= k; ++j)
          {
            Values square;
            for (std::size_t i = 0; i < samples.size(); ++i)
              square.push_back(coordinates[j][i] * coordinates[k][i]);
            add_to_basis(square);
          }
      return rest;
    }



    FittedTensor
    Fit::at_origin()
    {
      add_to_basis(Values(samples.size(), 1.));
      std::array<Values, dim> parts;
      for (unsigned int k = 0; k < dim; ++k)
        parts[k] = independent_part(k);

      // From the last axis to the first, each without what the later ones explain.
      std::vector<SymmetricTensor<2, dim>> rest;
      for (const TensorSample &sample : samples)
        rest.push_back(sample.A);
      FittedTensor result;
      for (unsigned int k = dim; k-- > 0;)
        {
          if (parts[k].empty())
            continue;
          ++result.n_directions;
          SymmetricTensor<2, dim> slope;
          for (std::size_t i = 0; i < samples.size(); ++i)
            slope += samples[i].weight * parts[k][i] * rest[i];
          slope /= product(parts[k], parts[k]);
          for (std::size_t i = 0; i < samples.size(); ++i)
            rest[i] -= coordinates[k][i] * slope;
          result.A -= (center * axes[k]) * slope;
        }
      SymmetricTensor<2, dim> mean;
      for (std::size_t i = 0; i < samples.size(); ++i)
        mean += samples[i].weight / sum * rest[i];
      result.A += mean;

      double far = 0., off = 0., near = 0.;
      for (std::size_t i = 0; i < samples.size(); ++i)
        {
          const double rho2 = (samples[i].x - center).norm_square();
          far += rho2 * rho2;
          near += samples[i].weight / sum * rho2;
          off += std::pow((rest[i] - mean).norm(), 2);
        }
      const double reach = center.norm() + std::sqrt(near);
      result.error =
        far > 0. ? safety * std::sqrt(off / far) * reach * reach : 0.;
      return result;
    }
  } // namespace



  FittedTensor
  fit_tensor(const std::vector<TensorSample> &samples, const double least_part)
  {
    return Fit(samples, least_part).at_origin();
  }
} // namespace lumbricus
