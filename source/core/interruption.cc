// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/interruption.h>

#include <algorithm>
#include <csignal>

namespace lumbricus
{
  namespace
  {
    volatile std::sig_atomic_t signal_received = 0;
    unsigned int               n_uninterrupted = 0;

    void
    note(const int signal)
    {
      signal_received = signal;
    }
  } // namespace



  void
  watch_for_interruption()
  {
    std::signal(SIGTERM, note);
    std::signal(SIGUSR1, note);
  }



  void
  throw_if_interrupted(const MPI_Comm comm)
  {
    if (n_uninterrupted > 0)
      return;
    const int received =
      dealii::Utilities::MPI::max(static_cast<int>(signal_received), comm);
    AssertThrow(received == 0,
                ExcInterrupted(std::string("Interrupted by ") +
                               (received == SIGTERM ? "SIGTERM" : "SIGUSR1") +
                               "."));
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
