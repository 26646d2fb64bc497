// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_liquid_mesh_h
#define lumbricus_equilibrium_liquid_mesh_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/measures/mesh_quality.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <vector>

namespace lumbricus
{
  /**
   * Relaxes the mesh inside the liquid. A liquid has no memory and flows, so
   * that cells which go with it lose their shape; but a hydrostatic liquid is
   * in equilibrium wherever the nodes inside it are: int p cof(F) Grad N dV is
   * zero for every N that vanishes on its surface. So where the cells of a
   * segment are badly shaped, a reset puts the nodes inside the liquid to the
   * harmonic extension of its surface, makes that its stress-free shape, and
   * keeps its surface, its stress-free volume as a whole, and its mean
   * pressure.
   *
   * A node inside the liquid is no particle of it.
   */
  class LiquidMesh : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Whether meshes are ever relaxed. */
    bool
    relaxes() const
    {
      return relax_below > 0.;
    }

    /** What relaxing did. */
    struct Relaxation
    {
      /** Which segments; empty for none. */
      std::vector<bool> in_segment;
    };

    /** Relax the mesh of those segments whose quality asks for it, and is
     * better then. Collective. */
    Relaxation
    relax(const Body &body, const CellUnknowns &unknowns, State &state) const;

    /** The same after a load step in the liquid of every segment where the mesh
     * is half as good as at rest then, or better than it was: where that is so,
     * what the liquid's mesh is hangs on nothing but the surface of the liquid.
     * Nothing where meshes are never relaxed. Collective. */
    Relaxation
    settle(const Body &body, const CellUnknowns &unknowns, State &state) const;

  private:
    /** Whether the mesh of a segment is to be relaxed, unless its quality would
     * be less than that then. */
    struct Wanted
    {
      bool   relaxes;
      double least_quality;
    };

    /** Relax the mesh of the segments in which @p wish, a Wanted of the quality and
     * of that at rest, asks for it. Nothing where meshes are never relaxed. */
    template <typename Wish>
    Relaxation
    relax_where(const Body         &body,
                const CellUnknowns &unknowns,
                State              &state,
                const Wish         &wish) const;

    double relax_below = 1.;
  };
} // namespace lumbricus

#endif
