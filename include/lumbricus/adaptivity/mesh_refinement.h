// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_mesh_refinement_h
#define lumbricus_adaptivity_mesh_refinement_h

#include <lumbricus/adaptivity/mark_where.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/core/parameter_owner.h>

#include <functional>
#include <memory>
#include <string>

namespace lumbricus
{
  /** Whether liquid slips along the wall between cells of two material ids. */
  using IsSlipInterface = std::function<bool(const dealii::types::material_id,
                                             const dealii::types::material_id)>;

  /** How the coarse mesh is refined before the run starts. */
  class MeshRefinement : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Read the formula. Throws ExcInput. */
    void
    initialize();

    /**
     * Refine everywhere, then where the formula says so. Throws ExcInput where
     * it has no value. Collective.
     */
    void
    refine(ParallelMesh          &triangulation,
           const IsSlipInterface &is_slip_interface) const;

    /** How often the coarse mesh is refined everywhere. */
    unsigned int
    n_global_refinements() const;

  private:
    void
    mark(ParallelMesh &triangulation) const;

    unsigned int                n_global = 0;
    unsigned int                n_local  = 0;
    std::string                 formula  = "0";
    std::unique_ptr<Expression> where;
  };



  /**
   * Whether @p cell is coarser than a neighbour across a slip interface: it is
   * to be refined, so that the two sides can share nodes pair by pair.
   */
  bool
  coarser_across_interface(const ParallelMesh::active_cell_iterator &cell,
                           const IsSlipInterface &is_slip_interface);
} // namespace lumbricus

#endif
