// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/standard_output.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace lumbricus
{
  // O_NONBLOCK set on the standard output itself would be set for all who share
  // it, the shell too. Files and sockets are left as they are, and so is what
  // cannot be written: it is not to be opened for that.
  StandardOutput::StandardOutput()
  {
    const int   mode   = fcntl(STDOUT_FILENO, F_GETFL);
    struct stat status = {};
    if (mode != -1 && (mode & O_ACCMODE) != O_RDONLY &&
        fstat(STDOUT_FILENO, &status) == 0 &&
        (S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode)))
      own = open("/proc/self/fd/1",
                 O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  }



  StandardOutput::~StandardOutput()
  {
    if (own >= 0)
      close(own);
  }



  int
  StandardOutput::write(const std::string &text)
  {
    const int   file = own >= 0 ? own : STDOUT_FILENO;
    std::size_t done = 0;
    while (done < text.size())
      {
        const auto n = ::write(file, text.data() + done, text.size() - done);
        if (n > 0)
          done += n;
        else if (n == 0 || (errno == EAGAIN && !wait()))
          return ETIMEDOUT;
        else if (errno != EAGAIN && errno != EINTR)
          return errno;
      }
    return 0;
  }



  // A terminal can be ready and take nothing: it wants room for two characters
  // where a line ends.
  bool
  StandardOutput::wait()
  {
    constexpr int patience = 1000, pause = 100, breath = 5; // milliseconds
    if (waited >= patience)
      return false;
    pollfd     file     = {own, POLLOUT, 0};
    const bool is_ready = poll(&file, 1, pause) > 0;
    if (is_ready)
      std::this_thread::sleep_for(std::chrono::milliseconds(breath));
    if (is_interrupted())
      waited += is_ready ? breath : pause;
    return true;
  }
} // namespace lumbricus
