// SPDX-License-Identifier: LGPL-2.1-or-later
#include "load_path.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/program/diagnosis.h>

#include <algorithm>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    constexpr double first_part    = 0.5;
    constexpr double smallest_part = 1. / 1024;

    void
    append(const ResetIteration::Report &part, ResetIteration::Report &all)
    {
      all.solves.insert(all.solves.end(),
                        part.solves.begin(),
                        part.solves.end());
      all.n_resets.resize(part.n_resets.size(), 0);
      for (unsigned int s = 0; s < part.n_resets.size(); ++s)
        all.n_resets[s] += part.n_resets[s];
      all.relaxed.resize(part.n_resets.size(), false);
      for (unsigned int s = 0; s < part.relaxed.size(); ++s)
        all.relaxed[s] = all.relaxed[s] || part.relaxed[s];
    }



    void
    relax(ChainModel        &model,
          State             &state,
          std::vector<bool> &relaxed)
    {
      const auto relaxation = model.relax_liquid_mesh(state);
      if (relaxation.in_segment.empty())
        return;
      relaxed.resize(relaxation.in_segment.size(), false);
      for (unsigned int s = 0; s < relaxed.size(); ++s)
        relaxed[s] = relaxed[s] || relaxation.in_segment[s];
    }
  } // namespace



  LoadPathReport
  go_over(const LoadCurves::Jump &jump,
          ChainModel             &model,
          State                  &state,
          Log                    &log)
  {
    const double          to = jump.after;
    std::optional<double> from;
    if (jump.before)
      from = state.time;

    // On the way its time is theta, which the predictor goes by.
    State way = state;
    way.time  = 0.;
    way.past.clear();
    const Predictor &predictor = model.parameters.predictor;

    LoadPathReport path;
    double         part = first_part;
    while (way.time < 1.)
      {
        relax(model, way, path.relaxed);
        State next = way;
        // Do not leave a tiny part.
        next.time = way.time + part * (1. + 1e-6) < 1. ? way.time + part : 1.;
        try
          {
            append(model.solve(next,
                               LoadTime::between(from, to, next.time),
                               predictor.predict(way, next.time)),
                   path.report);
            predictor.accept(way, next);
            way = next;
            ++path.n_parts;
            part *= 1.5;
          }
        catch (const ExcNotConverged &exception)
          {
            // Without extrapolation before a shorter part.
            if (!way.past.empty())
              {
                way.past.clear();
                continue;
              }
            const std::string why  = plain_message(exception);
            const double      theta = next.time;
            part = 0.5 * (theta - way.time);
            ++path.n_cuts;
            log << "        cut to " << part << " of the jump: " << why << "\n";
            if (part >= smallest_part)
              continue;
            std::ostringstream message;
            message << "No solution beyond time " << state.time << ": "
                    << jump_text(jump) << ". Of this change " << 100. * way.time
                    << " % can be applied, in parts, but not another "
                    << 100. * (theta - way.time) << " %. " << why << ".";
            message << diagnose(
              model,
              way,
              way.time > 0. || !from ?
                LoadTime::between(from, to, way.time) :
                LoadTime(*from),
              LoadTime::between(from, to, theta));
            AssertThrow(false, ExcSolveFailed(message.str()));
          }
      }
    log << "        " << jump_text(jump) << "; applied in " << path.n_parts
        << " parts\n";
    way.time = to;
    state    = way;
    return path;
  }
} // namespace lumbricus
