// SPDX-License-Identifier: LGPL-2.1-or-later

#include "extrusion.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria_description.h>

#include "round_axis.h"

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int x_axis = 0;



    BodySurface
    surface_of(const CrossSection::Side side)
    {
      switch (side)
        {
          case CrossSection::Side::outer:
            return BodySurface::outer;
          case CrossSection::Side::inner:
            return BodySurface::inner;
          case CrossSection::Side::symmetry_y:
            return BodySurface::symmetry_y;
          case CrossSection::Side::symmetry_z:
            return BodySurface::symmetry_z;
          case CrossSection::Side::interior:
            break;
        }
      Assert(false, dealii::ExcMessage("A free face inside the section."));
      return BodySurface::outer;
    }



    // A part of the body without cells that a cell borders on.
    struct Emptiness
    {
      bool         exists = false;
      unsigned int slab   = 0;
    };



    // What is behind a free face of a cell. The first four faces of a
    // hexahedron lie over the lines of its quad, in their order; the other two
    // are its ends.
    Emptiness
    emptiness_behind(const CrossSection::Quad &quad,
                     const unsigned int        slab,
                     const unsigned int        n_slabs,
                     const unsigned int        face)
    {
      if (face < 4)
        return {quad.sides[face] == CrossSection::Side::interior, slab};
      if (face == 4)
        return {slab > 0, slab - 1};
      return {slab + 1 < n_slabs, slab + 1};
    }



    BodySurface
    surface_of(const CrossSection::Quad &quad, const unsigned int face)
    {
      return face < 4 ? surface_of(quad.sides[face]) :
                        (face == 4 ? BodySurface::head : BodySurface::tail);
    }
  } // namespace



  void
  extrude(const CrossSection              &section,
          const std::vector<AxialStation> &stations,
          const RegionOfCell              &region,
          const BoundaryOfFace            &boundary,
          dealii::Triangulation<dim>      &triangulation)
  {
    Assert(stations.size() >= 2, dealii::ExcMessage("At least one slab."));

    const std::vector<CrossSection::Quad> &quads   = section.quads();
    const unsigned int                     n_slabs = stations.size() - 1;

    std::vector<dealii::Point<dim>> vertices;
    vertices.reserve(stations.size() * section.n_vertices());
    for (const AxialStation &station : stations)
      for (unsigned int v = 0; v < section.n_vertices(); ++v)
        {
          const dealii::Point<2> p = section.position(v, station.radii);
          vertices.emplace_back(station.x, p[0], p[1]);
        }

    // The local directions (in the section, in the section, x) are as
    // right-handed as (y, z, x).
    std::vector<dealii::CellData<dim>> cells;
    cells.reserve(n_slabs * quads.size());
    struct Place
    {
      unsigned int              slab;
      const CrossSection::Quad &quad;
    };
    std::vector<Place> places; // of the cells
    for (unsigned int slab = 0; slab < n_slabs; ++slab)
      for (const CrossSection::Quad &quad : quads)
        {
          const auto in_region = region(slab, quad.ring);
          if (!in_region)
            continue;
          dealii::CellData<dim> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell.vertices[v] =
              quad.vertices[v % 4] + (slab + v / 4) * section.n_vertices();
          cell.material_id = in_region->material_id();
          cells.push_back(cell);
          places.push_back({slab, quad});
        }

    dealii::SubCellData surfaces;
    dealii::GridTools::delete_unused_vertices(vertices, cells, surfaces);
    triangulation.create_triangulation(vertices, cells, surfaces);

    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        const auto &[slab, quad] = places[cell->index()];
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            {
              const Emptiness empty = emptiness_behind(quad, slab, n_slabs, f);
              cell->face(f)->set_boundary_id(
                empty.exists ?
                  boundary(BodySurface::chamber, quad.ring, empty.slab) :
                  boundary(surface_of(quad, f), quad.ring, slab));
            }
        // A cell of the wall passes its manifold on to the faces that it
        // shares with the disk.
        if (quad.ring > 0)
          cell->set_all_manifold_ids(cylindrical_manifold_id);
      }
    triangulation.set_manifold(cylindrical_manifold_id,
                               dealii::CylindricalManifold<dim>(x_axis));
  }
} // namespace lumbricus
