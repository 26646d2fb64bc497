// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_controller_answer_h
#define lumbricus_continuation_controller_answer_h

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a controller has to say of a muscle. */
  struct AskedMuscle
  {
    std::string name; ///< Muscle::name()
    /** As MuscleAction::quantity(). */
    std::string quantity;
    /** As MuscleAction::requirement(). */
    std::function<std::string(double)> requirement;
  };



  /** What it has said of all of them. */
  struct ControllerAnswer
  {
    /** Of each muscle in each segment. */
    std::vector<std::vector<double>> values;
    /** No step is to be longer than this [time]. */
    std::optional<double> largest_dt;
    /** What is wrong with it, as "is no JSON"; then the rest is nothing. */
    std::string fault;
  };



  /**
   * Read the line @p json, an object that has for each of @p muscles a number or
   * an array with one for each of @p n_segments segments, and perhaps
   * "largest_dt", at least @p smallest_step, and nothing else.
   */
  ControllerAnswer
  read_answer(const std::string              &json,
              const std::vector<AskedMuscle> &muscles,
              const unsigned int              n_segments,
              const double                    smallest_step);
} // namespace lumbricus

#endif
