// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/volume_terms.h>

namespace lumbricus
{
  VolumeTerms::VolumeTerms(const Body &body, const BodyForces &forces)
    : body(body)
    , forces(forces)
  {}



  bool
  VolumeTerms::act_in(const OwnedCell &cell) const
  {
    for (unsigned int k = 0; k < forces.n_forces(); ++k)
      if (forces.force(k).acts_in[cell.region.tissue])
        return true;
    return false;
  }



  bool
  VolumeTerms::symmetric() const
  {
    return forces.symmetric();
  }



  void
  VolumeTerms::visit(const OwnedCell &cell,
                     const double (&u)[dim][ShapeCache::padded_nodes],
                     const LoadTime &t,
                     const Listener &listener) const
  {
    const auto shape = body.shapes.cell(cell.index);
    for (unsigned int k = 0; k < forces.n_forces(); ++k)
      {
        if (!forces.force(k).acts_in[cell.region.tissue])
          continue;
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            VolumePoint at;
            at.X = body.shapes.quadrature_point(cell.index, q);
            at.t = t;
            at.density = cell.tissue.density();
            Point point;
            point.JxW    = shape.JxW[q];
            point.values = body.shapes.node_values(q);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                at.u[c] += u[c][n] * point.values[n];
            point.x = at.X + at.u;
            VolumeResponse response;
            forces.force(k).type->volume(at, response);
            listener(k, point, response);
          }
      }
  }
} // namespace lumbricus
