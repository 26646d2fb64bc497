// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_registration_h
#define lumbricus_parameters_registration_h

#include <string>
#include <typeinfo>
#include <vector>

namespace lumbricus
{
  /** What is known of a class that has put itself into a Registry. */
  struct Registration
  {
    std::string base;        ///< the interface, as C++ calls it
    std::string derived;     ///< the class, as C++ calls it
    std::string name;        ///< what users choose it by
    std::string loaded_from; ///< the library or program that has it
  };

  /**
   * All of them, of all interfaces, in their order: those of the program and
   * its libraries before main() starts, more when a library is loaded.
   */
  const std::vector<Registration> &
  registrations();

  /**
   * Note that @p derived has the name @p name among those of @p base.
   * @p object is anything in the same library or program. Throws nothing,
   * since nobody could catch it before main() starts: see clash_of_names().
   */
  void
  note_registration(const std::type_info &base,
                    const std::type_info &derived,
                    const std::string    &name,
                    const void           *object);

  /** Where two classes of the same interface have the same name, a message that
   * names both; empty if there are none. */
  std::string
  clash_of_names(const std::vector<Registration> &all);
} // namespace lumbricus

#endif
