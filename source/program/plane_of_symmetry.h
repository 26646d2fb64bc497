// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_plane_of_symmetry_h
#define lumbricus_program_plane_of_symmetry_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/fe/fe_values.h>

#include <sstream>
#include <string>

namespace lumbricus
{
  /** A plane of symmetry x_d = c. */
  struct PlaneOfSymmetry
  {
    /** As much as this, relative to the whole, goes without saying. */
    static constexpr double tolerance = 1e-4;

    unsigned int               direction; ///< d
    dealii::types::boundary_id boundary;  ///< its id
    double                     c;         ///< [mm]

    /** What messages call it. */
    std::string
    name() const
    {
      std::ostringstream out;
      out << "the plane of symmetry "
          << "xyz"[direction] << " = " << c;
      return out.str();
    }

    /** How to do without the check, for messages about fibres. */
    static std::string
    way_without_check()
    {
      return " Where the other half is to have the mirror image of these "
             "fibres, set 'Boundary conditions/Check symmetry' to false.";
    }
  };



  /** Call @p function(cell, face) at every face of this rank's on the surface of
   * the mesh. */
  template <typename Function>
  void
  for_each_boundary_face(const MixedSpace &space, const Function &function)
  {
    for (const auto &cell : space.owned_cells())
      if (cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            function(cell, face);
  }



  /** Call @p function(region, X) at points X of @p plane, in this rank's cells. An
   * ExcInput of it is of no direction right there: fibres in cells are asked
   * elsewhere. */
  template <typename Function>
  void
  for_each_point_of(const PlaneOfSymmetry &plane,
                    const MixedSpace      &space,
                    const Function        &function)
  {
    dealii::FEFaceValues<dim> face_values(space.mapping,
                                          space.fe,
                                          space.face_quadrature,
                                          dealii::update_quadrature_points);
    for_each_boundary_face(space, [&](const auto &cell, const auto &face) {
      if (face->boundary_id() != plane.boundary)
        return;
      face_values.reinit(mesh_cell(cell), face);
      for (const unsigned int q : face_values.quadrature_point_indices())
        try
          {
            dealii::Point<dim> X = face_values.quadrature_point(q);
            X[plane.direction]   = plane.c;
            function(Region::of(cell->material_id()), X);
          }
        catch (const ExcInput &)
          {}
    });
  }
} // namespace lumbricus

#endif
