// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_area_derivative_h
#define lumbricus_discretization_area_derivative_h

#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/discretization/surface_kernel.h>

#include <vector>

namespace lumbricus
{
  /**
   * Add @p factor times the symmetric part of
   *
   *   int N_n d(cof(F) N)_c / du_m,k dA,
   *   d(cof(F) N)_c / dF_kL = a_c F^(-1)_Lk - a_k F^(-1)_Lc,  a = cof(F) N,
   *
   * at the point where @p surface is, to @p matrix, that of a cell by rows. Over a
   * closed surface the unsymmetric parts add up to zero: this is how the forces of
   * a uniform pressure turn and grow with the surface.
   */
  void
  add_area_derivative(const SurfaceKernel &surface,
                      const double         factor,
                      std::vector<double> &matrix);
} // namespace lumbricus

#endif
