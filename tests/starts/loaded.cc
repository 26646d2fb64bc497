// SPDX-License-Identifier: LGPL-2.1-or-later
// The program many times over. Loading its libraries takes eight times as long
// as starting MPI, and longer than most runs of the tests: here that is done
// once, and every run that starter asks for at the socket argv[1] is a fork of
// this process.
//
// It writes a line when it listens, and ends with its standard input.
#include <lumbricus/program/run_program.h>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "request.h"

namespace
{
  struct Request
  {
    starts::Header           header;
    starts::Files            files;
    std::vector<std::string> arguments, variables;
  };

  bool
  read_request(const int connection, Request &request)
  {
    starts::Header &header = request.header;
    if (!starts::Message(header).receive(connection, request.files))
      return false;
    std::string texts(header.n_bytes, '\0');
    if (recv(connection, texts.data(), texts.size(), MSG_WAITALL) !=
        ssize_t(texts.size()))
      return false;
    std::size_t at   = 0;
    const auto  take = [&](const std::uint64_t n, auto &list) {
      for (std::uint64_t i = 0; i < n; ++i, at += list.back().size() + 1)
        list.emplace_back(texts.c_str() + at);
    };
    take(header.n_arguments, request.arguments);
    take(header.n_variables, request.variables);
    return true;
  }



  // In the child: the run, as if the program had been started by starter.
  int
  run(Request &request)
  {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_NAME, "lumbricus");
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      if (dup2(request.files[stream], stream) != stream)
        return EXIT_FAILURE;
    if (fchdir(request.files[3]) != 0)
      return EXIT_FAILURE;
    for (const int file : request.files)
      close(file);
    setrlimit(RLIMIT_AS, &request.header.memory);
    clearenv();
    for (std::string &variable : request.variables)
      putenv(variable.data());

    std::vector<char *> arguments;
    for (std::string &argument : request.arguments)
      arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    return lumbricus::run_program(arguments.size() - 1, arguments.data());
  }



  // A run that has not ended: its process, what tells of its end, and the
  // starter that waits for it.
  struct Child
  {
    pid_t id;
    int   end, connection;
  };
} // namespace

int
main(int argc, char *argv[])
{
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (argc != 2 || std::strlen(argv[1]) >= sizeof(address.sun_path))
    return EXIT_FAILURE;
  std::strcpy(address.sun_path, argv[1]);
  const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (bind(listener,
           reinterpret_cast<const sockaddr *>(&address),
           sizeof(address)) != 0 ||
      listen(listener, 64) != 0 || write(STDOUT_FILENO, "\n", 1) != 1)
    return EXIT_FAILURE;

  std::vector<Child> children;
  while (true)
    {
      std::vector<pollfd> events = {{STDIN_FILENO, POLLIN, 0},
                                    {listener, POLLIN, 0}};
      for (const Child &child : children)
        {
          events.push_back({child.end, POLLIN, 0});
          events.push_back({child.connection, POLLIN, 0});
        }
      if (poll(events.data(), events.size(), -1) < 0)
        return EXIT_FAILURE;
      // The children end with this process.
      if (events[0].revents != 0)
        return EXIT_SUCCESS;

      std::vector<Child> running;
      for (std::size_t i = 0; i < children.size(); ++i)
        if (const Child &child = children[i]; events[2 + 2 * i].revents != 0)
          {
            int status = 0;
            waitpid(child.id, &status, 0);
            send(child.connection, &status, sizeof(status), MSG_NOSIGNAL);
            close(child.connection);
            close(child.end);
          }
        else
          {
            // Starters say nothing more: this one has been killed.
            if (events[3 + 2 * i].revents != 0)
              kill(child.id, SIGKILL);
            running.push_back(child);
          }
      children = running;

      if (events[1].revents == 0)
        continue;
      const int connection = accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
      if (Request request; read_request(connection, request))
        {
          const pid_t child = fork();
          if (child == 0)
            {
              close(listener);
              close(connection);
              for (const Child &other : children)
                {
                  close(other.connection);
                  close(other.end);
                }
              return run(request);
            }
          for (const int file : request.files)
            close(file);
          children.push_back(
            {child, int(syscall(SYS_pidfd_open, child, 0)), connection});
        }
      else
        close(connection);
    }
}
