// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cavity_faces_h
#define lumbricus_discretization_cavity_faces_h

#include <lumbricus/discretization/body.h>

#include <cstddef>
#include <vector>

namespace lumbricus
{
  /** Which faces are around which cavity: Geometry::cavities() by boundary. */
  class CavityFaces
  {
  public:
    /** Where no cavity is. */
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** Those of @p geometry. */
    explicit CavityFaces(const Geometry &geometry)
    {
      for (const CavityWall &wall : geometry.cavities())
        {
          if (of_boundary.size() <= wall.boundary)
            of_boundary.resize(wall.boundary + 1, none);
          of_boundary[wall.boundary] = n_cavities++;
        }
    }

    /** How many cavities there are. */
    unsigned int
    size() const
    {
      return n_cavities;
    }

    /** The cavity at face @p face of @p cell, or none. */
    unsigned int
    at(const OwnedCell &cell, const unsigned int face) const
    {
      if (!cell.iterator->at_boundary(face))
        return none;
      const auto id = cell.iterator->face(face)->boundary_id();
      return id < of_boundary.size() ? of_boundary[id] : none;
    }

    /** Call @p function(cell, face, cavity) for all faces of the owned cells of
     * @p body that are at one. */
    template <typename Function>
    void
    for_each(const Body &body, const Function &function) const
    {
      if (n_cavities > 0)
        for (const OwnedCell cell : body.owned_cells())
          if (cell.iterator->at_boundary())
            for (const unsigned int f : cell.iterator->face_indices())
              {
                const unsigned int k = at(cell, f);
                if (k != none)
                  function(cell, f, k);
              }
    }

  private:
    unsigned int              n_cavities = 0;
    std::vector<unsigned int> of_boundary; // cavities
  };
} // namespace lumbricus

#endif
