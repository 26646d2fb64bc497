// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_rank_group_h
#define lumbricus_linear_rank_group_h

#include <deal.II/base/mpi.h>

#include <exception>
#include <vector>

namespace lumbricus
{
  /** What of a list one of several has. */
  struct PartOfList
  {
    /** Of @p size entries, number @p i of @p n. */
    PartOfList(const unsigned int size, const unsigned int i, const unsigned int n)
      : first(static_cast<unsigned long long>(size) * i / n)
      , end(static_cast<unsigned long long>(size) * (i + 1) / n)
    {}

    /** How many entries it has. */
    unsigned int
    size() const
    {
      return end - first;
    }

    unsigned int first; ///< its first entry
    unsigned int end;   ///< the one behind its last
  };



  /** Some ranks that compute a list together, each the part that follows the
   * one before. All of them make it, go through its functions and end it. */
  class RankGroup
  {
  public:
    /** Of these @p ranks of @p comm, in their order. */
    RankGroup(const MPI_Comm comm, const std::vector<unsigned int> &ranks)
      : n_ranks(ranks.size())
    {
      const std::vector<int> numbers(ranks.begin(), ranks.end());
      MPI_Group              all, these;
      MPI_Comm_group(comm, &all);
      MPI_Group_incl(all, n_ranks, numbers.data(), &these);
      MPI_Comm_create_group(comm, these, 2013, &group_comm);
      i_own = dealii::Utilities::MPI::this_mpi_process(group_comm);
      MPI_Group_free(&these);
      MPI_Group_free(&all);
    }

    ~RankGroup()
    {
      // It takes all of them, and after an error the others may not be here.
      if (std::uncaught_exceptions() == 0)
        MPI_Comm_free(&group_comm);
    }

    /** How many ranks these are. */
    unsigned int
    size() const
    {
      return n_ranks;
    }

    /** Which of them this is. */
    unsigned int
    own() const
    {
      return i_own;
    }

    /** Let all have the @p values of number @p i of them. */
    void
    tell(std::vector<float> &values, const unsigned int i) const
    {
      MPI_Bcast(values.data(), values.size(), MPI_FLOAT, i, group_comm);
    }

    RankGroup(const RankGroup &) = delete;
    RankGroup &
    operator=(const RankGroup &) = delete;

    /** Each has computed its part of the @p n entries from @p values on, of so
     * many numbers; then all have all. */
    void
    gather(float             *values,
           const unsigned int n,
           const unsigned int n_numbers = 1) const
    {
      if (n == 0 || n_numbers == 0)
        return;
      std::vector<int> sizes, firsts;
      for (unsigned int i = 0; i < n_ranks; ++i)
        {
          const PartOfList part(n, i, n_ranks);
          sizes.push_back(part.size() * n_numbers);
          firsts.push_back(part.first * n_numbers);
        }
      MPI_Allgatherv(MPI_IN_PLACE,
                     0,
                     MPI_FLOAT,
                     values,
                     sizes.data(),
                     firsts.data(),
                     MPI_FLOAT,
                     group_comm);
    }

  private:
    const unsigned int n_ranks;
    unsigned int       i_own;
    MPI_Comm           group_comm;
  };
} // namespace lumbricus

#endif
