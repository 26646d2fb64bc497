// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_cavities_cavities_h
#define lumbricus_cavities_cavities_h

#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/border.h>
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/dofs/dof_handler.h>

#include <vector>

namespace lumbricus
{
  /**
   * The chambers without cells inside, each with one pressure P_k as a global
   * unknown. Where S_k is the wall around it and n the normal out of the
   * chamber,
   *
   *   V_k  = 1/3 int_Sk x . n da,       a_k = dV_k/du = int_Sk N n da,
   *   r_u -= P_k a_k,                   s_k = -(V_k - Vhat_k(P_k, t)) = 0,
   *   K   -= P_k da_k/du,               B_k = C_k^T = -a_k,  D = dVhat/dP,
   *
   * with what the content of the chamber takes, Vhat_k (CavityContent). On faces
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
    Cavities(const Body                  &body,
             const CellUnknowns          &unknowns,
             const Choice<CavityContent> &content);

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
      unsigned int      segment;
      double            volume_at_rest = 0.; // of all ranks
      std::vector<Face> faces;               // of this rank
    };

    const Body                   body;
    const CellUnknowns          &unknowns;
    const Choice<CavityContent> &content;
    CavityFaces                  faces;
    SurfaceKernel                surface;

    std::vector<Wall> walls;
    /** The sum of all volumes at rest and of the wall, the scale of errors. */
    double body_volume = 0.;
  };
} // namespace lumbricus

#endif
