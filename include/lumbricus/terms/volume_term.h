// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_volume_term_h
#define lumbricus_terms_volume_term_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /** What a body force may depend on, at a point of the body. */
  struct VolumePoint
  {
    dealii::Point<dim>     X; ///< position at rest [mm]
    dealii::Tensor<1, dim> u; ///< displacement [mm]
    LoadTime               t; ///< time
    /** Mass per reference volume, of the tissue [t/mm^3]. */
    double density = 0.;
  };



  /** The force b per reference volume and its exact derivative. */
  struct VolumeResponse
  {
    dealii::Tensor<1, dim> b;     ///< [N/mm^3]
    dealii::Tensor<2, dim> db_du; ///< [N/mm^4]

    /** Whether the derivative is there at all. */
    bool
    depends_on_place() const
    {
      return db_du.norm_square() > 0.;
    }
  };



  /** A term of the residual in tissues, -int b . du dV: a force on all of their
   * points. */
  class VolumeTerm : public PartOfBody
  {
  public:
    /** All expressions, tried at the start over the time of the run and looked
     * at between load steps. */
    virtual std::vector<Expression>
    expressions() const
    {
      return {};
    }

    /** Set the force and its derivative in @p response, which is zero before,
     * at @p point. */
    virtual void
    volume(const VolumePoint &point, VolumeResponse &response) const = 0;

    /** The acceleration g that liquids are under at @p t, as a potential of the
     * volume that they fill then [mm/s^2]: zero but for a weight. The points of
     * the mesh inside a liquid are not its points, so that no other force can
     * act there. */
    virtual dealii::Tensor<1, dim>
    gravity(const LoadTime & /*t*/) const
    {
      return dealii::Tensor<1, dim>();
    }

    /** Whether the derivative keeps the matrix symmetric. */
    virtual bool
    symmetric() const
    {
      return true;
    }
  };
} // namespace lumbricus

#endif
