// SPDX-License-Identifier: LGPL-2.1-or-later
#include "controller_socket.h"

#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/interruption.h>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <sstream>

namespace lumbricus
{
  ControllerSocket::~ControllerSocket()
  {
    if (socket != -1)
      close(socket);
  }



  std::string
  ControllerSocket::connect(const std::string &path)
  {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket == -1 ||
        ::connect(socket,
                  reinterpret_cast<const sockaddr *>(&address),
                  sizeof(address)) == -1)
      return std::strerror(errno);
    return "";
  }



  ControllerSocket::Reply
  ControllerSocket::ask(const std::string &line, const double seconds)
  {
    using Clock = std::chrono::steady_clock;
    // How often signals are looked for.
    constexpr int milliseconds = 50;
    const auto    start        = Clock::now();
    std::string   to_send      = line + "\n";
    Reply         reply;
    if (!received.empty())
      {
        reply.fault = "said something before it was asked";
        return reply;
      }
    while (true)
      {
        const auto end = received.find('\n');
        if (end != std::string::npos)
          {
            reply.line = received.substr(0, end);
            received.erase(0, end + 1);
            return reply;
          }
        if (received.size() > InputLimits::bytes)
          {
            reply.fault = "answered with a line that does not end";
            return reply;
          }
        if (is_interrupted())
          {
            reply.interrupted = true;
            return reply;
          }
        if (std::chrono::duration<double>(Clock::now() - start).count() >
            seconds)
          {
            std::ostringstream text;
            text << "did not answer within " << seconds << " s";
            reply.fault = text.str();
            return reply;
          }
        pollfd waiting{socket,
                       static_cast<short>(to_send.empty() ? POLLIN :
                                                            POLLIN | POLLOUT),
                       0};
        if (poll(&waiting, 1, milliseconds) <= 0)
          continue;
        std::array<char, 65536> part;
        const auto n_read = recv(socket, part.data(), part.size(), 0);
        if (n_read > 0)
          received.append(part.data(), n_read);
        else if (n_read == 0 || (errno != EAGAIN && errno != EINTR))
          {
            reply.fault = "has ended, or closed the connection, before it "
                          "answered";
            return reply;
          }
        if (!to_send.empty() && (waiting.revents & POLLOUT) != 0)
          to_send.erase(0,
                        std::max<ssize_t>(0,
                                          send(socket,
                                               to_send.data(),
                                               to_send.size(),
                                               MSG_NOSIGNAL)));
      }
  }
} // namespace lumbricus
