// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_scales_h
#define lumbricus_discretization_surface_scales_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/terms/surface_term.h>

#include <deal.II/base/types.h>

#include <map>

namespace lumbricus
{
  /** What each part of the boundary of @p body may measure lengths and stresses
   * by: the same on all ranks, whatever the mesh is refined to. */
  std::map<dealii::types::boundary_id, SurfaceScale>
  surface_scales(const Body &body);
} // namespace lumbricus

#endif
