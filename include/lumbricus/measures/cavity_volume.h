// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_cavity_volume_h
#define lumbricus_measures_cavity_volume_h

#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  // The volume inside the wall S around a cavity with the normal n out of it,
  // by the divergence theorem:
  //
  //   V = int_S v . n da,   v = (x - x_0)/3,   or   v = (0, y, z)/2
  //
  // where pistons close it: they are planes x = const, at which v . n = 0, so
  // that their rims need no terms of their own. At planes of symmetry, which
  // have x_0 in them, v . n = 0 too.

  /** da where @p surface is, at the wall around a cavity: the area vector
   * cof(F) N dA out of the cavity, which is into the wall [mm^2]. */
  dealii::Tensor<1, dim>
  area_out_of_cavity(const SurfaceKernel &surface);

  /** What the point adds to the volume inside @p wall, v . n da [mm^3]. */
  double
  volume_in_cavity(const SurfaceKernel &surface, const CavityWall &wall);

  /**
   * Add dV/du where @p surface is to @p of_cell, by CellUnknowns:
   *
   *   dV = int du . n da                                    with a wall all around,
   *   dV = int (du_y n_y + du_z n_z)/2 da + int v . d(n da)       between pistons.
   *
   * Between pistons this is what S adds to dV for any du, and thus also what the
   * pressure does to the pistons, as forces on their rims: a plane rim that moves
   * by du_x makes room for du_x times the area inside.
   */
  void
  add_volume_derivative(const SurfaceKernel &surface,
                        const CavityWall    &wall,
                        double              *of_cell);

  /**
   * Add @p factor times d^2V/du^2 where @p surface is to @p matrix, that of a cell
   * by rows. Between pistons it is symmetric as it stands; with a wall all around
   * see add_area_derivative().
   */
  void
  add_volume_second_derivative(const SurfaceKernel &surface,
                               const CavityWall    &wall,
                               const double         factor,
                               std::vector<double> &matrix);
} // namespace lumbricus

#endif
