// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clock.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/displacement_before.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace lumbricus
{
  namespace
  {
    // Whether what it prescribes changes over the time of the run, in the middle of
    // some face. Collective.
    bool
    moves(const NamedCondition &condition, const ChainModel &model)
    {
      const auto *prescribed = condition.prescribed_displacement();
      if (prescribed == nullptr)
        return false;
      const auto times = model.parameters.times_to_try();
      const auto known = prescribed->components();
      bool       any   = false;
      for (const auto &cell : model.space.owned_cells())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == condition.boundary)
            for (unsigned int c = 0; c < dim; ++c)
              for (const double t : times)
                any = any ||
                      (known[c] &&
                       prescribed->value(c, cell->face(f)->center(), t) !=
                         prescribed->value(c, cell->face(f)->center(), times[0]));
      return dealii::Utilities::MPI::logical_or(any, model.space.communicator());
    }
  } // namespace



  void
  check_needs_no_clock(const ChainModel &model)
  {
    const auto refuse = [&](const std::string &what,
                            const std::string &instead) {
      AssertThrow(false,
                  ExcInput(about_parameter(
                    "Path/Control",
                    "is '" + model.parameters.continuation.chosen_name() +
                      "', along which time may go back, but " + what + ". " +
                      instead)));
    };
    const BoundaryConditions &conditions = model.parameters.boundary_conditions;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const auto *term = conditions.condition(i).surface_term();
        if (term != nullptr && term->depends_on_rate())
          refuse("'Boundary conditions/" + conditions.condition(i).name +
                   "' depends on how fast the body moves",
                 "Leave it out, or set 'time'");
      }
    if (model.surface_terms.may_slide())
      refuse("the skin slides with friction, which remembers the way in time",
             "Set its friction to 0, or set 'time'");
    if (muscles_feel_speed(model.parameters.anatomy))
      refuse("a muscle feels how fast it shortens",
             "Set its 'Force-velocity' to 'none', or set 'time'");
    if (model.parameters.anatomy.n_viscous_branches() > 0)
      refuse("a tissue has viscous branches, whose stress relaxes in time",
             "Leave them out, or set 'time'");
    if (model.parameters.cavity_contents.exchange().any())
      refuse("liquid flows through pores, leaks or in from outside",
             "Close them, or set 'time'");
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      if (moves(conditions.condition(i), model))
        refuse("'Boundary conditions/" + conditions.condition(i).name +
                 "' prescribes displacements that change",
               "Prescribe a load, or set 'time'");
  }
} // namespace lumbricus
