// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elastic_fibre_symmetry.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    // The elastic fibres of a tissue: those of its law, then its families, as in
    // Tissue::elastic_fibres().
    class Families
    {
    public:
      explicit Families(const Tissue &tissue)
        : tissue(tissue)
        , fields(tissue.law().fibre_fields())
        , n_of_law(fields.size())
      {
        for (unsigned int k = 0; k < tissue.fibre_families().size(); ++k)
          fields.push_back(&tissue.fibre_families()[k].fibres());
      }

      unsigned int
      size() const
      {
        return fields.size();
      }

      // Whether two of them can take each other's place.
      bool
      are_alike(const unsigned int i, const unsigned int j) const
      {
        if (i < n_of_law || j < n_of_law)
          return i == j;
        const auto &families = tissue.fibre_families();
        return families[i - n_of_law].is_as_stiff_as(families[j - n_of_law]);
      }

      std::string
      name(const unsigned int i) const
      {
        return i < n_of_law ? "of the law " + tissue.law_name() :
                              "'" + tissue.fibre_families().name(i - n_of_law) +
                                "'";
      }

      Tensor<1, dim>
      direction(const unsigned int i, const Point<dim> &X) const
      {
        return fields[i]->direction(X);
      }

      // By how much f x f may be off.
      double
      slack(const unsigned int i, const Point<dim> &X) const
      {
        return fields[i]->error(X);
      }

      // Which two of them a coupling is between.
      std::array<unsigned int, 2>
      coupled(const FibreCoupling &coupling) const
      {
        return {{n_of_law + coupling.family(0), n_of_law + coupling.family(1)}};
      }

      const Tissue &tissue;

    private:
      std::vector<const FibreField *> fields;
      unsigned int                    n_of_law;
    };



    // The families at a point of a plane, and what is along a direction there.
    class AtPoint
    {
    public:
      // ExcInput where fibres have no direction.
      AtPoint(const Families    &families,
              const unsigned int d,
              const Point<dim>  &X)
        : families(families)
        , d(d)
      {
        for (unsigned int i = 0; i < families.size(); ++i)
          {
            f.push_back(families.direction(i, X));
            slack.push_back(families.slack(i, X));
          }
      }

      // The family or the coupling that has a mirror image which is not there as
      // often as itself, as a message calls it; empty if there is none. In @p i is a
      // family of that.
      std::string
      first_asymmetric(unsigned int &i) const
      {
        for (i = 0; i < f.size(); ++i)
          if (n_along(i, image(f[i])) != n_along(i, f[i]))
            return "The elastic fibres " + families.name(i);
        const auto &couplings = families.tissue.fibre_couplings();
        for (unsigned int k = 0; k < couplings.size(); ++k)
          {
            const auto [one, other] = families.coupled(couplings[k]);
            i                       = one;
            if (n_between(couplings[k], image(f[one]), image(f[other])) !=
                n_between(couplings[k], f[one], f[other]))
              return "The fibre coupling '" + couplings.name(k) + "'";
          }
        return "";
      }

      double
      angle(const unsigned int i) const
      {
        return std::asin(std::min(1., std::abs(f[i][d]))) * 180. /
               dealii::numbers::PI;
      }

    private:
      Tensor<1, dim>
      image(Tensor<1, dim> g) const
      {
        g[d] = -g[d];
        return g;
      }

      // Whether family j is along what may be the direction of family i.
      bool
      is_along(const unsigned int    i,
               const Tensor<1, dim> &g,
               const unsigned int    j) const
      {
        return (dealii::outer_product(g, g) - dealii::outer_product(f[j], f[j]))
                 .norm() <= PlaneOfSymmetry::tolerance + slack[i] + slack[j];
      }

      unsigned int
      n_along(const unsigned int i, const Tensor<1, dim> &g) const
      {
        unsigned int n = 0;
        for (unsigned int j = 0; j < f.size(); ++j)
          if (families.are_alike(i, j) && is_along(i, g, j))
            ++n;
        return n;
      }

      // How many are as stiff as this, between families along g and h.
      unsigned int
      n_between(const FibreCoupling  &coupling,
                const Tensor<1, dim> &g,
                const Tensor<1, dim> &h) const
      {
        const auto  &couplings = families.tissue.fibre_couplings();
        const auto   own       = families.coupled(coupling);
        unsigned int n         = 0;
        for (unsigned int k = 0; k < couplings.size(); ++k)
          if (coupling.is_as_stiff_as(couplings[k]))
            {
              const auto [one, other] = families.coupled(couplings[k]);
              if ((is_along(own[0], g, one) && is_along(own[1], h, other)) ||
                  (is_along(own[0], g, other) && is_along(own[1], h, one)))
                ++n;
            }
        return n;
      }

      const Families             &families;
      const unsigned int          d;
      std::vector<Tensor<1, dim>> f;
      std::vector<double>         slack;
    };
  } // namespace



  std::string
  asymmetric_elastic_fibres(const PlaneOfSymmetry &plane,
                            const MixedSpace      &space,
                            const Anatomy         &anatomy)
  {
    std::string  message;
    const auto   look = [&](const Region region, const Point<dim> &X) {
      const Tissue &tissue = anatomy.tissue(region.tissue);
      if (!message.empty() || !tissue.has_elastic_fibres())
        return;
      const Families     families(tissue);
      const AtPoint      at_point(families, plane.direction, X);
      unsigned int       i;
      const std::string  what = at_point.first_asymmetric(i);
      if (what.empty())
        return;
      std::ostringstream out;
      out.precision(3);
      out << what << " of the tissue '" << tissue.name() << "' (at "
          << at_point.angle(i)
          << " degrees to it) are not symmetric to " << plane.name()
          << ": at its point " << point_text(X)
          << " they have to be at 0 or 90 degrees to it, or crossed by equally "
             "stiff ones. "
          << anatomy.geometry().way_without_symmetry()
          << PlaneOfSymmetry::way_without_check();
      message = out.str();
    };
    for_each_point_of(plane, space, look);
    return message;
  }
} // namespace lumbricus
