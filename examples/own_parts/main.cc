// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/program/before_libraries.h>
#include <lumbricus/program/run_program.h>

int
main(int argc, char *argv[])
{
  return lumbricus::run_program(argc, argv);
}
