// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/measures/mesh_quality.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_nodes;

    // Derivatives along the axes of the cell, at its nodes: the three nodes of
    // the line through a node, and what they weigh, on each axis.
    class NodeDerivatives
    {
    public:
      NodeDerivatives()
      {
        const dealii::FE_Q<dim> fe(MixedSpace::degree);
        for (unsigned int n = 0; n < n_nodes; ++n)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int m = 0; m < n_nodes; ++m)
              {
                const double weight =
                  fe.shape_grad(m, fe.unit_support_point(n))[k];
                if (std::abs(weight) > 1e-10)
                  entries[n][k].push_back({m, weight});
              }
      }

      // dx/dxi_k at node n.
      dealii::Tensor<1, dim>
      derivative(const NodePositions &x,
                 const unsigned int   n,
                 const unsigned int   k) const
      {
        dealii::Tensor<1, dim> result;
        for (const auto &[m, weight] : entries[n][k])
          result += weight * x[m];
        return result;
      }

    private:
      std::array<std::array<std::vector<std::pair<unsigned int, double>>, dim>,
                 n_nodes>
        entries;
    };
  } // namespace



  double
  scaled_jacobian(const NodePositions &x)
  {
    static const NodeDerivatives nodes;
    double                       least = 1.;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        dealii::Tensor<2, dim> directions;
        for (unsigned int k = 0; k < dim; ++k)
          {
            const auto   direction = nodes.derivative(x, n, k);
            const double length    = direction.norm();
            if (!(length > 0.))
              return 0.;
            directions[k] = direction / length;
          }
        least = std::min(least, determinant(directions));
      }
    return least;
  }



  std::vector<MeshQuality>
  mesh_qualities(const Body &body, const Vector *relevant_solution)
  {
    const MixedSpace        &space = body.space;
    std::vector<MeshQuality> qualities(body.anatomy.geometry().n_segments());
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    NodePositions x;
    for (const OwnedCell cell : body.owned_cells())
      {
        cell.iterator->get_dof_indices(indices);
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            x[n] = body.shapes.node(cell.index, n);
            if (relevant_solution != nullptr)
              for (unsigned int c = 0; c < dim; ++c)
                x[n][c] +=
                  (*relevant_solution)(indices[space.displacement_dof[c][n]]);
          }
        MeshQuality &of    = qualities[cell.region.segment];
        double      &least = cell.is_liquid ? of.liquid : of.wall;
        least              = std::min(least, scaled_jacobian(x));
      }

    std::vector<double> worst;
    for (const MeshQuality &of : qualities)
      worst.insert(worst.end(), {of.liquid, of.wall});
    dealii::Utilities::MPI::min(worst, space.communicator(), worst);
    for (unsigned int s = 0; s < qualities.size(); ++s)
      qualities[s] = {worst[2 * s], worst[2 * s + 1]};
    return qualities;
  }
} // namespace lumbricus
