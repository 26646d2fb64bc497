// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint_schedule.h>

#include <deal.II/base/patterns.h>

namespace lumbricus
{
  void
  CheckpointSchedule::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoints");
    prm.add_parameter("Steps",
                      every_steps,
                      "[-] Write a checkpoint, from which --restart goes on, "
                      "after every so many load steps; 0 for not so.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Minutes",
                      every_minutes,
                      "[min] Write one when the last is this old; 0 for not "
                      "so. With either there is one at the end of a run too.",
                      dealii::Patterns::Double(0.));
    prm.leave_subsection();
  }



  bool
  CheckpointSchedule::any() const
  {
    return every_steps > 0 || every_minutes > 0.;
  }



  bool
  CheckpointSchedule::due(const unsigned int number, const MPI_Comm comm) const
  {
    if (due_by_number(number))
      return true;
    if (!(every_minutes > 0.))
      return false;
    // The clock of the first rank counts.
    return dealii::Utilities::MPI::broadcast(comm,
                                             since_last.wall_time() >
                                               60. * every_minutes);
  }



  bool
  CheckpointSchedule::due_by_number(const unsigned int number) const
  {
    return every_steps > 0 && number % every_steps == 0;
  }



  void
  CheckpointSchedule::written()
  {
    since_last.restart();
  }
} // namespace lumbricus
