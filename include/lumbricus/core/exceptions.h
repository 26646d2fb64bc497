// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_exceptions_h
#define lumbricus_core_exceptions_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * @defgroup exceptions Exceptions
   * The three ways a run can go wrong that are not bugs. Each carries one
   * message that names what is wrong (parameter, segment, time, value) and
   * what to do about it. All three are thrown on every rank alike.
   * @{
   */

  /** The user's input is wrong: the program ends with exit code 1. */
  DeclException1(ExcInput, std::string, << arg1);

  /** "Parameter '<path>' <what>", or "Parameter '<path>': ..." where @p what
   * begins with a colon. */
  std::string
  about_parameter(const std::string &path, const std::string &what);

  /**
   * The user's input for one parameter is wrong. Its path may still lack the
   * sections that its owner does not know: within_section() puts them in
   * front.
   */
  class ExcParameter : public ExcInput
  {
  public:
    /** The message is what about_parameter() makes of these. */
    ExcParameter(const std::string &path, const std::string &what)
      : ExcInput(about_parameter(path, what))
      , path(path)
      , what_is_wrong(what)
    {}

    /** This exception about a parameter in @p section: its path has that in
     * front. */
    ExcParameter
    in_section(const std::string &section) const
    {
      return ExcParameter(section + "/" + path, what_is_wrong);
    }

    /** What the message says of the parameter. */
    const std::string &
    complaint() const
    {
      return what_is_wrong;
    }

  private:
    std::string path;
    std::string what_is_wrong;
  };

  /** Throw ExcParameter where the list @p parameter has a name twice. */
  void
  check_no_name_twice(const std::string              &parameter,
                      const std::vector<std::string> &names);

  /** Run @p check; an ExcParameter it throws is about this section. */
  template <typename Check>
  void
  within_section(const std::string &section, const Check &check);

  /**
   * Newton's method or the reset iteration did not converge. Load stepping,
   * and nothing else, catches this one and tries a smaller step.
   */
  DeclException1(ExcNotConverged, std::string, << arg1);

  /** The run cannot go on: exit code 2, with the last good state on disk. */
  DeclException1(ExcSolveFailed, std::string, << arg1);

  /** @} */

  /** Whether @p exception is one that is thrown on all ranks: ExcInput,
   * ExcNotConverged or ExcSolveFailed; anything else is a bug. */
  bool
  is_thrown_on_all_ranks(const dealii::ExceptionBase &exception);

  /** The plain message of an exception, without deal.II's frame and trace. */
  std::string
  plain_message(const dealii::ExceptionBase &exception);

  /**
   * Throw @p Exception on every rank if @p message is not empty on any rank;
   * the message is that of the lowest such rank. Collective.
   */
  template <typename Exception>
  void
  throw_on_all_ranks(const std::string &message, const MPI_Comm comm);

  /** The message of the lowest rank that has one, on every rank. Collective. */
  std::string
  first_message(const std::string &message, const MPI_Comm comm);



  template <typename Check>
  void
  within_section(const std::string &section, const Check &check)
  {
    try
      {
        check();
      }
    catch (const ExcParameter &exception)
      {
        AssertThrow(false, exception.in_section(section));
      }
  }



  template <typename Exception>
  void
  throw_on_all_ranks(const std::string &message, const MPI_Comm comm)
  {
    const std::string first = first_message(message, comm);
    AssertThrow(first.empty(), Exception(first));
  }
} // namespace lumbricus

#endif
