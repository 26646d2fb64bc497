// SPDX-License-Identifier: LGPL-2.1-or-later
#include "estimated_model.h"

#include <algorithm>
#include <cmath>

#include "finer_model.h"

namespace lumbricus
{
  namespace
  {
    // A number of a segment, and where its error is.
    struct Number
    {
      double (*value)(const ResetIteration::Solve &, const unsigned int);
      double SegmentError::*error;
    };



    std::vector<Number>
    numbers_of(const GoalNumbers &goal)
    {
      using Solve = ResetIteration::Solve;
      std::vector<Number> numbers;
      if (goal.length)
        numbers.push_back({[](const Solve &solve, const unsigned int s) {
                             return solve.measures[s].length;
                           },
                           &SegmentError::length});
      if (goal.mid_radius)
        numbers.push_back({[](const Solve &solve, const unsigned int s) {
                             return solve.measures[s].mid_radius;
                           },
                           &SegmentError::mid_radius});
      if (goal.pressure)
        numbers.push_back({[](const Solve &solve, const unsigned int s) {
                             return solve.segments[s].mean_pressure();
                           },
                           &SegmentError::pressure});
      return numbers;
    }
  } // namespace



  EstimatedModel::EstimatedModel(ChainModel                  &model,
                                 const State                 &state,
                                 const ResetIteration::Solve &solve)
    : model(model)
    , state(state)
    , solve(solve)
  {}



  const CellFields &
  EstimatedModel::fields(const std::vector<std::string> &names)
  {
    last_fields = std::make_unique<CellFields>(
      model.body,
      model.references,
      model.liquid_weight,
      model.parameters.boundary_conditions,
      model.parameters.output_parts.field_arrays(names));
    last_fields->reinit();
    last_fields->update(state);
    return *last_fields;
  }



  ErrorEstimate
  EstimatedModel::errors_of(const GoalNumbers &numbers)
  {
    // Cells that are cut later keep the shape of this mesh.
    FinerModel finer(model, FinerModel::Shape::same);
    const auto errors = finer.errors(state, solve);

    ErrorEstimate             estimate;
    std::vector<SegmentError> factors(errors.size());
    for (const Number &number : numbers_of(numbers))
      {
        double largest = 0.;
        for (const unsigned int s : numbers.segments)
          if (std::isfinite(number.value(solve, s)))
            largest = std::max(largest, std::abs(number.value(solve, s)));
        for (const unsigned int s : numbers.segments)
          {
            const double error = errors[s].*number.error;
            if (!(largest > 0.) || !std::isfinite(error))
              continue;
            factors[s].*number.error = (error < 0. ? -1. : 1.) / largest;
            estimate.relative =
              std::max(estimate.relative, std::abs(error) / largest);
          }
      }
    estimate.contributions = finer.contributions(factors);
    return estimate;
  }
} // namespace lumbricus
