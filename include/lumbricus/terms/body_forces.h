// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_body_forces_h
#define lumbricus_terms_body_forces_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_list.h>
#include <lumbricus/parameters/section.h>
#include <lumbricus/terms/named_term.h>
#include <lumbricus/terms/volume_term.h>

#include <deal.II/distributed/tria_base.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** One section of Body forces: what acts in which tissues. */
  class NamedBodyForce : public NamedTerm<VolumeTerm>
  {
  public:
    using NamedTerm::NamedTerm;

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    /**
     * Find the tissues. Throws ExcInput for one that does not exist, and for a
     * liquid: the mesh inside it does not move with its points, which a force
     * would have to know.
     */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** The names of the tissues; none for all but liquids. */
    std::vector<std::string> tissues;
    /** Whether it acts in a tissue, by number, after initialize(). */
    std::vector<bool> acts_in;
  };



  /** All body forces of a run. */
  class BodyForces : public Section<NamedList<NamedBodyForce>>
  {
  public:
    /** None. */
    BodyForces();

    /** Initialize all. Throws ExcInput. */
    void
    initialize(const Geometry &geometry);

    /**
     * Try all expressions in the middle of cells they are for, at @p times.
     * Throws ExcInput where a value is NaN or infinite. Collective.
     */
    void
    try_expressions(
      const dealii::parallel::TriangulationBase<dim> &triangulation,
      const std::vector<double>                      &times) const;

    /** All expressions over time; the same on all ranks. */
    std::vector<LoadCurve>
    load_curves(
      const dealii::parallel::TriangulationBase<dim> &triangulation) const;

    /** How many there are. */
    unsigned int
    n_forces() const;

    /** Number @p i of n_forces(), in the order of their names. */
    const NamedBodyForce &
    force(const unsigned int i) const;

    /** Whether the tangent matrix is symmetric. */
    bool
    symmetric() const;
  };
} // namespace lumbricus

#endif
