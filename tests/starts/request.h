// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_starts_request_h
#define lumbricus_tests_starts_request_h

#include <sys/resource.h>
#include <sys/socket.h>

#include <array>
#include <cstdint>
#include <cstring>

// What starter sends to loaded: the header, with the files, and then n_bytes
// bytes, in which each argument and after them each variable of the environment
// is ended by a zero byte. The answer is what waitpid() has of the run.
namespace starts
{
  struct Header
  {
    std::uint64_t n_arguments = 0;
    std::uint64_t n_variables = 0;
    std::uint64_t n_bytes     = 0;
    rlimit        memory      = {};
  };

  // Standard input, output and error, and the working folder.
  using Files = std::array<int, 4>;

  // A message of a header and room for the files.
  class Message
  {
  public:
    explicit Message(Header &header)
      : part{&header, sizeof(header)}
    {
      message.msg_iov        = &part;
      message.msg_iovlen     = 1;
      message.msg_control    = room.data();
      message.msg_controllen = room.size();
    }

    Message(const Message &) = delete;
    Message &
    operator=(const Message &) = delete;

    bool
    send(const int socket, const Files &files)
    {
      cmsghdr *const control = CMSG_FIRSTHDR(&message);
      control->cmsg_level    = SOL_SOCKET;
      control->cmsg_type     = SCM_RIGHTS;
      control->cmsg_len      = CMSG_LEN(sizeof(files));
      std::memcpy(CMSG_DATA(control), files.data(), sizeof(files));
      return sendmsg(socket, &message, 0) == ssize_t(part.iov_len);
    }

    bool
    receive(const int socket, Files &files)
    {
      if (recvmsg(socket, &message, MSG_WAITALL) != ssize_t(part.iov_len))
        return false;
      const cmsghdr *const control = CMSG_FIRSTHDR(&message);
      if (control == nullptr || control->cmsg_type != SCM_RIGHTS ||
          control->cmsg_len != CMSG_LEN(sizeof(files)))
        return false;
      std::memcpy(files.data(), CMSG_DATA(control), sizeof(files));
      return true;
    }

  private:
    iovec  part;
    msghdr message = {};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(Files))> room = {};
  };
} // namespace starts

#endif
