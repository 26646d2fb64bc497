// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_state_h
#define lumbricus_core_state_h

#include <deal.II/lac/la_parallel_vector.h>

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * The vector of all of the program: of states, of residuals, of what cells
   * read from and add to, and of Krylov methods. Those of a state have owned
   * entries alone; who needs those of other ranks makes a copy that has them
   * (MixedSpace::with_ghosts()) and is only read.
   */
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /** Unknowns that are not those of any node, the same on all ranks: one or
   * more of each name, which has no blanks. */
  using Globals = std::map<std::string, std::vector<double>>;



  /** All of a state but the numbers on the mesh. */
  struct StateOutline
  {
    double                time      = 0.; ///< State::time
    double                last_time = 0.; ///< State::last_time
    std::vector<double>   past;           ///< the times of State::past
    std::set<std::string> histories;      ///< the names of State::histories
    Globals               globals;        ///< State::globals
  };



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
    /** When the last load step ended; the same as the time where none is under
     * way. */
    double last_time = 0.;
    /** Displacement u [mm] and pressure variable p [N/mm^2], owned entries. */
    Vector solution;
    /** The global unknowns of every Border there is, and numbers that its
     * sources remember. */
    Globals globals;
    /** Vector fields that have a value at each node of each cell, by name: see
     * NodalHistory. */
    std::map<std::string, Vector> histories;
    /** The ends of the last load steps, the latest first, from which Predictor
     * extrapolates: as many as it needs, none where the load does not go on as
     * it did. */
    std::deque<Past> past;

    /** What this consists of. */
    StateOutline
    outline() const
    {
      StateOutline found{time, last_time, {}, {}, globals};
      for (const Past &earlier : past)
        found.past.push_back(earlier.time);
      for (const auto &history : histories)
        found.histories.insert(history.first);
      return found;
    }
  };
} // namespace lumbricus

#endif
