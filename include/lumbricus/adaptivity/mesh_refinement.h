// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_mesh_refinement_h
#define lumbricus_adaptivity_mesh_refinement_h

#include <lumbricus/adaptivity/slip_faces.h>
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/parameter_owner.h>

namespace lumbricus
{
  /** How the coarse mesh is refined before the run starts. */
  class MeshRefinement : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

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
    /** Throw ExcInput where no memory would be left for a mesh so fine. */
    void
    check_memory(const ParallelMesh &triangulation) const;

    void
    mark(ParallelMesh &triangulation) const;

    unsigned int n_global = 0;
    unsigned int n_local  = 0;
    Expression   where    = {"Refine where", "0"};
  };
} // namespace lumbricus

#endif
