// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry point of every unit test program: GoogleTest under MPI.
#include <lumbricus/core/mpi_session.h>

#include <gtest/gtest.h>

#include <iostream>

int
main(int argc, char **argv)
{
  const lumbricus::MpiSession session(argv[0]);
  ::testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  if (::testing::UnitTest::GetInstance()->test_to_run_count() == 0)
    {
      std::cerr << "No test has a name that was asked for." << std::endl;
      return 1;
    }
  return failed;
}
