// SPDX-License-Identifier: LGPL-2.1-or-later
// write_msh CASE.prm VERSION FILE.msh: the coarse mesh of a case as a file of
// Gmsh, for tests that compute the same body both ways.
#include "../write_msh.h"

#include <lumbricus/core/mpi_session.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/program/run_parameters.h>

int
main(int, char *argv[])
{
  const lumbricus::MpiSession session(argv[0]);
  lumbricus::ParameterFile    file;
  lumbricus::RunParameters    parameters;
  file.read(argv[1]);
  file.parse(parameters);
  lumbricus::write_msh(argv[3], argv[2], parameters.anatomy.geometry());
}
