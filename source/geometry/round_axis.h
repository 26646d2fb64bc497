// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_round_axis_h
#define lumbricus_geometry_round_axis_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>
#include <string>

namespace lumbricus
{
  /** Of all that is round about an axis, of which a mesh has one. */
  constexpr dealii::types::manifold_id cylindrical_manifold_id = 1;



  /** The line that surfaces of revolution are round about. */
  class RoundAxis
  {
  public:
    /**
     * From "x", "y", "z", for the axes through the origin, or from
     * "px, py, pz; dx, dy, dz", a point [mm] and a direction. Throws ExcInput
     * naming @p parameter where @p text is neither.
     */
    RoundAxis(const std::string &parameter, const std::string &text);

    /** The distance of @p X from it [mm]. */
    double
    radius(const dealii::Point<dim> &X) const;

    /** How far along it @p X is [mm]. */
    double
    along(const dealii::Point<dim> &X) const;

    /**
     * How far the face with these corners, in any order, is from one of a
     * surface of revolution about the axis, relative to its size: whether
     * corners at one place along the axis have one radius, and whether all of
     * them are on a line in the plane of radius and axis. Both are exact in a
     * mesh of rings, the second is not in an irregular mesh of a surface whose
     * profile is curved.
     */
    struct Deviation
    {
      double of_radius;  ///< largest difference of radii in a section
      double of_profile; ///< half the width of the strip around the corners
    };

    /** See Deviation. */
    Deviation
    deviation(const std::array<dealii::Point<dim>, 4> &corners) const;

    /** A point on it [mm]. */
    dealii::Point<dim> point;
    /** Of length one. */
    dealii::Tensor<1, dim> direction;
    /** "the z axis", for messages. */
    std::string name;
  };
} // namespace lumbricus

#endif
