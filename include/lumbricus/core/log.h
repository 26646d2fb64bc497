// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_log_h
#define lumbricus_core_log_h

#include <lumbricus/core/interruption.h>
#include <lumbricus/core/standard_output.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>

namespace lumbricus
{
  /** What the program says: to the terminal, unless that is to be quiet, and to
   * a file, from rank 0. */
  class Log
  {
  public:
    /** Write to the terminal unless @p quiet, and detail() only where
     * @p verbose; show progress() there where it is watched, or
     * @p with_progress. */
    Log(const MPI_Comm comm,
        const bool     quiet,
        const bool     verbose,
        const bool     with_progress)
      : active(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      , verbose(verbose)
      , on_terminal(active && !quiet)
      , shows_progress(on_terminal && (with_progress || is_watched()))
    {}

    /** From now on write to this file too, at its end where @p append.
     * @return why that is not possible; empty if it is, and on other ranks. */
    std::string
    open(const std::string &file_name, const bool append)
    {
      if (!active)
        return "";
      file.open(file_name, append ? std::ios::app : std::ios::out);
      return file.is_open() ? "" : std::strerror(errno);
    }

    /** Write @p item at once. Does nothing on ranks other than 0. */
    template <typename T>
    Log &
    operator<<(const T &item)
    {
      if (active)
        {
          std::ostringstream text;
          text << item;
          if (on_terminal)
            {
              progress("");
              say(text.str());
            }
          if (file.is_open())
            file << text.str() << std::flush;
        }
      return *this;
    }

    /** Write @p message to the file only: the terminal has it from what is
     * thrown with it, which ends the run. */
    void
    note(const std::string &message)
    {
      if (active && file.is_open())
        file << message << std::flush;
    }

    /** Say @p line where details are wanted (--verbose). */
    void
    detail(const std::string &line)
    {
      if (verbose)
        *this << "        " << line << "\n";
    }

    /** What is wrong where something has not reached a standard output that
     * somebody reads; empty where all has, and on other ranks. */
    std::string
    lost_output() const
    {
      return lost ? output_cannot_be_written : "";
    }

    /** What to say where the standard output cannot be written. */
    static constexpr const char *output_cannot_be_written =
      "Standard output cannot be written. See where it goes, and whether there "
      "is space.";

    /** Show @p line at the end of the output, in place of the last one: only
     * where somebody looks at it, or where it was asked for; never in files. */
    void
    progress(const std::string &line)
    {
      if (!shows_progress || line == shown)
        return;
      // Back to the first column, and clear the line.
      say("\r\033[K" + line);
      shown = line;
    }

  private:
    /** Write to the standard output. Where nobody reads it any more that is
     * noted; where it cannot be written otherwise (a full disk) the file, if
     * there is one, has all of it. */
    void
    say(const std::string &text)
    {
      const int error = standard_output.write(text);
      if (error == EPIPE)
        note_closed_output();
      else if (error != 0 && error != ETIMEDOUT)
        lost = true;
    }

    /** Whether standard output is a terminal. Under mpirun it always looks like
     * one, wherever that writes to. */
    static bool
    is_watched()
    {
      return isatty(STDOUT_FILENO) &&
             std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr &&
             std::getenv("PMI_SIZE") == nullptr;
    }

    const bool     active;
    const bool     verbose;
    const bool     on_terminal;
    const bool     shows_progress;
    StandardOutput standard_output;
    std::ofstream  file;
    std::string    shown;
    bool           lost = false; ///< something that was to be said
  };
} // namespace lumbricus

#endif
