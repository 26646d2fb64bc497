// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>

#include <algorithm>

namespace lumbricus
{
  std::vector<const Contact *>
  contacts_of(const BoundaryConditions &conditions)
  {
    std::vector<const Contact *> contacts;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      contacts.push_back(
        dynamic_cast<const Contact *>(conditions.condition(i).type.get()));
    return contacts;
  }



  bool
  has_contact(const BoundaryConditions &conditions)
  {
    const auto contacts = contacts_of(conditions);
    return std::any_of(contacts.begin(), contacts.end(), [](const auto *c) {
      return c != nullptr;
    });
  }
} // namespace lumbricus
