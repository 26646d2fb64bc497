// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_checkpoint_schedule_h
#define lumbricus_checkpoint_checkpoint_schedule_h

#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

namespace lumbricus
{
  /** When a run writes checkpoints. */
  class CheckpointSchedule : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Whether there are checkpoints at all. */
    bool
    any() const;

    /** Whether one is due after step @p number; the same on all ranks.
     * Collective. */
    bool
    due(const unsigned int number, const MPI_Comm comm) const;

    /** Whether one is due after step @p number whatever the clock says. */
    bool
    due_by_number(const unsigned int number) const;

    /** One has been written. */
    void
    written();

  private:
    unsigned int  every_steps   = 0;
    double        every_minutes = 10.;
    dealii::Timer since_last;
  };
} // namespace lumbricus

#endif
