// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>

#include <set>
#include <sstream>

namespace lumbricus
{
  std::string
  about_parameter(const std::string &path, const std::string &what)
  {
    return "Parameter '" + path + "'" +
           (what.compare(0, 1, ":") == 0 ? "" : " ") + what;
  }



  void
  check_no_name_twice(const std::string              &parameter,
                      const std::vector<std::string> &names)
  {
    std::set<std::string> taken;
    for (const std::string &name : names)
      AssertThrow(taken.insert(name).second,
                  ExcParameter(parameter,
                               "has '" + name +
                                 "' twice. Leave one of them out."));
  }



  bool
  is_thrown_on_all_ranks(const dealii::ExceptionBase &exception)
  {
    return dynamic_cast<const ExcInput *>(&exception) != nullptr ||
           dynamic_cast<const ExcNotConverged *>(&exception) != nullptr ||
           dynamic_cast<const ExcSolveFailed *>(&exception) != nullptr;
  }



  std::string
  plain_message(const dealii::ExceptionBase &exception)
  {
    std::ostringstream text;
    exception.print_info(text);

    // print_info() indents by four blanks and ends with a line feed.
    std::string message = text.str();
    const auto  begin   = message.find_first_not_of(" \n");
    const auto  end     = message.find_last_not_of(" \n");
    return begin == std::string::npos ? "" :
                                        message.substr(begin, end - begin + 1);
  }



  std::string
  first_message(const std::string &message, const MPI_Comm comm)
  {
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
    const unsigned int rank    = dealii::Utilities::MPI::this_mpi_process(comm);
    const unsigned int first =
      dealii::Utilities::MPI::min(message.empty() ? n_ranks : rank, comm);
    return first == n_ranks ?
             "" :
             dealii::Utilities::MPI::broadcast(comm, message, first);
  }
} // namespace lumbricus
