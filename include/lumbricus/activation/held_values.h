// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_activation_held_values_h
#define lumbricus_activation_held_values_h

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * The activation of a muscle in each segment as a controller has given it for
   * a load step from t_a to t_b: the value v_b that was asked for is reached at
   * the end of the step, from v_a, which the muscle had before,
   *
   *   v(t) = (1 - q) v_a + q v_b,  q = (t - t_a)/(t_b - t_a) from 0 to 1.
   *
   * Before t_a it is v_a, after t_b it is v_b.
   */
  class HeldValues
  {
  public:
    /** From where and until when, and both values of each segment. */
    struct Way
    {
      double              from = 0.; ///< t_a [time]
      double              to   = 0.; ///< t_b [time], not less
      std::vector<double> before;    ///< v_a
      std::vector<double> after;     ///< v_b
    };

    /** Those of the activation in the section @p section, which the controller
     * at @p address gives within @p late_after seconds. Until it does they are
     * @p at_rest in all @p n_segments segments. */
    HeldValues(const std::string &section,
               const std::string &address,
               const double       late_after,
               const unsigned int n_segments,
               const double       at_rest)
      : section(section)
      , address(address)
      , late_after(late_after)
      , way{0.,
            0.,
            std::vector<double>(n_segments, at_rest),
            std::vector<double>(n_segments, at_rest)}
    {}

    /** The value at time @p t in segment @p segment, from one. */
    double
    value(const double t, const unsigned int segment) const;

    /** The step from time @p from, until which all stays as it was, to time
     * @p to ends with @p values. */
    void
    go_to(const double               from,
          const double               to,
          const std::vector<double> &values);

    /** How the values are now, to go on with it later. */
    const Way &
    now() const
    {
      return way;
    }

    /** Go on with what now() was. */
    void
    set(const Way &other)
    {
      way = other;
    }

    const std::string section;    ///< with the parameters, for messages
    const std::string address;    ///< of the controller: a Unix socket
    const double      late_after; ///< how long it may take [s]

  private:
    Way way;
  };
} // namespace lumbricus

#endif
