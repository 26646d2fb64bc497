// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_benchmarks_count_messages_h
#define lumbricus_benchmarks_count_messages_h

namespace lumbricus
{
  /** What a rank has sent so far. */
  struct Sent
  {
    double messages         = 0; ///< to one other rank
    double bytes            = 0; ///< in these
    double collectives      = 0; ///< calls that all ranks make together
    double collective_bytes = 0; ///< what this rank has for them
    double shared           = 0; ///< calls of ranks that share a front
    double shared_bytes     = 0; ///< what this rank has for them

    /** What was sent after @p other. */
    Sent
    operator-(const Sent &other) const
    {
      return {messages - other.messages,
              bytes - other.bytes,
              collectives - other.collectives,
              collective_bytes - other.collective_bytes,
              shared - other.shared,
              shared_bytes - other.shared_bytes};
    }
  };

  /** Counted by the functions of MPI in count_messages.cc. */
  extern Sent sent;
} // namespace lumbricus

#endif
