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
    /** The segment it is of, from zero. */
    unsigned int segment = 0;
  };



  /** What a part of the boundary may measure lengths and stresses by: those of
   * the coarse mesh behind it. */
  struct SurfaceScale
  {
    double thickness     = 1.; ///< of the thinnest cell, along the normal [mm]
    double shear_modulus = 1.; ///< of the stiffest cell, mu [N/mm^2]
  };



  /** The traction T per reference area and its exact derivatives. */
  struct SurfaceResponse
  {
    dealii::Tensor<1, dim> T;     ///< [N/mm^2]
    dealii::Tensor<2, dim> dT_du; ///< [N/mm^3]
    /** [i][k][L] = dT_i/dF_kL */
    dealii::Tensor<3, dim> dT_dF;
    /** Whether the point is held by something that would give way. */
    bool sticks = false;
    /** To be added to dT_du where no point of the body sticks, so that the
     * tangent has an inverse [N/mm^3]. */
    dealii::Tensor<2, dim> stabilisation;

    /** Whether the derivatives are there at all. */
    bool
    depends_on_shape() const
    {
      return dT_du.norm_square() > 0. || dT_dF.norm_square() > 0. ||
             stabilisation.norm_square() > 0.;
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
     * The directions in which the surface is held elastically at @p point, at
     * rest: with the constraints, these keep the body from moving rigidly.
     */
    virtual std::vector<dealii::Tensor<1, dim>>
    elastic_directions(const SurfacePoint & /*point*/) const
    {
      return {};
    }

    /** Directions that the traction may have at @p point when the body has moved,
     * where it has none at rest: none of them may be across a plane of
     * symmetry. */
    virtual std::vector<dealii::Tensor<1, dim>>
    possible_directions(const SurfacePoint & /*point*/) const
    {
      return {};
    }

    /** Called once, when there is a mesh: what lengths and stresses may be
     * measured by. */
    virtual void
    set_scale(const SurfaceScale & /*scale*/)
    {}

    /** Whether the traction is bounded, so that the residual does not say how far
     * the body is from equilibrium: the line search looks at work then. */
    virtual bool
    may_slide() const
    {
      return false;
    }

    /** By how much what slides pulls back when a node at @p point moves on by
     * @p du: (T(u) - T(u + du)) . du of the forces that are bounded, with their
     * bounds as they are at the point. */
    virtual double
    pull_back(const SurfacePoint & /*point*/,
              const dealii::Tensor<1, dim> & /*du*/) const
    {
      return 0.;
    }

    /** Whether the traction is zero where no load step is under way
     * (SurfacePoint::dt), since it depends on a speed. */
    virtual bool
    depends_on_rate() const
    {
      return false;
    }

    /** What a point of the surface does. */
    enum class Regime
    {
      free,   ///< nothing
      sticks, ///< hangs on to something
      slides  ///< is pulled along
    };

    /** What @p point does; for messages. */
    virtual Regime
    regime(const SurfacePoint & /*point*/) const
    {
      return Regime::free;
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
     * F of @p point, which its faces do not share, are not there. At rest, before
     * the first step, too.
     */
    virtual void
    remember(const SurfacePoint & /*point*/,
             dealii::Tensor<1, dim> & /*history*/) const
    {}

    /** Whether the solution with a node at @p point is as good as it has to be.
     * Where it is not, the node is augmented, and the same load is solved for
     * again. */
    virtual bool
    is_augmented(const SurfacePoint & /*point*/) const
    {
      return true;
    }

    /** Change @p history so that the solution gets better: see is_augmented().
     * @return how far the node will move then, about, from where Newton's method
     * begins [mm]. */
    virtual dealii::Tensor<1, dim>
    augment(const SurfacePoint & /*point*/,
            dealii::Tensor<1, dim> & /*history*/) const
    {
      return {};
    }
  };
} // namespace lumbricus

#endif
