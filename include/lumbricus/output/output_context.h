// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_output_context_h
#define lumbricus_output_output_context_h

#include <lumbricus/output/cell_fields.h>
#include <lumbricus/output/step_record.h>

#include <functional>

namespace lumbricus
{
  /** All that tables may read after a load step, the same on all ranks but for
   * what is of cells. */
  class OutputContext
  {
  public:
    /** All of these are kept by reference. */
    OutputContext(const State          &state,
                  const StepRecord     &step,
                  const Body           &body,
                  const ReferenceField &references,
                  const LiquidWeight   &weight,
                  CellFields           &cell_fields);

    const State          &state;      ///< that has converged
    const StepRecord     &step;       ///< what the load step took
    const Body            body;       ///< mesh, unknowns, tissues
    const ReferenceField &references; ///< of this state
    const LiquidWeight   &weight;     ///< at its time

    /** All fields at this state; computed when they are first asked for.
     * Collective. */
    const CellFields &
    fields() const;

    /** Call @p visit at the quadrature points of this rank's cells, see
     * lumbricus::visit_points(). Collective. */
    void
    visit_points(const std::function<void(const FieldPoint &)> &visit) const;

  private:
    CellFields  &cell_fields;
    mutable bool fields_are_current = false;
  };
} // namespace lumbricus

#endif
