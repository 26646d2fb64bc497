// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/equilibrium/newton.h>
#include <lumbricus/parameters/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // The gap shrinks by a constant factor and not quadratically, so that what is
    // left of it is not next to nothing where it is found small enough.
    constexpr double least_gap = 1e-2;



    // What all increments after the last one add up to, if they go on to shrink
    // as they did: by the last factor, or, where the factors themselves shrink
    // (the convergence is superlinear), by a factor that is smaller by as much
    // again (Deuflhard, Newton Methods for Nonlinear Problems, section 2.1).
    double
    still_to_come(const std::vector<NewtonIteration> &history)
    {
      const std::size_t n      = history.size();
      const double      last   = history[n - 1].increment;
      const auto        factor = [&](const std::size_t i) {
        return history[i].increment / history[i - 1].increment;
      };
      if (n < 2)
        return last;
      double next = factor(n - 1);
      if (n > 2)
        next *= std::min(1., next / factor(n - 2));
      return next < 1. ? last * std::min(1., next / (1. - next)) : last;
    }
  } // namespace



  void
  Newton::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Newton");
    prm.add_parameter("Force tolerance",
                      force_tolerance,
                      "[-] Largest out-of-balance force, relative to the "
                      "internal forces.",
                      PositiveNumber());
    prm.add_parameter("Volume tolerance",
                      volume_tolerance,
                      "[-] Largest violation of the volume constraint, "
                      "relative to the volume of the body.",
                      PositiveNumber());
    prm.add_parameter("Increment tolerance",
                      increment_tolerance,
                      "[-] Largest displacement that is still to come, as far "
                      "as the last two increments tell, relative to the size "
                      "of the body.",
                      PositiveNumber());
    prm.add_parameter("Most iterations",
                      most_iterations,
                      "[-] With more iterations than these the load step is "
                      "cut.",
                      dealii::Patterns::Integer(1));
    prm.add_parameter("Most halvings",
                      most_halvings,
                      "[-] How often the line search halves an increment.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Growth allowed",
                      growth_allowed,
                      "[-] An increment may make the residual this many times "
                      "larger before it is halved.",
                      dealii::Patterns::Double(1.));
    prm.leave_subsection();
  }



  double
  Newton::least_force(const NonlinearProblem::Residual &residual) const
  {
    return std::max(force_tolerance, residual.force_rounding);
  }



  double
  Newton::least_volume(const NonlinearProblem::Residual &residual) const
  {
    return std::max(volume_tolerance, residual.volume_rounding);
  }



  double
  Newton::least_border(const NonlinearProblem::Residual &residual) const
  {
    return std::max(volume_tolerance, residual.border_rounding);
  }



  double
  Newton::linear_tolerance(const NonlinearProblem::Residual &residual,
                           const double                      last_merit,
                           const double                      most) const
  {
    // No linear system is solved more accurately than the linearisation
    // deserves (Eisenstat and Walker 1996, choice 2), nor much more accurately
    // than the tolerances ask for: where tissues are soft a small residual does
    // not make a small error. So one that may be the last is solved accurately;
    // if it was not the last, the next begins nearer. Where the residual is small
    // already it does not tell, as where only displacements are prescribed.
    constexpr double order = 1.6, better = 1e-4, perhaps = 8.;
    const auto       part_for = [](const double least, const double value) {
      return value > least ? least / value : 1.;
    };
    const double wanted =
      std::min({part_for(least_force(residual), residual.force),
                part_for(least_volume(residual), residual.volume),
                part_for(least_border(residual), residual.border)});
    const double accurate =
      std::min(most,
               std::max(10. * increment_tolerance,
                        wanted < 1. ? better * wanted : 0.));
    if (last_merit == 0.)
      return wanted < 1. ? most : accurate;
    const double deserved = std::pow(residual.merit() / last_merit, order);
    return deserved <= perhaps * wanted ?
             accurate :
             std::min(most, std::max(accurate, deserved));
  }



  void
  Newton::report_to(
    const std::function<void(const NewtonIteration &)> &new_listener)
  {
    listener = new_listener;
  }



  std::vector<NewtonIteration>
  Newton::solve(NonlinearProblem &problem, Unknowns &x) const
  {
    std::vector<NewtonIteration> history;
    const auto                   note = [&](const NewtonIteration &iteration) {
      history.push_back(iteration);
      if (listener)
        listener(iteration);
    };

    Unknowns   current  = x;
    const auto balanced = [&](const NonlinearProblem::Residual &residual) {
      return residual.force <= least_force(residual) &&
             residual.volume <= least_volume(residual) &&
             residual.border <= least_border(residual) &&
             residual.gap <= least_gap * increment_tolerance;
    };
    const auto give_up = [&](const std::string &why, const Unknowns &where) {
      std::ostringstream message;
      message << "Newton's method " << why << " after " << history.size()
              << " iterations";
      // Where an element is inverted there is no residual to speak of.
      const auto last = std::find_if(history.rbegin(),
                                     history.rend(),
                                     [](const NewtonIteration &iteration) {
                                       return iteration.residual.valid;
                                     });
      if (last != history.rend())
        message << " (last force residual " << last->residual.force
                << ", increment " << last->increment << ")";
      message << "; " << problem.locate_trouble(where);
      AssertThrow(false, ExcNotConverged(message.str()));
    };

    auto residual = problem.residual(current);
    if (!residual.valid)
      give_up("cannot start", current);
    if (!problem.increments_prescribed() && balanced(residual))
      return history;

    Unknowns dx         = x;
    Unknowns trial      = x;
    double   last_merit = 0.;
    while (history.size() < most_iterations)
      {
        problem.linearise(current);
        problem.solve(dx,
                      linear_tolerance(residual,
                                       last_merit,
                                       problem.largest_linear_tolerance()));
        last_merit = residual.merit();

        // Prescribed displacements are taken whole; what follows the loads
        // makes up for it in the next iterations.
        const bool   whole = problem.increments_prescribed();
        // Where tissues grow and nothing pulls at them, there are no forces but
        // those that the increment makes; how far they are out of balance, a part
        // of themselves, tells nothing.
        const bool only_grows =
          residual.force <= least_force(residual) &&
          residual.border <= least_border(residual) &&
          residual.volume > least_volume(residual);
        const double largest_merit =
          whole ? std::numeric_limits<double>::max() :
                  growth_allowed * std::max({residual.merit(),
                                             least_force(residual),
                                             only_grows ? 1. : 0.});
        double step_length = whole ? 1. : problem.largest_step(current, dx);
        NonlinearProblem::Residual trial_residual;
        for (unsigned int halvings = 0;; ++halvings)
          {
            trial = current;
            trial.add(step_length, dx);
            trial_residual = problem.residual(trial);
            if (trial_residual.valid && trial_residual.merit() <= largest_merit)
              break;
            if (whole || halvings == most_halvings)
              {
                note({trial_residual, problem.increment_size(dx.solution), step_length});
                give_up(trial_residual.valid ? "diverges" :
                                               "inverts an element",
                        trial);
              }
            step_length *= 0.5;
          }

        problem.increments_taken();
        current  = trial;
        residual = trial_residual;
        note({residual, problem.increment_size(dx.solution), step_length});
        if (step_length == 1. && balanced(residual) &&
            still_to_come(history) <= increment_tolerance)
          {
            x = current;
            return history;
          }
      }
    give_up("does not converge", current);
    return history;
  }
} // namespace lumbricus
