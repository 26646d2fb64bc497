// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_available_memory_h
#define lumbricus_core_available_memory_h

#include <deal.II/base/mpi.h>

namespace lumbricus
{
  /** How many addresses this process may have ('ulimit -v') [MB]; infinite
   * where there is no limit. */
  double
  address_space_limit();

  /**
   * What a rank can still allocate [MB]: the memory that its machine has
   * available, shared among the ranks there, or what its own limit leaves; of
   * all ranks the least. Infinite where the system does not say. Collective.
   */
  double
  available_megabytes(const MPI_Comm comm);
} // namespace lumbricus

#endif
