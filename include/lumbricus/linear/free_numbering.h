// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_free_numbering_h
#define lumbricus_linear_free_numbering_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A consecutive numbering, over all ranks, of the free unknowns that a
   * factorisation works with: all of them, or those that cells share.
   */
  class FreeNumbering
  {
  public:
    FreeNumbering() = default;

    /** As reinit(). Collective. */
    FreeNumbering(const CellUnknowns &unknowns,
                  const bool          with_private,
                  const MPI_Comm      comm)
    {
      reinit(unknowns, with_private, comm);
    }

    /** One for a part of a matrix: the unknown at a place of a vector has the
     * number @p number_at, and what belongs to the rank first is at
     * @p owned_places, in ascending order; there are @p n numbers. */
    FreeNumbering(std::vector<unsigned int> number_at,
                  std::vector<unsigned int> owned_places,
                  const unsigned int        n)
      : number_at(std::move(number_at))
      , owned_places(std::move(owned_places))
      , n(n)
    {}

    /** Anew when the constraints are new. Collective. */
    void
    reinit(const CellUnknowns &unknowns,
           const bool          with_private,
           const MPI_Comm      comm);

    /** Of those unknowns whose entry of @p used, which has places for ghost
     * entries, is more than 0. Collective. */
    void
    reinit(const Vector &used, const MPI_Comm comm);

    /** The number of the free unknown at @p place of a vector. */
    unsigned int
    number(const unsigned int place) const
    {
      return number_at[place];
    }

    /** Whether the owned entry at @p place has a number. */
    bool
    is_numbered(const unsigned int place) const
    {
      return std::binary_search(owned_places.begin(),
                                owned_places.end(),
                                place);
    }

    /** Copy the numbered entries that this rank owns from a vector. */
    template <typename Number>
    void
    extract(const Vector &x, std::vector<Number> &values) const
    {
      values.resize(owned_places.size());
      for (unsigned int k = 0; k < owned_places.size(); ++k)
        values[k] = static_cast<Number>(x.local_element(owned_places[k]));
    }

    /** Copy them to a vector. */
    template <typename Number>
    void
    insert(const std::vector<Number> &values, Vector &x) const
    {
      for (unsigned int k = 0; k < owned_places.size(); ++k)
        x.local_element(owned_places[k]) = values[k];
    }

    /** The places of the unknowns with a number that this rank owns, in their
     * order. */
    const std::vector<unsigned int> &
    places() const
    {
      return owned_places;
    }

    /** How many of them there are. */
    unsigned int
    n_owned() const
    {
      return owned_places.size();
    }

    /** Of all ranks. */
    unsigned int
    size() const
    {
      return n;
    }

  private:
    /** Number the owned places that are @p numbered, for vectors like
     * @p layout. Collective. */
    void
    number(const std::vector<bool> &numbered,
           const Vector            &layout,
           const MPI_Comm           comm);

    std::vector<unsigned int> number_at;
    std::vector<unsigned int> owned_places;
    unsigned int              n = 0;
  };
} // namespace lumbricus

#endif
