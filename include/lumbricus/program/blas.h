// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_blas_h
#define lumbricus_program_blas_h

#include <string>

namespace lumbricus
{
  /**
   * Prepare the environment OpenBLAS reads when it is loaded, and start the
   * program anew in it where it was not so: one thread per rank, and the
   * AVX-512 kernels on processors that older versions do not know by name.
   * What the user has set stays. To be called first.
   */
  void
  prepare_blas(char *const argv[]);

  /**
   * A warning where the reference BLAS is loaded, with which the direct solver
   * is about eight times slower; else empty.
   */
  std::string
  blas_warning();
} // namespace lumbricus

#endif
