// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/available_memory.h>

#include <deal.II/base/utilities.h>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace lumbricus
{
  namespace
  {
    double
    megabytes_of_machine()
    {
      std::ifstream file("/proc/meminfo");
      std::string   line;
      while (std::getline(file, line))
        if (line.rfind("MemAvailable:", 0) == 0)
          return std::stod(line.substr(line.find(':') + 1)) / 1024.;
      return std::numeric_limits<double>::infinity();
    }



    double
    megabytes_of_process()
    {
      dealii::Utilities::System::MemoryStats memory;
      dealii::Utilities::System::get_memory_stats(memory);
      return std::max(0., address_space_limit() - memory.VmSize / 1024.);
    }
  } // namespace



  double
  address_space_limit()
  {
    rlimit limit;
    return getrlimit(RLIMIT_AS, &limit) == 0 &&
               limit.rlim_cur != RLIM_INFINITY ?
             limit.rlim_cur / 1024. / 1024. :
             std::numeric_limits<double>::infinity();
  }



  double
  available_megabytes(const MPI_Comm comm)
  {
    MPI_Comm machine;
    MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(machine);
    MPI_Comm_free(&machine);
    return dealii::Utilities::MPI::min(
      std::min(megabytes_of_machine() / n_ranks, megabytes_of_process()), comm);
  }
} // namespace lumbricus
