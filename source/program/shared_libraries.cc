// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/build_version.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/parameters/registration.h>
#include <lumbricus/program/shared_libraries.h>

#include <deal.II/base/patterns.h>

#include <dlfcn.h>

#include <cstddef>
#include <filesystem>
#include <fstream>

namespace lumbricus
{
  namespace
  {
    const std::string entry = "Additional shared libraries";

    const std::string how_to_build =
      " Build it with lumbricus_add_plugin() of CMake: see doc/extending.md.";

    // What stands in every program and library.
    bool
    is_elf(const std::string &file_name)
    {
      std::ifstream in = open_input_file(file_name);
      std::string   magic(4, '\0');
      return in.read(&magic[0], magic.size()) && magic == "\177ELF";
    }



    // What a library was built for, which plugin_version.cc says; empty where
    // it does not.
    std::string
    version_in(const std::string &file_name)
    {
      const std::string mark = LUMBRICUS_PLUGIN_MARK;
      std::ifstream     in   = open_input_file(file_name);
      for (std::string text; std::getline(in, text, '\0');)
        if (text.compare(0, mark.size(), mark) == 0)
          return text.substr(mark.size());
      return "";
    }



    // Load the library in a file. @return what is wrong, in words that go on
    // after its name; empty if nothing is.
    std::string
    load(const std::string &file_name)
    {
      const std::string unreadable = why_unreadable(file_name);
      if (!unreadable.empty())
        return ", which cannot be read: " + unreadable +
               ". Give the path of a library, from the working directory.";

      // dlopen() has the words for files that are no libraries at all.
      if (is_elf(file_name))
        {
          const std::string version = version_in(file_name);
          if (version.empty())
            return ", which does not say what it was built for." + how_to_build;
          if (version != LUMBRICUS_BUILD_VERSION)
            return ", which was built for " + version +
                   ", but this is " LUMBRICUS_BUILD_VERSION
                   ". Build it anew, with the CMake package of this program.";
        }

      // With a path, so that it is not looked up elsewhere.
      const std::string path = std::filesystem::absolute(file_name).string();
      // The library may be linked with the program, or be listed twice.
      if (dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD) != nullptr)
        return "";
      const std::size_t n_before = registrations().size();
      // Every library has its own names before those of the libraries loaded
      // earlier: two may have a class of the same name.
      if (dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr)
        return std::string(", which cannot be loaded: ") + dlerror() + "." +
               how_to_build;
      if (registrations().size() == n_before)
        return ", which registers nothing: none of its sources has a line "
               "'static const Register<...>'. See doc/extending.md.";
      const std::string clash = clash_of_names(registrations());
      return clash.empty() ? "" :
                             ", but with it " + clash +
                               ". Choose another name, or leave the library "
                               "out.";
    }
  } // namespace



  void
  SharedLibraries::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      entry,
      file_names,
      "Libraries of your own with laws, shapes, fibres, activations, loads and "
      "whatever else can be chosen by name, separated by commas: see "
      "doc/extending.md. A relative path starts at the working directory.",
      dealii::Patterns::List(dealii::Patterns::FileName()));
  }



  void
  SharedLibraries::load(const MPI_Comm comm) const
  {
    for (const std::string &file_name : file_names)
      {
        const std::string wrong = lumbricus::load(file_name);
        const std::string first =
          first_message(wrong.empty() ? "" :
                                        "names '" + file_name + "'" + wrong,
                        comm);
        AssertThrow(first.empty(), ExcParameter(entry, first));
      }
  }



  void
  load_shared_libraries(const ParameterFile &file, const MPI_Comm comm)
  {
    SharedLibraries libraries;
    file.read_ahead(libraries);
    libraries.load(comm);
  }



  void
  check_registrations()
  {
    const std::string clash = clash_of_names(registrations());
    AssertThrow(clash.empty(),
                ExcInput("In this program " + clash +
                         ". Choose another name for one of them."));
  }
} // namespace lumbricus
