// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_controllers_h
#define lumbricus_continuation_controllers_h

#include <lumbricus/activation/held_values.h>
#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/continuation/continuation.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "controller_answer.h"
#include "controller_socket.h"

namespace lumbricus
{
  /**
   * The programs of the user's that say what muscles do, of those muscles that
   * have HeldValues: before a load step each is told, on one line of JSON, where
   * the step leads and how the segments are, and answers with a line. The first
   * rank talks. See doc/controllers.md.
   */
  class Controllers
  {
  public:
    /** Find the muscles of @p anatomy, which is initialized, and the addresses
     * of their controllers. */
    void
    initialize(const Anatomy &anatomy);

    /** Connect to all. Throws ExcInput, with the address. Collective. */
    void
    connect(const MPI_Comm comm);

    /**
     * Ask for what the muscles do at the end of a step from @p state to time
     * @p to, and let them do so.
     * @return that time, or an earlier one where a controller wants none as long
     * as that. Throws ExcSolveFailed, with what came, and ExcInterrupted.
     * Collective.
     */
    double
    ask(ChainModel &model, const State &state, const double to);

    /** The longest step that they want, by their last answers [time]. */
    double
    largest_step() const
    {
      return largest_dt;
    }

    /** HeldValues::now() of all, and the longest step, each with a name that
     * begins with "held_". */
    Continuation::Numbers
    numbers() const;

    /** Go on with what numbers() was; a muscle of which there is nothing in it
     * begins at rest. @return whether it can; then only this is changed. */
    bool
    set_numbers(const Continuation::Numbers &numbers);

    /** Whether @p name is that of one of the numbers(). */
    static bool
    is_name(const std::string &name);

  private:
    struct Asked
    {
      const Muscle               *muscle;
      std::shared_ptr<HeldValues> held;
    };

    struct Controller
    {
      std::string              address;
      std::vector<Asked>       muscles;
      std::vector<AskedMuscle> questions;
      double                   late_after;
      ControllerSocket         socket; // of the first rank
    };

    // The answer of one, on all ranks.
    ControllerAnswer
    answer_of(Controller        &controller,
              const std::string &line,
              const double       smallest_step,
              const MPI_Comm     comm);

    std::vector<std::unique_ptr<Controller>> controllers;

    double largest_dt = std::numeric_limits<double>::max();
  };
} // namespace lumbricus

#endif
