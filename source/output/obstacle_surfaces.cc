// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/output/obstacle_surfaces.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    // Around the nodes, and their images in planes of symmetry.
    dealii::BoundingBox<dim>
    box_around(const Body &body, const State &state)
    {
      const Vector        relevant = body.space.with_ghosts(state.solution);
      std::vector<double> low(dim, std::numeric_limits<double>::max());
      std::vector<double> high(dim, std::numeric_limits<double>::lowest());
      ElementKernel       kernel;
      std::vector<dealii::types::global_dof_index> indices(
        body.space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : body.owned_cells())
        {
          kernel.read(body.space, cell.iterator, relevant, indices);
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              {
                const double x =
                  body.shapes.node(cell.index, n)[c] + kernel.u[c][n];
                low[c]  = std::min(low[c], x);
                high[c] = std::max(high[c], x);
              }
        }
      const MPI_Comm comm = body.space.communicator();
      dealii::Utilities::MPI::min(low, comm, low);
      dealii::Utilities::MPI::max(high, comm, high);
      for (const SymmetryPlane &plane :
           body.anatomy.geometry().symmetry_planes())
        {
          const unsigned int d = plane.direction;
          const double       p = plane.position(body.space.triangulation);
          const double       a = low[d], b = high[d];
          low[d]  = std::min(a, 2. * p - b);
          high[d] = std::max(b, 2. * p - a);
        }
      dealii::Point<dim> first, last;
      for (unsigned int c = 0; c < dim; ++c)
        {
          first[c] = low[c];
          last[c]  = high[c];
        }
      return dealii::BoundingBox<dim>({first, last});
    }



    // A 1, 2 or 5 in front of zeros, about a twentieth of the body at rest.
    double
    spacing_for(const Geometry &geometry)
    {
      const double wanted = geometry.length() / 20.;
      const double power = std::pow(10., std::floor(std::log10(wanted)));
      for (const double digit : {5., 2.})
        if (digit * power <= wanted)
          return digit * power;
      return power;
    }
  } // namespace



  std::vector<Obstacle::Surface>
  obstacle_surfaces(const Body               &body,
                    const BoundaryConditions &conditions,
                    const State              &state)
  {
    std::vector<Obstacle::Surface> surfaces;
    if (!has_contact(conditions))
      return surfaces;
    const auto   box     = box_around(body, state);
    const double spacing = spacing_for(body.anatomy.geometry());
    for (const Contact *contact : contacts_of(conditions))
      if (contact != nullptr)
        surfaces.push_back(
          contact->obstacle().surface(state.time, box, spacing));
    return surfaces;
  }
} // namespace lumbricus
