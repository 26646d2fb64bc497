// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_quadratic_cell_h
#define lumbricus_geometry_quadratic_cell_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/derivative_form.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * A hexahedron with curved faces,
   *
   *   X(x) = sum_n N_n(x) X_n,   x in [0, 1]^3,
   *
   * N_n the products of quadratic Lagrange polynomials with nodes at 0, 1/2 and 1.
   * Node n is at x = (i, j, k)/2 with n = i + 3 j + 9 k.
   */
  class QuadraticCell
  {
  public:
    /** How many nodes it has. */
    static constexpr unsigned int n_nodes = 27;
    /** How many of them a face has. */
    static constexpr unsigned int n_face_nodes = 9;
    /** Their positions [mm]. */
    using Nodes = std::array<dealii::Point<dim>, n_nodes>;

    /** With nodes in the order of Gmsh, of which there are 27 or, where nodes on
     * faces and in the middle follow from those on edges, 20 (the serendipity
     * element). */
    static QuadraticCell
    from_gmsh(const std::vector<dealii::Point<dim>> &nodes);

    /** With these nodes. */
    explicit QuadraticCell(const Nodes &nodes);

    /** Multiply all positions by @p factor. */
    void
    scale(const double factor);

    /** The node at x = (i, j, k)/2. */
    const dealii::Point<dim> &
    node(const unsigned int i, const unsigned int j, const unsigned int k) const
    {
      return nodes[i + 3 * j + 9 * k];
    }

    /** Corner number @p v in deal.II's order. */
    const dealii::Point<dim> &
    corner(const unsigned int v) const
    {
      return node(2 * (v & 1), v & 2, (v & 4) / 2);
    }

    /** The nodes of face number @p f in deal.II's order: x_(f/2) = f % 2. */
    std::array<dealii::Point<dim>, n_face_nodes>
    face_nodes(const unsigned int f) const;

    /** X at @p x. */
    dealii::Point<dim>
    at(const dealii::Point<dim> &x) const;

    /** dX_i/dx_j at @p x. */
    dealii::Tensor<2, dim>
    gradient(const dealii::Point<dim> &x) const;

    /** The x in or near the cube with X(x) = @p X, by Newton's method from the
     * nearest node. */
    dealii::Point<dim>
    inverse(const dealii::Point<dim> &X) const;

    /** The X of that among the nodes and Gauss' points, three in a row, where the
     * determinant of the gradient is least, in its sign in the middle; @p least is
     * the determinant, relative to the largest. */
    dealii::Point<dim>
    worst_point(double &least) const;

  private:
    Nodes nodes;
  };



  /** The manifold of a QuadraticCell and of all that it is refined to: charts are
   * x(X). Pieces of a cell are such cells too, so that refinement leaves the shape
   * as it is. */
  class QuadraticManifold : public dealii::ChartManifold<dim>
  {
  public:
    /** Of the cell @p cell. */
    explicit QuadraticManifold(const QuadraticCell &cell)
      : cell(cell)
    {}

    /** See dealii::Manifold. */
    std::unique_ptr<dealii::Manifold<dim>>
    clone() const override
    {
      return std::make_unique<QuadraticManifold>(cell);
    }

    /** x at @p X. */
    dealii::Point<dim>
    pull_back(const dealii::Point<dim> &X) const override
    {
      return cell.inverse(X);
    }

    /** X at @p x. */
    dealii::Point<dim>
    push_forward(const dealii::Point<dim> &x) const override
    {
      return cell.at(x);
    }

    /** dX/dx at @p x. */
    dealii::DerivativeForm<1, dim, dim>
    push_forward_gradient(const dealii::Point<dim> &x) const override
    {
      return dealii::DerivativeForm<1, dim, dim>(cell.gradient(x));
    }

  private:
    const QuadraticCell cell;
  };
} // namespace lumbricus

#endif
