// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/available_memory.h>
#include <lumbricus/core/out_of_memory.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>
#include <new>
#include <sstream>

namespace lumbricus
{
  bool
  is_out_of_memory(const std::exception &exception)
  {
    return dynamic_cast<const std::bad_alloc *>(&exception) != nullptr ||
           dynamic_cast<const dealii::StandardExceptions::ExcOutOfMemory *>(
             &exception) != nullptr;
  }



  double
  bytes_asked_for(const std::exception &exception)
  {
    // deal.II's exception has the number in its text only.
    const auto *known =
      dynamic_cast<const dealii::StandardExceptions::ExcOutOfMemory *>(
        &exception);
    if (known == nullptr)
      return 0.;
    const std::string text  = plain_message(*known);
    const auto        begin = text.find_first_of("0123456789");
    return begin == std::string::npos ?
             0. :
             std::strtod(text.c_str() + begin, nullptr);
  }



  std::string
  out_of_memory_message(const double       bytes,
                        const unsigned int rank,
                        const MPI_Comm     comm)
  {
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
    std::ostringstream message;
    message << "Out of memory";
    if (n_ranks > 1)
      message << " on rank " << rank << " of " << n_ranks;
    if (bytes > 0.)
      message << ": " << std::ceil(bytes / 1e5) / 10.
              << " MB more were asked for";
    message << ". Take fewer cells ('Mesh/Global refinements', 'Adaptivity'), "
               "ranks on more machines, or 'Linear solver/Method' = "
               "'multigrid', which needs least memory.";
    return message.str();
  }



  std::string
  memory_in_use()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    std::ostringstream words;
    words << "The program has " << memory.VmSize / 1024 << " MB of addresses, "
          << memory.VmRSS / 1024 << " MB of them in use";
    const double limit = address_space_limit();
    if (std::isfinite(limit))
      words << "; 'ulimit -v' allows " << std::round(limit) << " MB";
    words << ".";
    return words.str();
  }
} // namespace lumbricus
