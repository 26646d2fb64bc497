// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavities_h
#define lumbricus_cavities_cavities_h

#include <lumbricus/cavities/cavity_contents.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/border.h>
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/liquid_weight.h>
#include <lumbricus/discretization/surface_kernel.h>

#include <deal.II/dofs/dof_handler.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** What State::globals calls how much is in the chambers without cells, in the
   * order of Geometry::cavities(): M/V_0, see CavityPoint. */
  extern const std::string cavity_filling;



  /**
   * The chambers without cells inside, each with one pressure P_k as a global
   * unknown. Where S_k is the wall around it and n the normal out of the
   * chamber,
   *
   *   V_k  = 1/3 int_Sk x . n da,       a_k = dV_k/du = int_Sk N n da,
   *   r_u -= P_k a_k,                   s_k(V_k, P_k, M_k, t) = 0,
   *   K   -= P_k da_k/du,               B_k = -a_k,   C_k = ds_k/dV_k a_k^T,
   *   D_kj = ds_k/dP_k delta_kj + ds_k/dM_k dM_k/dP_j,
   *
   * with the equation s_k of what is inside (CavityContent), and how much there is,
   * M_k, which changes with the pressures where something flows
   * (CavityExchange). On faces
   * whose nodes are those of polynomials of degree 2 in each direction V_k is
   * integrated exactly by 3 x 3 points, and a_k is its exact derivative, since S_k
   * is closed but for planes of symmetry through the origin, at which x . n = 0
   * and du . n = 0. For the same reason da_k/du is symmetric as a whole, and is
   * taken symmetric face by face (Rumpel and Schweizerhof 2003,
   * Int. J. Numer. Meth. Eng. 56).
   */
  class Cavities : public BorderSource
  {
  public:
    /** Of the geometry of @p body. All of these are kept by reference. */
    Cavities(const Body           &body,
             const CellUnknowns   &unknowns,
             const CavityContents &contents,
             const LiquidWeight   &weight);

    /** After every change of the mesh. Throws ExcInput where the wall around a
     * cavity is not closed. Collective. */
    void
    reinit();

    /** Whether there are any. */
    bool
    any() const
    {
      return !walls.empty();
    }

    /** Whether something flows between them, out or in. */
    bool
    something_flows() const
    {
      return any() && contents.exchange().any();
    }

    /** From now on a load step from @p state is under way. */
    void
    set_to(const State &state);

    /** The load step that ended with @p state is complete: let it have what has
     * flowed. Before State::last_time is changed. Collective. */
    void
    end_step(State &state) const;

    /** The pressures; and how much there is inside. */
    Globals
    globals_at_rest() const override;

    Border
    border(const Vector   &solution,
           const Globals  &globals,
           const LoadTime &t,
           Tangent        *tangent,
           Vector         &r) override;

  private:
    /** A face around a cavity. */
    struct Face
    {
      unsigned int                                   cell; // owned
      dealii::DoFHandler<dim>::active_cell_iterator iterator;
      unsigned int                                   number;
    };

    /** A cavity. */
    struct Wall
    {
      CavityWall        around;
      double            volume_at_rest = 0.; // of all ranks
      std::vector<Face> faces;               // of this rank
    };

    /** What the walls are at a solution, of all ranks. */
    struct Shape
    {
      std::vector<double> volumes;
      std::vector<double> rounding; ///< what makes it: the sum of all |V|
      /** By how much what is prescribed and missing changes them. */
      std::vector<double> missing;
      /** a_k; where there is a tangent. */
      std::vector<BorderVector> areas;
    };

    /** All that hangs on the shape of the walls; as for border(). */
    Shape
    shape(const Vector              &solution,
          const std::vector<double> &P,
          Tangent                   *tangent,
          Vector                    &r);

    /** The pressures of which some are given: with these, what they do does not
     * hang on the unknowns. */
    struct Pressures
    {
      std::vector<double> P;
      std::vector<bool>   given;
    };

    /** Those at @p globals and @p t. */
    Pressures
    pressures(const Globals &globals, const LoadTime &t) const;

    /** How much is inside at @p globals and these pressures. */
    CavityExchange::Amounts
    amounts(const Globals             &globals,
            const std::vector<double> &P,
            const LoadTime            &t) const;

    const Body            body;
    const CellUnknowns   &unknowns;
    const CavityContents &contents;
    const LiquidWeight   &weight;
    CavityFaces           faces;
    SurfaceKernel         surface;

    std::vector<Wall> walls;
    /** As CavityExchange knows them. */
    std::vector<CavityExchange::Cavity> chambers;
    /** The sum of all volumes at rest and of the wall, the scale of errors. */
    double body_volume = 0.;
    /** When the last load step ended. */
    double last_time = 0.;
  };
} // namespace lumbricus

#endif
