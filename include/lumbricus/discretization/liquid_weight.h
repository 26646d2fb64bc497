// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_liquid_weight_h
#define lumbricus_discretization_liquid_weight_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/terms/body_forces.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace lumbricus
{
  /**
   * The weight of the liquids, in chambers with cells and without. What is in
   * chamber k has the potential
   *
   *   Pi = -int_Vk rho g . (x - c_k) dv,   dPi = -int_Sk q n . du da,
   *   q  = rho g . (x - c_k),
   *
   * which hangs on the surface S_k of the volume alone, with the normal n out of
   * it, and not on where the nodes of a mesh inside are. So the pressure that is
   * computed, uniform in a chamber, is that at c_k, the centre of the chamber at
   * rest, and the one at x is greater by q. The resultant is rho g V_k. On faces
   * of degree 2, 4 x 4 points integrate both exactly, and the second derivative is
   * symmetric as a whole.
   */
  class LiquidWeight
  {
  public:
    /** The density of what is in the chamber of a segment, from zero
     * [t/mm^3]. */
    using Density = std::function<double(const unsigned int)>;

    /** Called with the number of the body force, the gravity rho g [N/mm^3], q
     * [N/mm^2] and 1 or -1, whether cof(F) N of point() points out of the
     * chamber. */
    using Listener = std::function<void(const unsigned int,
                                        const dealii::Tensor<1, dim> &,
                                        const double,
                                        const double)>;

    /** All but @p density are kept by reference. */
    LiquidWeight(const Body       &body,
                 const BodyForces &forces,
                 const Density    &density);

    /** After every change of the mesh. Collective. */
    void
    reinit();

    /** Throws ExcInput where a chamber ends at pistons and has a weight at one of
     * @p times. */
    void
    check_pistons(const std::vector<double> &times) const;

    /** From now on loads are those at @p t. */
    void
    set_time(const LoadTime &t);

    /** Whether there is a weight at that time. */
    bool
    any() const;

    /** Whether it acts on faces of @p cell. */
    bool
    acts_on(const OwnedCell &cell) const;

    /** Call @p listener at the quadrature points of all faces of @p cell at a
     * liquid with weight, for every weight, at the displacements @p u, [i][n]. */
    void
    visit(const OwnedCell &cell,
          const double (&u)[dim][ShapeCache::padded_nodes],
          const Listener &listener);

    /** Where the listener is called. */
    const SurfaceKernel &
    point() const
    {
      return surface;
    }

    /** The acceleration of body force @p i at @p t, if that acts on liquids. */
    dealii::Tensor<1, dim>
    gravity(const unsigned int i, const LoadTime &t) const;

    /** A chamber at rest, of the part of the body that is computed. */
    struct Chamber
    {
      double             density = 0.; ///< [t/mm^3]
      double             volume  = 0.; ///< [mm^3]
      dealii::Point<dim> centre;       ///< c_k [mm]
    };

    /** That of every segment; without a volume where it has no liquid. */
    const std::vector<Chamber> &
    chambers() const
    {
      return of_segment;
    }

    /** The same of every segment as it is at @p relevant_solution, a ghosted
     * vector, or at rest where that is null: there also where nothing has
     * weight. Collective. */
    std::vector<Chamber>
    chambers_at(const Vector *relevant_solution);

    /** q at @p x, in the liquid of segment @p segment, of all weights. */
    double
    excess(const unsigned int segment, const dealii::Point<dim> &x) const;

    /** The mean of q over the liquid of every segment as it is at
     * @p relevant_solution, a ghosted vector. Collective. */
    std::vector<double>
    mean_excess(const Vector &relevant_solution);

  private:
    /** The chamber that face @p f of @p cell is at, and the sign of its normal;
     * sign 0 where it is at none. */
    struct Side
    {
      unsigned int segment;
      double       sign;
    };

    Side
    side(const OwnedCell &cell, const unsigned int f) const;

    /** For every segment the volume, and the integral of x over it, at
     * @p relevant_solution, or at rest where that is null. */
    std::vector<std::array<double, 1 + dim>>
    moments(const Vector *relevant_solution);

    const Body           body;
    const BodyForces    &forces;
    const Density        density;
    CavityFaces          cavities;
    /** Around these. */
    const std::vector<CavityWall> walls;
    SurfaceKernel        surface;
    std::vector<bool>    is_symmetry_plane; // by boundary
    std::vector<Chamber> of_segment;
    /** Of all body forces, now. */
    std::vector<dealii::Tensor<1, dim>> gravities;
  };
} // namespace lumbricus

#endif
