// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_check.h"

#include <lumbricus/contact/contacts.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/discretization/loaded_points.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace lumbricus
{
  namespace
  {
    // What is inside deeper than this part of a cell does not find its way out.
    constexpr double deepest = 1. / 3.;



    // What cannot be used of a contact at some time; empty where all can.
    std::string
    unfit(const NamedCondition      &condition,
          const Contact             &contact,
          const Body                &body,
          const std::vector<double> &times)
    {
      const std::string section = "Section '" + condition.type_section;
      for (const double t : times)
        {
          const std::string why = contact.obstacle().unfit(t);
          if (!why.empty())
            return section + "/" + contact.obstacle_name() + "': " + why +
                   " at time " + dealii::Utilities::to_string(t) +
                   ". Change it so that there is an obstacle at all times.";
          const SegmentExpression &setae = contact.friction().setae_formula();
          for (unsigned int s = 0; s < body.anatomy.geometry().n_segments(); ++s)
            if (!(setae.value(s, t) >= 0.) || !std::isfinite(setae.value(s, t)))
              return section + "': 'Setae' " + setae.value_text(s, t) +
                     ". It has to be a number that is not negative.";
        }
      return "";
    }
  } // namespace



  void
  check_contacts(const Body                &body,
                 const BoundaryConditions  &conditions,
                 const BodyForces          &forces,
                 const Supports            &supports,
                 const std::vector<double> &times)
  {
    const std::vector<const Contact *> contacts = contacts_of(conditions);
    std::vector<std::string>           names;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const NamedCondition &condition = conditions.condition(i);
        if (contacts[i] == nullptr)
          continue;
        names.push_back(condition.name);
        const std::string message =
          unfit(condition, *contacts[i], body, times);
        AssertThrow(message.empty(), ExcInput(message));
      }
    if (names.empty())
      return;

    const MPI_Comm      comm = body.space.communicator();
    std::vector<double> nearest(contacts.size(),
                                std::numeric_limits<double>::max());
    // Whether some direction of the skin is forward.
    std::vector<unsigned int> goes_forward(contacts.size(), 0);
    double                    touches = 0.;
    for (const LoadedPoint &point : loaded_points(body.space, conditions))
      if (const Contact *contact = contacts[point.condition])
        {
          const auto standing = contact->standing(point.at_rest());
          nearest[point.condition] =
            std::min(nearest[point.condition], standing.gap);
          if (standing.touches)
            touches = 1.;
          if (contact->friction().forward(standing.n).norm_square() > 0.)
            goes_forward[point.condition] = 1;
        }
    touches = dealii::Utilities::MPI::max(touches, comm);
    dealii::Utilities::MPI::min(nearest, comm, nearest);
    dealii::Utilities::MPI::max(goes_forward, comm, goes_forward);

    for (unsigned int i = 0; i < contacts.size(); ++i)
      AssertThrow(contacts[i] == nullptr || goes_forward[i] > 0 ||
                    contacts[i]->friction().isotropic(),
                  ExcInput("Section '" + conditions.condition(i).type_section +
                           "': 'Forward' is along the normal of '" +
                           conditions.condition(i).name +
                           "', so that nothing that slides on it goes forward "
                           "or backward. Give a vector along its surface, or "
                           "the same 'Friction' and 'Shear strength' in all "
                           "directions."));

    for (unsigned int i = 0; i < contacts.size(); ++i)
      if (contacts[i] != nullptr &&
          nearest[i] < -deepest * contacts[i]->cell_thickness())
        {
          std::ostringstream message;
          message.precision(3);
          message << "At time 0 the boundary '"
                  << conditions.condition(i).boundary_name << "' is "
                  << -nearest[i] << " mm inside of '"
                  << conditions.condition(i).name
                  << "', more than a third of its cells' thickness ("
                  << contacts[i]->cell_thickness()
                  << " mm). Move the obstacle in section '"
                  << conditions.condition(i).type_section << "/"
                  << contacts[i]->obstacle_name() << "', or start apart and let it move.";
          AssertThrow(false, ExcInput(message.str()));
        }
    std::ostringstream gap;
    gap.precision(3);
    gap << *std::min_element(nearest.begin(), nearest.end());
    AssertThrow(touches > 0. || forces.n_forces() == 0 ||
                  supports.held_without_minimal_support().all_held(),
                ExcInput("Nothing of the body touches " + quoted_list(names) +
                         " (it is " + gap.str() +
                         " mm away), and its weight is not held: it falls. "
                         "Move the obstacle so that it touches the body at "
                         "time 0, or hold the body by a condition of type "
                         "'displacement' or 'spring'."));
  }
} // namespace lumbricus
