// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry point of every unit test program: GoogleTest under MPI.
#include <lumbricus/core/mpi_session.h>

#include <gtest/gtest.h>

int
main(int argc, char **argv)
{
  const lumbricus::MpiSession session(argv[0]);
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
