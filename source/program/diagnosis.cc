// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/program/diagnosis.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // Stiffness of this part of that at rest is next to none.
    constexpr double little = 0.1;
    // A cell with a scaled Jacobian below this is badly shaped.
    constexpr double badly_shaped = 0.05;

    const std::string what_to_try =
      " Try a smaller 'Time/Smallest step', a smaller active stretch or load, or "
      "a finer mesh.";

    // Linearise at a state under the loads of any time.
    void
    linearise(ChainModel &model, const State &state, const LoadTime &t)
    {
      model.set_to(state, t);
      model.equilibrium.forget_factors();
      model.equilibrium.linearise({state.solution, state.globals});
    }



    std::string
    percent(const double part)
    {
      std::ostringstream out;
      const double       of_hundred = 100. * part;
      if (std::abs(of_hundred) < 10.)
        out << std::setprecision(2) << of_hundred << " %";
      else
        out << std::round(of_hundred) << " %";
      return out.str();
    }



    std::string
    worst_cells(ChainModel &model, const State &state)
    {
      const Vector       relevant  = model.space.with_ghosts(state.solution);
      const auto         qualities = mesh_qualities(model.body, &relevant);
      std::ostringstream out;
      out.precision(2);
      for (unsigned int s = 0; s < qualities.size(); ++s)
        for (const auto &[name, quality] :
             {std::make_pair("liquid", qualities[s].liquid),
              std::make_pair("wall", qualities[s].wall)})
          if (quality < badly_shaped)
            out << (out.str().empty() ? "" : ", ") << name << " of segment "
                << s + 1 << " (scaled Jacobian " << quality << ")";
      return out.str();
    }
  } // namespace



  std::string
  diagnose(ChainModel     &model,
           const State    &state,
           const LoadTime &now,
           const LoadTime &next)
  {
    const Stability    stability = model.stability();
    std::ostringstream words;
    try
      {
        linearise(model, state, next);
        const Vector loads = model.equilibrium.right_hand_side();
        linearise(model, state, now);
        const auto   softest  = stability.softest_motion();
        const auto   answer   = stability.response(loads);
        const double likeness = stability.likeness(softest, answer);
        const auto   place    = stability.place(softest);

        const State at_rest = model.rest_state();
        linearise(model, at_rest, at_rest.time);
        const double softest_part =
          softest.stiffness / stability.softest_motion().stiffness;
        const double answer_part =
          answer.stiffness / stability.response(loads).stiffness;

        AssertThrow(std::isfinite(softest_part) && std::isfinite(answer_part),
                    ExcNotConverged("it is not a number"));

        std::ostringstream where;
        where << "\nThe body is close to a static instability at time "
              << now.to() << ": ";
        if (answer_part < little && likeness > 0.5)
          words << where.str()
                << "a limit point. Its stiffness against the loads has fallen "
                   "to "
                << percent(answer_part)
                << " of that at rest, in a motion that is largest in " << place
                << ". Beyond it there is no equilibrium nearby. Let the loads "
                   "stop short of it, or prescribe displacements where now a "
                   "pressure is prescribed.";
        else if (softest_part < little)
          words << where.str()
                << "buckling (a bifurcation). In a motion that is largest in "
                << place << ", and which the loads do not drive, its stiffness "
                << (softest.stiffness < 0. ?
                      "is negative" :
                      "has fallen to " + percent(softest_part) +
                        " of that at rest")
                << ". Make that part stiffer or thicker, contract it by a "
                   "muscle of its own, or let an imperfection choose the way.";
        else
          {
            words << "\nThe body is stable at time " << now.to()
                  << ": its stiffness in the softest motion is "
                  << percent(softest_part) << " of that at rest, against the "
                  << "loads " << percent(answer_part) << ".";
            const std::string cells = worst_cells(model, state);
            words << (cells.empty() ?
                        what_to_try :
                        " Its mesh has cells that are badly shaped: " + cells +
                          ". Try a finer mesh or one of another shape there.");
          }
      }
    catch (const ExcNotConverged &exception)
      {
        words << "\nThe stiffness of the body at time " << now.to()
              << " cannot be computed: " << plain_message(exception) << "."
              << what_to_try;
      }
    // Whoever looks at the model next finds it where the run is.
    model.set_to(state, now);
    return words.str();
  }
} // namespace lumbricus
