// SPDX-License-Identifier: LGPL-2.1-or-later
#include "elastic_fibre_symmetry.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
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

      // By how much f x f may be off where f is that of a sample.
      double
      slack(const unsigned int    i,
            const Point<dim>     &X,
            const Tensor<1, dim> &depth) const
      {
        return fields[i]->is_sampled() ?
                 sampling_error(
                   [&](const Point<dim> &Y) { return fields[i]->direction(Y); },
                   X,
                   depth) :
                 0.;
      }

    private:
      const Tissue                   &tissue;
      std::vector<const FibreField *> fields;
      unsigned int                    n_of_law;
    };



    // Which of the families has a mirror image that is not there as often as
    // itself, or how many there are. ExcInput where fibres have no direction.
    unsigned int
    first_asymmetric(const Families       &families,
                     const unsigned int    d,
                     const Point<dim>     &X,
                     const Tensor<1, dim> &depth)
    {
      std::vector<Tensor<1, dim>> f;
      std::vector<double>         slack;
      for (unsigned int i = 0; i < families.size(); ++i)
        {
          f.push_back(families.direction(i, X));
          slack.push_back(families.slack(i, X, depth));
        }
      for (unsigned int i = 0; i < f.size(); ++i)
        {
          Tensor<1, dim> image = f[i];
          image[d]             = -image[d];
          const auto n_along   = [&](const Tensor<1, dim> &g) {
            unsigned int n = 0;
            for (unsigned int j = 0; j < f.size(); ++j)
              if (families.are_alike(i, j) &&
                  (dealii::outer_product(g, g) -
                   dealii::outer_product(f[j], f[j]))
                      .norm() <=
                    PlaneOfSymmetry::tolerance + slack[i] + slack[j])
                ++n;
            return n;
          };
          if (n_along(image) != n_along(f[i]))
            return i;
        }
      return f.size();
    }
  } // namespace



  std::string
  asymmetric_elastic_fibres(const PlaneOfSymmetry &plane,
                            const MixedSpace      &space,
                            const Anatomy         &anatomy)
  {
    std::string  message;
    const auto   look = [&](const Region          region,
                          const Point<dim>     &X,
                          const Tensor<1, dim> &depth) {
      const Tissue &tissue = anatomy.tissue(region.tissue);
      if (!message.empty() || !tissue.has_elastic_fibres())
        return;
      const Families     families(tissue);
      const unsigned int d = plane.direction;
      const unsigned int i = first_asymmetric(families, d, X, depth);
      if (i == families.size())
        return;
      const double sine = std::abs(families.direction(i, X)[d]);
      std::ostringstream out;
      out.precision(3);
      out << "The elastic fibres " << families.name(i) << " of the tissue '"
          << tissue.name() << "' (at "
          << std::asin(std::min(1., sine)) * 180. / dealii::numbers::PI
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
