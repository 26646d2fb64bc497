// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_program_h
#define lumbricus_program_run_program_h

namespace lumbricus
{
  /**
   * The whole program, with MPI and all messages: what main() does, also in a
   * program that adds laws, shapes, fibres or loads of its own (examples/).
   * The parts that the program is linked with register themselves.
   * @return the exit code, see ExitCode.
   */
  int
  run_program(int argc, char *argv[]);
} // namespace lumbricus

#endif
