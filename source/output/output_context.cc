// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/output_context.h>

namespace lumbricus
{
  OutputContext::OutputContext(const State          &state,
                               const StepRecord     &step,
                               const Body           &body,
                               const ReferenceField &references,
                               const LiquidWeight   &weight,
                               CellFields           &cell_fields)
    : state(state)
    , step(step)
    , body(body)
    , references(references)
    , weight(weight)
    , cell_fields(cell_fields)
  {}



  const CellFields &
  OutputContext::fields() const
  {
    if (!fields_are_current)
      cell_fields.update(state);
    fields_are_current = true;
    return cell_fields;
  }



  void
  OutputContext::visit_points(
    const std::function<void(const FieldPoint &)> &visit) const
  {
    lumbricus::visit_points(body, references, weight, state, visit);
  }
} // namespace lumbricus
