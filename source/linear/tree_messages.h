// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_tree_messages_h
#define lumbricus_linear_tree_messages_h

#include <deal.II/base/mpi.h>

#include <vector>

namespace lumbricus
{
  /** Lists that ranks send to each other along the RankTree, of lengths that both
   * know. */
  class TreeMessages
  {
  public:
    /** Of the same numbers for all messages of this library. */
    enum Direction
    {
      up   = 2011, ///< to the root
      down = 2012  ///< from there
    };

    /** Among the ranks of @p comm. */
    explicit TreeMessages(const MPI_Comm comm)
      : comm(comm)
    {}

    /** Wait until all is sent. */
    ~TreeMessages()
    {
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    }

    TreeMessages(const TreeMessages &) = delete;
    TreeMessages &
    operator=(const TreeMessages &) = delete;

    /** To several ranks. The values have to stay until the end of this object. */
    template <typename Number>
    void
    send(const std::vector<Number>       &values,
         const std::vector<unsigned int> &to,
         const Direction                  direction)
    {
      if (values.empty())
        return;
      for (const unsigned int rank : to)
        {
          requests.emplace_back();
          MPI_Isend(values.data(),
                    values.size(),
                    type_of(values.data()),
                    rank,
                    direction,
                    comm,
                    &requests.back());
        }
    }

    /** As many as there is room for. */
    template <typename Number>
    void
    receive(std::vector<Number> &values,
            const unsigned int   from,
            const Direction      direction) const
    {
      if (!values.empty())
        MPI_Recv(values.data(),
                 values.size(),
                 type_of(values.data()),
                 from,
                 direction,
                 comm,
                 MPI_STATUS_IGNORE);
    }

  private:
    static MPI_Datatype
    type_of(const float *)
    {
      return MPI_FLOAT;
    }

    static MPI_Datatype
    type_of(const unsigned int *)
    {
      return MPI_UNSIGNED;
    }

    const MPI_Comm           comm;
    std::vector<MPI_Request> requests;
  };
} // namespace lumbricus

#endif
