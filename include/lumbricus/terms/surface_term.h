// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_surface_term_h
#define lumbricus_terms_surface_term_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/terms/boundary_condition.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** What a traction may depend on, at a point of the boundary. */
  struct SurfacePoint
  {
    dealii::Point<dim>     X; ///< position at rest [mm]
    dealii::Tensor<1, dim> N; ///< outward normal at rest
    dealii::Tensor<1, dim> u; ///< displacement [mm]
    dealii::Tensor<2, dim> F; ///< deformation gradient
    LoadTime               t; ///< time
    /** How much time has passed since the last load step ended; 0 where none is
     * under way. */
    double dt = 0.;
    /** What the point has remembered since then, see SurfaceTerm::remember();
     * zero at first. */
    dealii::Tensor<1, dim> history;
  };



  /** The traction T per reference area and its exact derivatives. */
  struct SurfaceResponse
  {
    dealii::Tensor<1, dim> T;     ///< [N/mm^2]
    dealii::Tensor<2, dim> dT_du; ///< [N/mm^3]
    /** [i][k][L] = dT_i/dF_kL */
    dealii::Tensor<3, dim> dT_dF;

    /** Whether the derivatives are there at all. */
    bool
    depends_on_shape() const
    {
      return dT_du.norm_square() > 0. || dT_dF.norm_square() > 0.;
    }
  };



  /**
   * A term of the residual on a part of the boundary, -int T . du dA: a traction
   * that may follow the deformation, and depend on what the skin has met so
   * far.
   */
  class SurfaceTerm : public virtual BoundaryCondition
  {
  public:
    /** Set the traction and its derivatives in @p response, which is zero
     * before, at @p point. */
    virtual void
    surface(const SurfacePoint &point, SurfaceResponse &response) const = 0;

    /** Whether the derivatives keep the matrix symmetric, at each point. */
    virtual bool
    symmetric() const
    {
      return true;
    }

    /** The formula in t of a pressure that is the same at all points of the
     * deformed surface, else nothing: on a closed surface this keeps the matrix
     * symmetric as a whole. */
    virtual std::string
    uniform_pressure() const
    {
      return "";
    }

    /**
     * The directions in which the surface with normal @p N is held elastically
     * (springs): with the constraints, these keep the body from moving rigidly.
     */
    virtual std::vector<dealii::Tensor<1, dim>>
    elastic_directions(const dealii::Tensor<1, dim> & /*N*/) const
    {
      return {};
    }

    /**
     * Whether points of the skin remember something. Then T is asked for at the
     * nodes, with the weights of Gauss and Lobatto (1, 4 and 16 in 36 on a
     * face), and what a node remembers is one vector, which is part of the
     * State as the displacement is.
     */
    virtual bool
    remembers() const
    {
      return false;
    }

    /**
     * A load step has ended with a node at @p point: change @p history into what
     * it remembers from now on. Called once for a node of a cell, so that N and
     * F of @p point, which its faces do not share, are not there.
     */
    virtual void
    remember(const SurfacePoint & /*point*/,
             dealii::Tensor<1, dim> & /*history*/) const
    {}
  };
} // namespace lumbricus

#endif
