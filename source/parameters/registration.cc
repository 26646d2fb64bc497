// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registration.h>

#include <boost/core/demangle.hpp>

#include <dlfcn.h>

#include <map>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // Made when it is first used, which is before main() starts.
    std::vector<Registration> &
    all_registrations()
    {
      static std::vector<Registration> all;
      return all;
    }



    // The file of the library or program that has this object.
    std::string
    file_with(const void *object)
    {
      Dl_info info;
      return dladdr(object, &info) != 0 && info.dli_fname != nullptr ?
               info.dli_fname :
               "the program";
    }



    std::string
    in_words(const Registration &registration)
    {
      return registration.derived + " in '" + registration.loaded_from + "'";
    }
  } // namespace



  const std::vector<Registration> &
  registrations()
  {
    return all_registrations();
  }



  void
  note_registration(const std::type_info &base,
                    const std::type_info &derived,
                    const std::string    &name,
                    const void           *object)
  {
    all_registrations().push_back({boost::core::demangle(base.name()),
                                   boost::core::demangle(derived.name()),
                                   name,
                                   file_with(object)});
  }



  std::string
  clash_of_names(const std::vector<Registration> &all)
  {
    std::map<std::pair<std::string, std::string>, const Registration *> taken;
    for (const Registration &one : all)
      {
        const auto [other, is_new] =
          taken.insert({{one.base, one.name}, &one});
        if (!is_new)
          return "the name '" + one.name + "' is that of two classes of " +
                 one.base + ": " + in_words(*other->second) + " and " +
                 in_words(one);
      }
    return "";
  }
} // namespace lumbricus
