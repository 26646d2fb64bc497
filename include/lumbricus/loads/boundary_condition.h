// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_loads_boundary_condition_h
#define lumbricus_loads_boundary_condition_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/core/parameter_owner.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a surface load may depend on, at a point of the boundary. */
  struct SurfacePoint
  {
    dealii::Point<dim>     X; ///< position at rest [mm]
    dealii::Tensor<1, dim> N; ///< outward normal at rest
    dealii::Tensor<1, dim> u; ///< displacement [mm]
    dealii::Tensor<2, dim> F; ///< deformation gradient
    LoadTime               t; ///< time
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
   * What acts on a named part of the boundary: a traction that may follow
   * the deformation, prescribed displacements, or both.
   */
  class BoundaryCondition : public ParameterOwner
  {
  public:
    /**
     * Read the expressions. @param name the full name of the section, for
     * messages. Throws ExcInput.
     */
    virtual void
    initialize(const std::string &name) = 0;

    /** All expressions, tried at the start over the time of the run. Those of a
     * condition that acts on the surface are looked at between load steps
     * too. */
    virtual std::vector<Expression>
    expressions() const = 0;

    /** Whether surface() has to be asked. */
    virtual bool
    acts_on_surface() const
    {
      return false;
    }

    /** Set the traction and its derivatives in @p response, which is zero
     * before, at @p point. */
    virtual void
    surface(const SurfacePoint & /*point*/,
            SurfaceResponse & /*response*/) const
    {}

    /** Whether the tangent of surface() keeps the matrix symmetric. */
    virtual bool
    symmetric() const
    {
      return true;
    }

    /** Which displacement components are prescribed. */
    virtual std::array<bool, dim>
    prescribed_components() const
    {
      return {{false, false, false}};
    }

    /** The prescribed displacement [mm]. */
    virtual double
    prescribed_displacement(const unsigned int /*component*/,
                            const dealii::Point<dim> & /*X*/,
                            const double /*t*/) const
    {
      return 0.;
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
  };
} // namespace lumbricus

#endif
