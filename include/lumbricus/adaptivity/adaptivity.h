// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_adaptivity_h
#define lumbricus_adaptivity_adaptivity_h

#include <lumbricus/adaptivity/error_estimator.h>
#include <lumbricus/adaptivity/marking_rule.h>
#include <lumbricus/adaptivity/mesh_refinement.h>
#include <lumbricus/adaptivity/refinement_levels.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** When the mesh is adapted, and which cells are refined and coarsened. */
  class Adaptivity : public ParameterOwner
  {
  public:
    Adaptivity();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** See RefinementLevels::initialize(). */
    void
    initialize(const Anatomy &anatomy, const unsigned int least_level);

    /** Whether the mesh is ever adapted. */
    bool
    adapts() const
    {
      return every > 0;
    }

    /** Whether the mesh is to be adapted after step @p number. */
    bool
    due(const unsigned int number) const;

    /** How often, one after the other, at the same load. */
    unsigned int
    n_cycles() const;

    /** What the errors are estimated by. */
    const ErrorEstimator &
    estimator() const;

    /**
     * Set the flags on the locally owned cells. Cells of the same error, up to
     * what is left of it by rounding, are marked alike, so that symmetric
     * bodies keep symmetric meshes and any number of ranks makes the same one.
     * Cells next to a slip interface are not merged.
     * @return whether there are any on any rank. Collective.
     */
    bool
    mark(const ErrorEstimate   &estimate,
         const std::size_t      n_unknowns,
         const IsSlipInterface &is_slip_interface,
         ParallelMesh          &triangulation) const;

  private:
    using Cell = ParallelMesh::cell_iterator;

    /** Eight cells that may be merged to one, and what they add to the error. */
    struct Family
    {
      Cell   parent;
      double contribution;
    };

    bool
    may_be_refined(const Cell &cell) const;

    bool
    may_be_merged(const Cell            &cell,
                  const IsSlipInterface &is_slip_interface) const;

    /** The families whose cells are locally owned. */
    std::vector<Family>
    families(const ErrorEstimate   &estimate,
             const IsSlipInterface &is_slip_interface,
             const ParallelMesh    &triangulation) const;

    unsigned int           every  = 0;
    unsigned int           cycles = 1;
    Choice<ErrorEstimator> estimator_choice;
    Choice<MarkingRule>    rule;
    RefinementLevels       levels;
  };
} // namespace lumbricus

#endif
