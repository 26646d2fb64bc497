// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_state_h
#define lumbricus_core_state_h

#include <deal.II/lac/trilinos_vector.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a state is made of: Trilinos' distributed vectors. */
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  /** Unknowns that are not those of any node, the same on all ranks: one or
   * more of each name, which has no blanks. */
  using Globals = std::map<std::string, std::vector<double>>;

  /**
   * All that a run has to remember, as a value: copy it to roll back.
   * Only Newton's method writes the solution, only the reset writes the
   * histories of the liquid; a reset that relaxes the liquid's mesh writes all.
   */
  struct State
  {
    /** A solution, and when it was that of the run. */
    struct Past
    {
      double time;     ///< as State::time
      Vector solution; ///< as State::solution
    };

    /** The load parameter, called time [any unit: the problem is static]. */
    double time = 0.;
    /** Displacement u [mm] and pressure variable p [N/mm^2], owned entries. */
    Vector solution;
    /** The global unknowns, of every Border there is. */
    Globals globals;
    /** Vector fields that have a value at each node of each cell, by name:
     * NodalHistory gives them. */
    std::map<std::string, Vector> histories;
    /** The ends of the last load steps, the latest first, from which Predictor
     * extrapolates: as many as it needs, none where the load does not go on as
     * it did. */
    std::deque<Past> past;

    /** When the solutions of the past were those of the run. */
    std::vector<double>
    past_times() const
    {
      std::vector<double> times;
      for (const Past &earlier : past)
        times.push_back(earlier.time);
      return times;
    }

    /** After entries have been set. Collective. */
    void
    compress()
    {
      const auto set = dealii::VectorOperation::insert;
      solution.compress(set);
      for (auto &[name, vector] : histories)
        vector.compress(set);
      for (Past &earlier : past)
        earlier.solution.compress(set);
    }
  };
} // namespace lumbricus

#endif
