// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_error_estimator_h
#define lumbricus_adaptivity_error_estimator_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/output/cell_fields.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Where the error of a solution is. */
  struct ErrorEstimate
  {
    /** Of each locally owned cell, in the order of iteration, what it adds to
     * the error: at least 0, of any unit, and such that it adds up over cells. */
    std::vector<double> contributions;
    /** All of the error, relative to what it is an error of. */
    double relative = 0.;
  };



  /** Numbers whose errors matter, of some segments. */
  struct GoalNumbers
  {
    bool length     = false; ///< SectionMeasures::length
    bool mid_radius = false; ///< SectionMeasures::mid_radius
    bool pressure   = false; ///< SegmentState::mean_pressure()
    /** Whose, from 0. */
    std::vector<unsigned int> segments;
  };



  /** A body in equilibrium, as estimators see it. */
  class EstimatedState
  {
  public:
    virtual ~EstimatedState() = default;

    /** Its fields of these names, until the next call. Collective. */
    virtual const CellFields &
    fields(const std::vector<std::string> &names) = 0;

    /**
     * Where the errors of numbers come from. With w_s = +-1, the sign of the
     * estimated error, over the largest value of its kind, of each number J_s of
     * @p numbers, and the derivative J' of sum_s w_s J_s, cell K adds
     *
     *   |sum_i r_i z_i|,   z = K^(-T) J',
     *
     * over the unknowns i inside of it on a mesh with eight cells in place of each,
     * where r is the residual of this state, and z is without what the cells
     * themselves can represent: Becker and Rannacher, Acta Numerica 10, 2001;
     * several numbers as one, Hartmann and Houston, J. Comput. Phys. 183, 2002.
     * Where K is not symmetric K takes the place of K^T. The relative error is the
     * largest. Throws what a load step may throw. Collective.
     */
    virtual ErrorEstimate
    errors_of(const GoalNumbers &numbers) = 0;
  };



  /** Estimates where the error of a discrete solution is. */
  class ErrorEstimator : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** Before estimate(); throws ExcInput for what does not fit @p anatomy. */
    virtual void
    initialize(const Anatomy & /*anatomy*/)
    {}

    /** Whether it asks for EstimatedState::errors_of(). */
    virtual bool
    needs_finer_cells() const
    {
      return false;
    }

    /** The error of @p state. Collective. */
    virtual ErrorEstimate
    estimate(EstimatedState &state) const = 0;
  };
} // namespace lumbricus

#endif
