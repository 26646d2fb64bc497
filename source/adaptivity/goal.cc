// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/error_estimator.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/segment_ranges.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

namespace lumbricus
{
  namespace
  {
    // A number of segments by which goals may be chosen.
    struct NamedNumber
    {
      const char        *name;
      bool GoalNumbers::*asked_for;
    };

    constexpr NamedNumber named_numbers[] = {
      {"length", &GoalNumbers::length},
      {"radius", &GoalNumbers::mid_radius},
      {"pressure", &GoalNumbers::pressure}};
  } // namespace



  /** Dual weighted residuals: EstimatedState::errors_of(). */
  class GoalEstimator : public ErrorEstimator
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      std::string names;
      for (const NamedNumber &number : named_numbers)
        names += (names.empty() ? "" : "|") + std::string(number.name);
      prm.add_parameter("Numbers",
                        numbers,
                        "[list] Which: length, radius (in the middle), pressure "
                        "(of the liquid).",
                        dealii::Patterns::MultipleSelection(names));
      prm.add_parameter("Segments",
                        segments,
                        "[numbers] Whose, from 1 at the head: a list of numbers "
                        "and ranges as '1, 8-10'; empty for all.",
                        dealii::Patterns::Anything());
    }

    void
    check_parameters() const override
    {
      AssertThrow(!dealii::Utilities::split_string_list(numbers).empty(),
                  ExcParameter("Numbers",
                               "is empty. Name one at least: length, radius or "
                               "pressure."));
    }

    void
    initialize(const Anatomy &anatomy) override
    {
      goal = GoalNumbers();
      for (const std::string &name :
           dealii::Utilities::split_string_list(numbers))
        for (const NamedNumber &number : named_numbers)
          if (name == number.name)
            goal.*number.asked_for = true;

      // An empty list is all of them.
      const unsigned int n = anatomy.geometry().n_segments();
      goal.segments =
        segments_in_list("Adaptivity/goal/Segments", segments, n);
      if (goal.segments.empty())
        for (unsigned int s = 0; s < n; ++s)
          goal.segments.push_back(s);
    }

    bool
    needs_finer_cells() const override
    {
      return true;
    }

    ErrorEstimate
    estimate(EstimatedState &state) const override
    {
      return state.errors_of(goal);
    }

  private:
    std::string numbers = "pressure", segments;
    GoalNumbers goal;
  };



  static const Register<ErrorEstimator, GoalEstimator>
    goal_estimator("goal",
                   "by what it adds to the errors of numbers that are asked for, "
                   "as the residuals on cells of half the size, weighted by how "
                   "much those numbers hang on them, have it.");
} // namespace lumbricus
