// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_controller_socket_h
#define lumbricus_continuation_controller_socket_h

#include <string>

namespace lumbricus
{
  /** The connection to a controller at a Unix socket, which gets lines and
   * answers each with a line. On one rank. */
  class ControllerSocket
  {
  public:
    /** Without a connection. */
    ControllerSocket() = default;

    /** Ends the connection, which tells the controller that the run is over. */
    ~ControllerSocket();

    ControllerSocket(const ControllerSocket &) = delete;
    ControllerSocket &
    operator=(const ControllerSocket &) = delete;

    /** Connect to the socket at @p path. @return why not, else empty. */
    std::string
    connect(const std::string &path);

    /** What came back. */
    struct Reply
    {
      std::string line;  ///< without its end
      std::string fault; ///< why there is none, as "did not answer within 60 s"
      bool        interrupted = false; ///< is_interrupted(), while waiting
    };

    /** Send @p line, which has no end, and wait for the reply, but not longer
     * than @p seconds and not where the run is interrupted. */
    Reply
    ask(const std::string &line, const double seconds);

  private:
    int         socket = -1;
    std::string received;
  };
} // namespace lumbricus

#endif
