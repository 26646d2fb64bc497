// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/continuation/load_curves.h>
#include <lumbricus/parameters/patterns.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "curve_samples.h"

namespace lumbricus
{
  namespace
  {
    // How often to look at the whole run, and into a step.
    constexpr unsigned int n_in_run        = 1000;
    constexpr unsigned int fewest_in_step  = 64;
    constexpr unsigned int most_in_step    = 1000;
    constexpr unsigned int most_divisions  = 200;
    constexpr double       constant_within = 1e-9;
  } // namespace



  void
  LoadCurves::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("Largest miss",
                      largest_miss,
                      "[-] What a step may pass over. Where an active stretch, "
                      "a load or a prescribed displacement goes within a step "
                      "beyond its values at both ends by more than this part "
                      "of its swing (how far it goes up and down in the run, "
                      "in any segment), the step ends at that peak, and others "
                      "where the pulse begins and ends. With 1 it may miss "
                      "all.",
                      PositiveNumber());
    prm.leave_subsection();
  }



  void
  LoadCurves::follow(const std::vector<LoadCurve> &curves_,
                     const double                  end_,
                     const double                  smallest_step)
  {
    curves   = curves_;
    end      = end_;
    smallest = smallest_step;
    std::map<std::string, double> swing_of;
    for (const LoadCurve &curve : curves)
      for (const Value &value : curve.values)
        {
          Range range;
          for (unsigned int i = 0; i <= n_in_run; ++i)
            range.add(value(end * i / n_in_run));
          double &swing = swing_of[curve.what];
          swing         = std::max(swing, range.swing());
        }
    swings.clear();
    for (const LoadCurve &curve : curves)
      swings.push_back(swing_of[curve.what]);
  }



  std::vector<double>
  LoadCurves::sample_times(const LoadCurve &curve,
                           const double     from,
                           const double     to) const
  {
    const unsigned int n =
      std::clamp((to - from) / smallest,
                 double(fewest_in_step),
                 double(most_in_step));
    std::vector<double> times;
    times.reserve(n + 1);
    for (unsigned int i = 0; i < n; ++i)
      times.push_back(from + (to - from) * i / n);
    times.push_back(to);
    if (curve.marks)
      for (const double mark : curve.marks(from, to))
        if (from < mark && mark < to)
          times.push_back(mark);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }



  bool
  LoadCurves::has_pulse(const LoadCurve &curve,
                        const Value     &value,
                        const double     from,
                        const double     to,
                        const double     most) const
  {
    const Samples samples(value,
                          sample_times(curve,
                                       std::max(from, 0.),
                                       std::min(to, end)));
    return samples.t.size() > 2 && samples.first_peak_beyond(most) > 0;
  }



  std::optional<double>
  LoadCurves::first_miss(const unsigned int i,
                         const double       from,
                         const double       to,
                         const double       reach) const
  {
    const LoadCurve &curve = curves[i];
    const auto       times = sample_times(curve, from, to);
    const auto       marks =
      curve.marks ? curve.marks(from, to) : std::vector<double>();
    const auto is_mark = [&](const double t) {
      return std::find(marks.begin(), marks.end(), t) != marks.end();
    };

    std::optional<double> first;
    for (const Value &value : curve.values)
      {
        const Samples samples(value, times);
        const auto   &t = samples.t;
        const auto   &d = samples.d;
        // Without a value at an end the step will say so itself.
        if (t.size() < 3 || t.front() != from || t.back() != to)
          continue;
        const double swing = std::max(swings[i], samples.range.swing());
        const double most  = largest_miss * swing;
        if (swing <= constant_within * samples.range.size())
          continue;

        const std::size_t peak      = samples.first_peak_beyond(most);
        std::size_t       k         = peak;
        const auto        departure = [&](const std::size_t j) {
          return std::abs(samples.departure(t[j], d[j]));
        };
        if (peak == 0)
          {
            k = 1;
            for (std::size_t j = 2; j + 1 < t.size(); ++j)
              if (departure(j) > departure(k))
                k = j;
            if (!(departure(k) > most) ||
                !has_pulse(curve, value, from - reach, to + reach, most))
              continue;
            std::size_t mark = 0;
            for (std::size_t j = 1; j + 1 < t.size(); ++j)
              if (departure(j) >= 0.5 * departure(k) && is_mark(t[j]) &&
                  (mark == 0 || departure(j) > departure(mark)))
                mark = j;
            if (mark > 0)
              k = mark;
          }

        // Where it jumps beside this sample, right before that, or if the step
        // begins there right after it.
        double divided = t[k];
        bool   jumps   = false;
        for (const std::size_t j : {k - 1, k})
          {
            if (jumps || std::abs(d[j + 1] - d[j]) <= most)
              continue;
            const auto [low, high] = where_it_changes(value, t[j], t[j + 1]);
            if (high - low > shortest())
              continue;
            jumps               = true;
            const double before = high - shortest();
            divided = before > from + 0.5 * shortest() ? before : high;
          }
        if (!jumps && !is_mark(t[k]))
          {
            const double sign =
              samples.departure(t[k], d[k]) > 0. ? 1. : -1.;
            divided = where_largest(
              [&](const double at) {
                const double d = value(at);
                return sign * (peak > 0 ? d : samples.departure(at, d));
              },
              t[k - 1],
              t[k + 1],
              t[k]);
          }
        if (divided < to && (!first || divided < *first))
          first = divided;
      }
    return first;
  }



  LoadCurves::Division
  LoadCurves::divide(const double from, const double to) const
  {
    Division division = {to, nullptr};
    bool     divided  = true;
    for (unsigned int n = 0; divided && n < most_divisions; ++n)
      {
        divided = false;
        for (unsigned int i = 0;
             i < curves.size() && division.to - from > 2. * shortest();
             ++i)
          if (const auto miss = first_miss(i, from, division.to, to - from))
            {
              division = {*miss, &curves[i]};
              divided  = true;
            }
      }
    return division;
  }



  std::optional<LoadCurves::Jump>
  LoadCurves::jump(const double from, const double to) const
  {
    std::optional<Jump> most;
    double              most_of_swing = 0.;
    const auto          consider      = [&](const Jump  &jump,
                              const double change,
                              const double swing) {
      const double of_swing =
        std::abs(jump.to - jump.from) / std::max(swing, change);
      if (of_swing <= std::max(most_of_swing, 1e-2))
        return;
      most          = jump;
      most_of_swing = of_swing;
    };

    for (unsigned int i = 0; i < curves.size(); ++i)
      for (const Value &value : curves[i].values)
        {
          const Samples samples(value, sample_times(curves[i], from, to));
          const double  change = samples.range.swing();
          if (samples.t.size() < 2 ||
              change <= constant_within * samples.range.size())
            continue;
          std::size_t k = 0;
          for (std::size_t j = 0; j + 1 < samples.t.size(); ++j)
            if (std::abs(samples.d[j + 1] - samples.d[j]) >
                std::abs(samples.d[k + 1] - samples.d[k]))
              k = j;
          auto [low, high] =
            where_it_changes(value, samples.t[k], samples.t[k + 1]);
          if (high - low > 0.25 * smallest)
            continue;
          low = std::max(from, std::min(low, high - shortest()));
          const Jump jump = {
            low, high, &curves[i], value(low), value(high)};
          if (std::abs(jump.to - jump.from) >= 0.5 * change)
            consider(jump, change, swings[i]);
        }
    if (most || from > 0.)
      return most;

    // A run starts at rest, whatever its loads are at that time.
    for (unsigned int i = 0; i < curves.size(); ++i)
      for (const Value &value : curves[i].values)
        {
          const double rest   = curves[i].at_rest;
          const double change = std::abs(value(to) - rest);
          const Jump   jump   = {{}, to, &curves[i], rest, value(to)};
          if (change > 0. && std::abs(value(from) - rest) >= 0.5 * change)
            consider(jump, change, swings[i]);
        }
    return most;
  }



  std::string
  jump_text(const LoadCurves::Jump &jump)
  {
    std::ostringstream text;
    text.precision(10);
    text << jump.curve->what << jump.curve->where;
    if (jump.before)
      text << " jumps between the times " << *jump.before << " and "
           << jump.after << ", from ";
    else
      text << " is there from the start on and goes within the first step, to "
              "time "
           << jump.after << ", from ";
    text << jump.from << " to " << jump.to;
    return text.str();
  }
} // namespace lumbricus
