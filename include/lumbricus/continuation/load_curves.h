// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_load_curves_h
#define lumbricus_continuation_load_curves_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What drives a run, over time, so that no step passes over a change of it.
   * A load step from t_a to t_b sees the data d at its ends only; what it misses
   * is the excess
   *
   *   e(t) = max( d(t) - max(d_a, d_b), min(d_a, d_b) - d(t), 0 ).
   *
   * Steps are divided until e is at most the part 'Time/Largest miss' of the
   * swing of d: its largest minus its smallest value in the run, at that point of
   * all curves of the same name where this is most. Where there is
   * such a pulse within a step, or within as much again on either side of it, no
   * d departs by more than this from the straight line between d_a and d_b
   * either: steps end where pulses begin, peak and end. With a smooth pulse
   * that lasts for four steps or more, and with all that only rises or falls in
   * a step, steps are as they would be without this.
   *
   * d is looked at every 'Time/Smallest step', but at least 64 and at most 1000
   * times in a step, and at the marks that a datum has.
   */
  class LoadCurves : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** From now on look at these, in a run until time @p end whose steps are
     * not shorter than @p smallest_step where they are cut. */
    void
    follow(const std::vector<LoadCurve> &curves,
           const double                  end,
           const double                  smallest_step);

    /** Where a step is to end. */
    struct Division
    {
      double to; ///< not later than was asked for
      /** The curve of which a longer step would miss a change; null if there is
       * none. */
      const LoadCurve *curve;
    };

    /**
     * Where a step from time @p from to time @p to has to end so as to miss no
     * change: at the first peak that would be missed, else where a pulse departs
     * most, at a mark if there is one; where a pulse jumps right before that and
     * then right after it.
     */
    Division
    divide(const double from, const double to) const;

    /** A change that shorter steps do not divide. */
    struct Jump
    {
      /** The time before it; none where the data of the first step are not
       * those of rest. */
      std::optional<double> before;
      double                after; ///< the time after it
      const LoadCurve      *curve; ///< what jumps most
      double                from;  ///< its value before
      double                to;    ///< its value after
    };

    /**
     * The jump within the step from time @p from to time @p to: half of a
     * curve's change in the step, or more, within a small part of 'Time/Smallest
     * step'. None where no curve has any.
     */
    std::optional<Jump>
    jump(const double from, const double to) const;

    /** How long before a jump a step ends [time]. */
    double
    shortest() const
    {
      return 1e-9 * end;
    }

  private:
    using Value = std::function<double(double)>;

    std::vector<double>
    sample_times(const LoadCurve &curve,
                 const double     from,
                 const double     to) const;

    /** Whether a datum goes between two times beyond its values at both by more
     * than @p most. */
    bool
    has_pulse(const LoadCurve &curve,
              const Value     &value,
              const double     from,
              const double     to,
              const double     most) const;

    /** The time at which to divide a step because of curve number @p i; pulses
     * are looked for this much to either side of it. */
    std::optional<double>
    first_miss(const unsigned int i,
               const double       from,
               const double       to,
               const double       reach) const;

    double                 largest_miss = 0.15;
    double                 end          = 1.;
    double                 smallest     = 1e-4;
    std::vector<LoadCurve> curves;
    /** Of each of them, and those of its name, as far as samples over the whole
     * run show it. */
    std::vector<double> swings;
  };



  /** "the active stretch of muscle 'circular' in segment 1 jumps between the
   * times 0.499999999 and 0.5, from 1 to 0.5". */
  std::string
  jump_text(const LoadCurves::Jump &jump);
} // namespace lumbricus

#endif
