// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/regime_changes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // The regime of every point that may slide, with its condition and segment, in
    // the order of the cells.
    struct PointRegime
    {
      unsigned int        condition;
      unsigned int        segment;
      SurfaceTerm::Regime regime;
    };



    std::vector<PointRegime>
    regimes(SurfaceTerms &terms, const Vector &solution, const LoadTime &t)
    {
      std::vector<PointRegime> all;
      terms.visit_points(
        solution, t, [&](const unsigned int i, const SurfacePoint &point) {
          const SurfaceTerm &term =
            *terms.boundary_conditions().condition(i).surface_term();
          if (term.may_slide())
            all.push_back({i, point.segment, term.regime(point)});
        });
      return all;
    }
  } // namespace



  std::string
  regime_changes(const Body     &body,
                 SurfaceTerms   &terms,
                 const Vector   &before,
                 const Vector   &after,
                 const LoadTime &t)
  {
    const BoundaryConditions &conditions  = terms.boundary_conditions();
    const auto                old_regimes = regimes(terms, before, t);
    const auto                regimes_now = regimes(terms, after, t);
    const unsigned int n_segments  = body.anatomy.geometry().n_segments();
    const unsigned int n_each      = n_segments + 1;
    // Of each condition: all points, and those that change, by segment.
    std::vector<unsigned int> counts(conditions.n_conditions() * n_each, 0);
    for (unsigned int k = 0; k < regimes_now.size(); ++k)
      {
        unsigned int *of_condition = &counts[regimes_now[k].condition * n_each];
        ++of_condition[0];
        of_condition[1 + regimes_now[k].segment] +=
          regimes_now[k].regime != old_regimes[k].regime;
      }
    dealii::Utilities::MPI::sum(counts, body.space.communicator(), counts);

    std::ostringstream text;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const auto         begin = counts.begin() + i * n_each + 1;
        const auto         most  = std::max_element(begin, begin + n_segments);
        unsigned int       n     = 0;
        for (unsigned int s = 0; s < n_segments; ++s)
          n += begin[s];
        if (n > 0)
          text << "; " << n << " of " << begin[-1] << " points of '"
               << conditions.condition(i).name
               << "' change between sticking, sliding and being free from one "
                  "iteration to the next, most of them in segment "
               << most - begin + 1
               << ": raise its 'Elastic slip', or take smaller steps";
      }
    return text.str();
  }
} // namespace lumbricus
