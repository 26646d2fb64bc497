// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/materials/isochoric_law.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace lumbricus
{
  using dealii::SymmetricTensor;

  /**
   * Ogden's law (Proc. R. Soc. A 326, 565, 1972), of the principal stretches
   * l_a with x_a = l_a^2 and directions n_a:
   *
   *   W      = sum_p mu_p/alpha_p (l_1^alpha_p + l_2^alpha_p + l_3^alpha_p - 3),
   *   taubar = sum_a x_a s(x_a) n_a n_a,   s(x) = sum_p mu_p x^(alpha_p/2 - 1),
   *   cbar   = sum_ab x_a x_b D_ab (n_a n_b) x (n_a n_b + n_b n_a),
   *   D_ab   = (s(x_b) - s(x_a)) / (x_b - x_a), or s'(x_a) where they are equal,
   *   mu     = 1/2 sum_p mu_p alpha_p.
   *
   * D_ab is free of cancellation: for one term with the exponent m and
   * x_b = x_a (1 + d) it is mu_p x_a^(m - 1) expm1(m log1p(d)) / d.
   */
  class Ogden : public IsochoricLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      const dealii::Patterns::List numbers(
        dealii::Patterns::Double(-1e100, 1e100), 1, 20);
      prm.add_parameter("Moduli",
                        moduli,
                        "[N/mm^2] mu_1, mu_2, ... The shear modulus is half of "
                        "the sum of mu_p alpha_p.",
                        numbers);
      prm.add_parameter("Exponents",
                        exponents,
                        "[-] alpha_1, alpha_2, ..., each of the sign of its "
                        "modulus.",
                        numbers);
      IsochoricLaw::declare_parameters(prm);
    }

    void
    check_parameters() const override
    {
      AssertThrow(exponents.size() == moduli.size(),
                  ExcParameter("Exponents",
                               "has " + std::to_string(exponents.size()) +
                                 " numbers, but 'Moduli' has " +
                                 std::to_string(moduli.size()) +
                                 ": each term needs both."));
      for (std::size_t p = 0; p < moduli.size(); ++p)
        AssertThrow(moduli[p] * exponents[p] > 0.,
                    ExcParameter("Exponents",
                                 "has in term " + std::to_string(p + 1) +
                                   " a number that is zero or not of the sign "
                                   "of the number in 'Moduli': such a term "
                                   "has no stiffness of its own."));
    }

    double
    shear_modulus() const override
    {
      double sum = 0.;
      for (std::size_t p = 0; p < moduli.size(); ++p)
        sum += 0.5 * moduli[p] * exponents[p];
      return sum;
    }

    void
    scale_stiffness(const double factor) override
    {
      for (double &modulus : moduli)
        modulus *= factor;
    }

  protected:
    double
    isochoric_energy(const SymmetricTensor<2, dim> &bbar) const override
    {
      double energy = 0.;
      for (const double x : dealii::eigenvalues(bbar))
        for (std::size_t p = 0; p < moduli.size(); ++p)
          energy += moduli[p] / exponents[p] *
                    std::expm1(0.5 * exponents[p] * std::log(x));
      return energy;
    }

    SymmetricTensor<2, dim>
    stress(const SymmetricTensor<2, dim> &bbar) const override
    {
      SymmetricTensor<2, dim> taubar;
      for (const auto &principal : dealii::eigenvectors(bbar))
        {
          double beta = 0.;
          for (std::size_t p = 0; p < moduli.size(); ++p)
            beta += moduli[p] * std::pow(principal.first, 0.5 * exponents[p]);
          taubar += beta * dealii::symmetrize(dealii::outer_product(
                             principal.second, principal.second));
        }
      return taubar;
    }

    SymmetricTensor<4, dim>
    tangent(const SymmetricTensor<2, dim> &bbar) const override
    {
      const auto              principal = dealii::eigenvectors(bbar);
      SymmetricTensor<4, dim> c;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = a; b < dim; ++b)
          {
            const double x = principal[a].first;
            const double y = principal[b].first;
            // n_a n_b + n_b n_a; a and b in the other order give the same.
            const auto N = dealii::symmetrize(dealii::outer_product(
              principal[a].second, principal[b].second));
            c += (a == b ? 2. : 4.) * x * y * divided_difference(x, y) *
                 dealii::outer_product(N, N);
          }
      return c;
    }

  private:
    // D_ab.
    double
    divided_difference(const double x, const double y) const
    {
      const double d   = (y - x) / x;
      double       sum = 0.;
      for (std::size_t p = 0; p < moduli.size(); ++p)
        {
          const double m = 0.5 * exponents[p] - 1.;
          sum += moduli[p] * std::pow(x, m - 1.) *
                 (d == 0. ? m : std::expm1(m * std::log1p(d)) / d);
        }
      return sum;
    }

    std::vector<double> moduli    = {0.23};
    std::vector<double> exponents = {2.};
  };

  static const Register<MaterialLaw, Ogden>
    ogden("Ogden",
          "W = sum of mu_p/alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3), "
          "with the principal stretches l1, l2, l3, for rubber.");
} // namespace lumbricus
