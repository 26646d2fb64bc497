// SPDX-License-Identifier: LGPL-2.1-or-later
// To be called like the program, by itself or under mpirun: lets the process
// that listens at the socket STARTED_BY, which has the libraries already, do
// the run with the arguments, the environment, the working folder and the
// standard streams and the limit on memory of this one, and ends as it does. Where this process is
// killed the run is, too.
#include "request.h"

#include <fcntl.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace
{
  [[noreturn]] void
  fail(const char *const what)
  {
    perror(what);
    std::exit(EXIT_FAILURE);
  }
} // namespace

int
main(int argc, char *argv[])
{
  const char *const place = std::getenv("STARTED_BY");
  sockaddr_un       address{};
  address.sun_family = AF_UNIX;
  if (place == nullptr || std::strlen(place) >= sizeof(address.sun_path))
    fail("STARTED_BY");
  std::strcpy(address.sun_path, place);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (connect(socket,
              reinterpret_cast<const sockaddr *>(&address),
              sizeof(address)) != 0)
    fail(place);

  starts::Header header;
  std::string    texts;
  for (int i = 0; i < argc; ++i, ++header.n_arguments)
    texts.append(argv[i]).push_back('\0');
  for (char **at = environ; *at != nullptr; ++at, ++header.n_variables)
    texts.append(*at).push_back('\0');
  header.n_bytes = texts.size();
  getrlimit(RLIMIT_AS, &header.memory);

  const starts::Files files = {{STDIN_FILENO,
                                STDOUT_FILENO,
                                STDERR_FILENO,
                                open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)}};
  if (!starts::Message(header).send(socket, files) ||
      send(socket, texts.data(), texts.size(), MSG_NOSIGNAL) !=
        ssize_t(texts.size()))
    fail("starter");

  int status = 0;
  if (recv(socket, &status, sizeof(status), MSG_WAITALL) != sizeof(status))
    fail("starter: the process that does the runs has ended");
  if (WIFSIGNALED(status))
    {
      std::signal(WTERMSIG(status), SIG_DFL);
      raise(WTERMSIG(status));
    }
  return WEXITSTATUS(status);
}
