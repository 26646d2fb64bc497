// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/interruption.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <iterator>

namespace lumbricus
{
  namespace
  {
    struct Cause
    {
      int         signal;
      const char *words;
    };

    constexpr Cause causes[] = {
      {SIGTERM, "Interrupted by SIGTERM."},
      {SIGINT, "Interrupted by SIGINT (Ctrl-C)."},
      {SIGHUP, "Interrupted by SIGHUP, because the terminal was closed."},
      {SIGUSR1, "Interrupted by SIGUSR1."},
      {SIGPIPE,
       "Interrupted, because the standard output was closed by what read it. "
       "With --quiet, or into a file, the run does not need it."}};

    // A handler may use these: they are free of locks.
    volatile std::sig_atomic_t signal_received = 0;
    std::atomic<std::int64_t>  milliseconds_received{0};
    static_assert(std::atomic<std::int64_t>::is_always_lock_free);
    unsigned int n_uninterrupted = 0;



    std::int64_t
    milliseconds_now()
    {
      std::timespec now = {};
      clock_gettime(CLOCK_MONOTONIC, &now);
      return 1000 * std::int64_t(now.tv_sec) + now.tv_nsec / 1000000;
    }



    void
    note(const int signal)
    {
      constexpr std::int64_t at_once = 1000;
      const int              number  = errno;
      if (signal_received == 0)
        {
          milliseconds_received = milliseconds_now();
          signal_received       = signal;
        }
      else if (milliseconds_now() - milliseconds_received > at_once)
        {
          std::signal(signal, SIG_DFL);
          std::raise(signal); // when this function has ended
        }
      errno = number;
    }



    // Whether each of the causes was ignored when the program started. Written
    // before anything is constructed.
    bool was_ignored[std::size(causes)];
    bool is_noted = false;
  } // namespace



  void
  note_ignored_signals()
  {
    for (unsigned int i = 0; i < std::size(causes); ++i)
      {
        struct sigaction action = {};
        was_ignored[i] = sigaction(causes[i].signal, nullptr, &action) == 0 &&
                         action.sa_handler == SIG_IGN;
      }
    is_noted = true;
  }



  void
  watch_for_interruption()
  {
    if (!is_noted)
      note_ignored_signals();
    for (unsigned int i = 0; i < std::size(causes); ++i)
      if (causes[i].signal != SIGPIPE)
        {
          struct sigaction action = {};
          action.sa_handler       = was_ignored[i] ? SIG_IGN : note;
          action.sa_flags         = SA_RESTART;
          sigfillset(&action.sa_mask);
          sigaction(causes[i].signal, &action, nullptr);
        }
  }



  void
  ignore_closed_output()
  {
    std::signal(SIGPIPE, SIG_IGN);
  }



  bool
  is_interrupted()
  {
    return signal_received != 0;
  }



  void
  note_closed_output()
  {
    if (signal_received != 0)
      return;
    milliseconds_received = milliseconds_now();
    signal_received       = SIGPIPE;
  }



  void
  throw_if_interrupted(const MPI_Comm comm)
  {
    if (n_uninterrupted > 0)
      return;
    const int received =
      dealii::Utilities::MPI::max(static_cast<int>(signal_received), comm);
    for (const Cause &cause : causes)
      AssertThrow(received != cause.signal, ExcInterrupted(cause.words));
  }



  Uninterrupted::Uninterrupted()
  {
    ++n_uninterrupted;
  }



  Uninterrupted::~Uninterrupted()
  {
    --n_uninterrupted;
  }
} // namespace lumbricus
