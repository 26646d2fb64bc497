// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/free_numbering.h>

#include <deal.II/base/mpi.h>

namespace lumbricus
{
  void
  FreeNumbering::reinit(const CellUnknowns &unknowns,
                        const bool          with_private,
                        const MPI_Comm      comm)
  {
    std::vector<bool> numbered = unknowns.is_constrained();
    numbered.flip();
    if (!with_private)
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        {
          const auto of_cell = unknowns.free_unknowns(i);
          for (unsigned int k = 0; k < CellUnknowns::n_private; ++k)
            numbered[of_cell[k]] = false;
        }

    Vector layout;
    unknowns.reinit_vector(layout);
    number(numbered, layout, comm);
  }



  void
  FreeNumbering::reinit(const Vector &used, const MPI_Comm comm)
  {
    std::vector<bool> numbered;
    for (unsigned int place = 0; place < used.locally_owned_size(); ++place)
      numbered.push_back(used.local_element(place) > 0.);
    number(numbered, used, comm);
  }



  void
  FreeNumbering::number(const std::vector<bool> &numbered,
                        const Vector            &layout,
                        const MPI_Comm           comm)
  {
    owned_places.clear();
    for (unsigned int place = 0; place < numbered.size(); ++place)
      if (numbered[place])
        owned_places.push_back(place);
    const unsigned int n_owned = owned_places.size();

    unsigned int first = 0;
    MPI_Exscan(&n_owned, &first, 1, MPI_UNSIGNED, MPI_SUM, comm);
    n = dealii::Utilities::MPI::sum(n_owned, comm);

    // The other ranks' numbers come as ghost entries; doubles hold them
    // exactly.
    Vector numbers;
    numbers.reinit(layout);
    for (unsigned int k = 0; k < n_owned; ++k)
      numbers.local_element(owned_places[k]) = first + k;
    numbers.update_ghost_values();
    number_at.resize(numbers.get_partitioner()->locally_owned_size() +
                     numbers.get_partitioner()->n_ghost_indices());
    for (unsigned int place = 0; place < number_at.size(); ++place)
      number_at[place] =
        static_cast<unsigned int>(numbers.local_element(place) + 0.5);
  }
} // namespace lumbricus
