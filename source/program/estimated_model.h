// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_estimated_model_h
#define lumbricus_program_estimated_model_h

#include <lumbricus/adaptivity/error_estimator.h>
#include <lumbricus/program/chain_model.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** The body of a run in equilibrium, as estimators see it. */
  class EstimatedModel : public EstimatedState
  {
  public:
    /** For @p state, where @p model has found @p solve. All are kept by
     * reference. */
    EstimatedModel(ChainModel                  &model,
                   const State                 &state,
                   const ResetIteration::Solve &solve);

    const CellFields &
    fields(const std::vector<std::string> &names) override;

    ErrorEstimate
    errors_of(const GoalNumbers &numbers) override;

  private:
    ChainModel                  &model;
    const State                 &state;
    const ResetIteration::Solve &solve;

    std::unique_ptr<CellFields> last_fields;
  };
} // namespace lumbricus

#endif
