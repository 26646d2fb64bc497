// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/chain_model.h>

#include <cmath>

#include "measure_control.h"

namespace lumbricus
{
  /** The length of segments is given, as SectionMeasures has it. */
  class SegmentLengthControl : public MeasureControl
  {
  public:
    SegmentLengthControl()
      : MeasureControl("length of a segment", "length")
    {}

    double
    value(const ChainModel &model, const Vector &relevant_solution) const override
    {
      const auto measures = section_measures(model.body, relevant_solution);
      double     sum      = 0.;
      for (const unsigned int s : segments())
        sum += measures[s].length;
      return sum;
    }

    Vector
    derivative(const ChainModel &model,
               const Vector     &relevant_solution) const override
    {
      const unsigned int  n = model.body.anatomy.geometry().n_segments();
      std::vector<double> of_lengths(n, 0.);
      for (const unsigned int s : segments())
        of_lengths[s] = 1.;
      return section_derivative(model.body,
                                model.assembler.tangent().unknowns,
                                of_lengths,
                                std::vector<double>(n, 0.),
                                relevant_solution);
    }

  protected:
    void
    check(const ChainModel &model) const override
    {
      const auto measures =
        section_measures(model.body,
                         model.space.with_ghosts(model.rest_state().solution));
      for (const unsigned int s : segments())
        if (!(measures[s].length > 0.))
          refuse(s,
                 "has no two plane sections whose distance would be its length");
    }
  };



  static const Register<Continuation, SegmentLengthControl>
    segment_length("length of a segment",
                   "steps at whose ends the length of segments is given: the "
                   "load parameter, and with it each activation, is what it "
                   "takes.");
} // namespace lumbricus
