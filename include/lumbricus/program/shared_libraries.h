// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_shared_libraries_h
#define lumbricus_program_shared_libraries_h

#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Libraries of the user's whose laws, shapes, fibres, loads and whatever else
   * registers itself can be chosen by name, as those of the program: the entry
   * 'Additional shared libraries'. They are built by lumbricus_add_plugin() of
   * CMake and stay loaded to the end of the program, since what they register
   * is made, and destroyed, by their code.
   */
  class SharedLibraries : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /**
     * Load them, in their order; those that are loaded are left as they are.
     * Throws ExcInput, on all ranks alike, where a file cannot be read or
     * loaded, was built for another version of this program or of deal.II or
     * as another build type, registers nothing, or registers a name that there
     * is. Collective.
     */
    void
    load(const MPI_Comm comm) const;

  private:
    std::vector<std::string> file_names;
  };

  /**
   * Load the libraries that @p file names. This comes before any parameter is
   * declared, since what there is to choose from hangs on it. Throws ExcInput.
   * Collective.
   */
  void
  load_shared_libraries(const ParameterFile &file, const MPI_Comm comm);

  /** Throw ExcInput where two classes have registered the same name. */
  void
  check_registrations();
} // namespace lumbricus

#endif
