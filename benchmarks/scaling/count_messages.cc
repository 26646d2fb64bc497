// SPDX-License-Identifier: LGPL-2.1-or-later
// What this rank sends is counted on its way: the program has the functions of MPI
// that libraries call, from C and from Fortran, and hands on to MPI's own second
// names of them. A rank alone sends nothing.
#include "count_messages.h"

#include <mpi.h>

namespace lumbricus
{
  Sent sent;



  namespace
  {
    // The size of n entries where comm has more than one rank, or -1.
    double
    bytes_to_others(const int n, const MPI_Datatype type, const MPI_Comm comm)
    {
      int size, n_ranks;
      PMPI_Type_size(type, &size);
      PMPI_Comm_size(comm, &n_ranks);
      return n_ranks > 1 ? double(n) * size : -1.;
    }

    // A message.
    void
    count_message(const int n, const MPI_Datatype type, const MPI_Comm comm)
    {
      const double bytes = bytes_to_others(n, type, comm);
      if (bytes >= 0.)
        {
          ++sent.messages;
          sent.bytes += bytes;
        }
    }

    // A call of all ranks.
    void
    count_collective(const int n, const MPI_Datatype type, const MPI_Comm comm)
    {
      const double bytes = bytes_to_others(n, type, comm);
      if (bytes >= 0.)
        {
          ++sent.collectives;
          sent.collective_bytes += bytes;
        }
    }
  } // namespace
} // namespace lumbricus

extern "C"
{
  // Of some ranks only: nothing else calls it in an iteration.
  int
  MPI_Allgatherv(const void  *from,
                 int          n,
                 MPI_Datatype type,
                 void        *to,
                 const int   *counts,
                 const int   *offsets,
                 MPI_Datatype to_type,
                 MPI_Comm     comm)
  {
    int rank;
    PMPI_Comm_rank(comm, &rank);
    const double bytes =
      lumbricus::bytes_to_others(counts[rank], to_type, comm);
    if (bytes >= 0.)
      {
        ++lumbricus::sent.shared;
        lumbricus::sent.shared_bytes += bytes;
      }
    return PMPI_Allgatherv(
      from, n, type, to, counts, offsets, to_type, comm);
  }

  int
  MPI_Send(const void *data, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm)
  {
    lumbricus::count_message(n, type, comm);
    return PMPI_Send(data, n, type, to, tag, comm);
  }

  int
  MPI_Isend(const void  *data,
            int          n,
            MPI_Datatype type,
            int          to,
            int          tag,
            MPI_Comm     comm,
            MPI_Request *request)
  {
    lumbricus::count_message(n, type, comm);
    return PMPI_Isend(data, n, type, to, tag, comm, request);
  }

  int
  MPI_Allreduce(const void  *from,
                void        *to,
                int          n,
                MPI_Datatype type,
                MPI_Op       op,
                MPI_Comm     comm)
  {
    lumbricus::count_collective(n, type, comm);
    return PMPI_Allreduce(from, to, n, type, op, comm);
  }

  int
  MPI_Reduce(const void  *from,
             void        *to,
             int          n,
             MPI_Datatype type,
             MPI_Op       op,
             int          root,
             MPI_Comm     comm)
  {
    lumbricus::count_collective(n, type, comm);
    return PMPI_Reduce(from, to, n, type, op, root, comm);
  }

  int
  MPI_Bcast(void *data, int n, MPI_Datatype type, int root, MPI_Comm comm)
  {
    lumbricus::count_collective(n, type, comm);
    return PMPI_Bcast(data, n, type, root, comm);
  }

  int
  MPI_Barrier(MPI_Comm comm)
  {
    lumbricus::count_collective(0, MPI_BYTE, comm);
    return PMPI_Barrier(comm);
  }

  int
  MPI_Gatherv(const void  *from,
              int          n,
              MPI_Datatype type,
              void        *to,
              const int   *counts,
              const int   *offsets,
              MPI_Datatype to_type,
              int          root,
              MPI_Comm     comm)
  {
    lumbricus::count_collective(n, type, comm);
    return PMPI_Gatherv(
      from, n, type, to, counts, offsets, to_type, root, comm);
  }

  int
  MPI_Scatterv(const void  *from,
               const int   *counts,
               const int   *offsets,
               MPI_Datatype type,
               void        *to,
               int          n,
               MPI_Datatype to_type,
               int          root,
               MPI_Comm     comm)
  {
    lumbricus::count_collective(n, to_type, comm);
    return PMPI_Scatterv(
      from, counts, offsets, type, to, n, to_type, root, comm);
  }

  // MUMPS is in Fortran.
  void
  pmpi_send_(void *, int *, MPI_Fint *, int *, int *, MPI_Fint *, int *);
  void
  pmpi_isend_(void *, int *, MPI_Fint *, int *, int *, MPI_Fint *, MPI_Fint *, int *);
  void
  pmpi_bcast_(void *, int *, MPI_Fint *, int *, MPI_Fint *, int *);
  void
  pmpi_reduce_(void *, void *, int *, MPI_Fint *, MPI_Fint *, int *, MPI_Fint *, int *);
  void
  pmpi_allreduce_(void *, void *, int *, MPI_Fint *, MPI_Fint *, MPI_Fint *, int *);

  void
  mpi_send_(void *data, int *n, MPI_Fint *type, int *to, int *tag, MPI_Fint *comm, int *error)
  {
    lumbricus::count_message(*n, MPI_Type_f2c(*type), MPI_Comm_f2c(*comm));
    pmpi_send_(data, n, type, to, tag, comm, error);
  }

  void
  mpi_isend_(void     *data,
             int      *n,
             MPI_Fint *type,
             int      *to,
             int      *tag,
             MPI_Fint *comm,
             MPI_Fint *request,
             int      *error)
  {
    lumbricus::count_message(*n, MPI_Type_f2c(*type), MPI_Comm_f2c(*comm));
    pmpi_isend_(data, n, type, to, tag, comm, request, error);
  }

  void
  mpi_bcast_(void *data, int *n, MPI_Fint *type, int *root, MPI_Fint *comm, int *error)
  {
    lumbricus::count_collective(*n, MPI_Type_f2c(*type), MPI_Comm_f2c(*comm));
    pmpi_bcast_(data, n, type, root, comm, error);
  }

  void
  mpi_reduce_(void     *from,
              void     *to,
              int      *n,
              MPI_Fint *type,
              MPI_Fint *op,
              int      *root,
              MPI_Fint *comm,
              int      *error)
  {
    lumbricus::count_collective(*n, MPI_Type_f2c(*type), MPI_Comm_f2c(*comm));
    pmpi_reduce_(from, to, n, type, op, root, comm, error);
  }

  void
  mpi_allreduce_(void     *from,
                 void     *to,
                 int      *n,
                 MPI_Fint *type,
                 MPI_Fint *op,
                 MPI_Fint *comm,
                 int      *error)
  {
    lumbricus::count_collective(*n, MPI_Type_f2c(*type), MPI_Comm_f2c(*comm));
    pmpi_allreduce_(from, to, n, type, op, comm, error);
  }
}
