// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_contact_contacts_h
#define lumbricus_contact_contacts_h

#include <lumbricus/contact/contact.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <vector>

namespace lumbricus
{
  /** Which of the conditions are a Contact: one entry for each condition, null
   * where it is something else. */
  std::vector<const Contact *>
  contacts_of(const BoundaryConditions &conditions);

  /** Whether there is any. */
  bool
  has_contact(const BoundaryConditions &conditions);
} // namespace lumbricus

#endif
