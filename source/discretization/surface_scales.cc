// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/surface_scales.h>

#include <algorithm>

namespace lumbricus
{
  std::map<dealii::types::boundary_id, SurfaceScale>
  surface_scales(const Body &body)
  {
    // All ranks have all cells of the coarse mesh.
    std::map<dealii::types::boundary_id, SurfaceScale> scales;
    for (const auto &cell : body.space.triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        {
          if (!face->at_boundary())
            continue;
          const SurfaceScale here{
            cell->measure() / face->measure(),
            body.anatomy.tissue(Region::of(cell->material_id()).tissue)
              .shear_modulus()};
          SurfaceScale &scale =
            scales.insert({face->boundary_id(), here}).first->second;
          scale.thickness = std::min(scale.thickness, here.thickness);
          scale.shear_modulus =
            std::max(scale.shear_modulus, here.shear_modulus);
        }
    return scales;
  }
} // namespace lumbricus
