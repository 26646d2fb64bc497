// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_nodal_history_h
#define lumbricus_core_nodal_history_h

#include <lumbricus/core/state.h>

#include <set>
#include <string>

namespace lumbricus
{
  /**
   * A vector field that a part of the program remembers from one load step to
   * the next, as one Q2 displacement on each cell. Defined once, at namespace
   * scope, beside what writes it; copying a state, refinement, repartition and
   * checkpoints take it along.
   */
  class NodalHistory
  {
  public:
    /** Which runs have it: where it is only some, whoever makes their state of
     * rest gives it to them. */
    enum class Runs
    {
      all,
      some
    };

    /** Zero at first, everywhere. The @p name has no blanks, and no other
     * history has it. */
    explicit NodalHistory(const std::string &name,
                          const Runs         runs = Runs::all);

    NodalHistory(const NodalHistory &) = delete;
    NodalHistory &
    operator=(const NodalHistory &) = delete;

    /** The name that the history was defined with. */
    const std::string &
    name() const;

    /** The history in @p state: numbered by MixedSpace::rest_dof_handler, owned
     * entries. Not for the innermost loop. */
    Vector &
    in(State &state) const;
    /** The history in @p state, to read. */
    const Vector &
    in(const State &state) const;

    /** The names of all, which every state has. */
    static const std::set<std::string> &
    names();

    /** What a state calls the history that a condition at the boundary has in
     * some runs: 'boundary:left%20arm', where the user calls it 'left arm'. */
    static std::string
    of_boundary(const std::string &condition);

    /** What a state calls the parts, @p part of them from zero, of what the viscous
     * branches number @p k, from zero, of all tissues remember: 'branch:0:1'. */
    static std::string
    of_branch(const unsigned int k, const unsigned int part);

    /** What a state calls the history @p name of the state beside it, see
     * put_beside(): 'beside:u_ref'. */
    static std::string
    of_state_beside(const std::string &name);

    /** Whether @p name is one of those of a state beside. */
    static bool
    is_of_state_beside(const std::string &name);

    /** Whether there can be a history @p name in this version. */
    static bool
    is_known(const std::string &name);

  private:
    const std::string own_name;
  };
} // namespace lumbricus

#endif
