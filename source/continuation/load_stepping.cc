// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/continuation/load_stepping.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // Times that differ by less than this part of a step are the same.
    constexpr double same = 1e-6;
  } // namespace



  void
  LoadStepping::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("End",
                      end,
                      "[time] Where the run ends; it starts at 0. Time only "
                      "orders the loads, but for what hangs on rates (viscous "
                      "branches, drag, ...): the problem is quasi-static.",
                      PositiveNumber());
    prm.add_parameter("First step",
                      first,
                      "[time] The first load step.",
                      PositiveNumber());
    prm.add_parameter("Largest step",
                      largest,
                      "[time] No load step is longer.",
                      PositiveNumber());
    prm.add_parameter("Smallest step",
                      smallest,
                      "[time] A step that does not converge is halved; the run "
                      "ends when it would be shorter than this.",
                      PositiveNumber());
    prm.add_parameter("Result interval",
                      interval,
                      "[time] Steps end exactly at the multiples of this; 0 "
                      "for none.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Growth",
                      growth,
                      "[-] Factor by which a step grows after an easy one.",
                      dealii::Patterns::Double(1.));
    prm.add_parameter("Easy iterations",
                      easy,
                      "[-] A step is easy when its first Newton solve takes no "
                      "more iterations than this.",
                      dealii::Patterns::Integer(1));
    prm.leave_subsection();
  }



  void
  LoadStepping::check_parameters() const
  {
    AssertThrow(smallest <= first && first <= largest,
                ExcInput(
                  "Parameters 'Time/Smallest step', 'Time/First step' and "
                  "'Time/Largest step' are " +
                  dealii::Utilities::to_string(smallest) + ", " +
                  dealii::Utilities::to_string(first) + " and " +
                  dealii::Utilities::to_string(largest) +
                  ". Change them so that the first step is not smaller than "
                  "the smallest and not larger than the largest."));
    std::ostringstream too_often;
    too_often << "is " << interval << ", less than 'Time/Smallest step', " << smallest
              << ". Raise it, or set it to 0 for none.";
    AssertThrow(interval == 0. || interval >= smallest,
                ExcInput(about_parameter("Time/Result interval",
                                         too_often.str())));
  }



  double
  LoadStepping::end_time() const
  {
    return end;
  }



  double
  LoadStepping::first_step() const
  {
    return first;
  }



  double
  LoadStepping::largest_step() const
  {
    return largest;
  }



  double
  LoadStepping::smallest_step() const
  {
    return smallest;
  }



  bool
  LoadStepping::finished(const double time) const
  {
    return time >= end * (1. - 1e-12);
  }



  double
  LoadStepping::next_time(const double time, const double step) const
  {
    // The first of the marks (multiples of the interval, the end) ahead.
    double mark = end;
    if (interval > 0.)
      mark =
        std::min(end, interval * (std::floor(time / interval + same) + 1.));

    // Do not leave a tiny step before the mark.
    return time + step * (1. + same) >= mark ? mark : time + step;
  }



  double
  LoadStepping::step_after(const double       step,
                           const unsigned int n_newton_iterations) const
  {
    return n_newton_iterations <= easy ? std::min(largest, growth * step) :
                                         step;
  }
} // namespace lumbricus
