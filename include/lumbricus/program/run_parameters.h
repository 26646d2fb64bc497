// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_parameters_h
#define lumbricus_program_run_parameters_h

#include <lumbricus/adaptivity/adaptivity.h>
#include <lumbricus/adaptivity/mesh_refinement.h>
#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/cavities/cavity_contents.h>
#include <lumbricus/checkpoint/checkpoint_schedule.h>
#include <lumbricus/constraints/interface_coupling.h>
#include <lumbricus/continuation/continuation.h>
#include <lumbricus/continuation/load_curves.h>
#include <lumbricus/continuation/load_stepping.h>
#include <lumbricus/continuation/predictor.h>
#include <lumbricus/equilibrium/reset_iteration.h>
#include <lumbricus/linear/linear_solver.h>
#include <lumbricus/output/output_parts.h>
#include <lumbricus/parameters/parameter_owner.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>
#include <lumbricus/program/shared_libraries.h>
#include <lumbricus/program/stability_watch.h>
#include <lumbricus/program/symmetry_check.h>
#include <lumbricus/program/unit_check.h>
#include <lumbricus/terms/body_forces.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** All parameters of a run, and the objects they make. */
  class RunParameters : public ParameterOwner
  {
  public:
    /** With the default values. */
    RunParameters();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /**
     * Read all expressions and find all boundaries: after this nothing in the
     * input can be wrong that does not depend on the mesh. Throws ExcInput.
     */
    void
    initialize();

    /** The times at which expressions are tried: 101, from 0 to the end. */
    std::vector<double>
    times_to_try() const;

    /**
     * Try all expressions on the mesh, at times_to_try(). Throws ExcInput.
     * Collective.
     */
    void
    try_expressions(
      const dealii::parallel::TriangulationBase<dim> &triangulation) const;

    /** Try those of loads and supports only, at @p times. Throws ExcInput.
     * Collective. */
    void
    try_loads(const dealii::parallel::TriangulationBase<dim> &triangulation,
              const std::vector<double>                      &times) const;

    /** Let load steps miss no change of what the muscles, loads and supports
     * on the mesh do over time. */
    void
    follow_loads(const dealii::parallel::TriangulationBase<dim> &triangulation);

    /** Of what is in the chamber of a segment, from zero, with cells or without
     * [t/mm^3]. */
    double
    density_in_chamber(const unsigned int segment) const;

    SharedLibraries    shared_libraries;    ///< loaded before all others
    std::string        title;               ///< a line for the log
    UnitCheck          unit_check;          ///< entry Units
    Anatomy            anatomy;             ///< Geometry, Tissues, Muscles
    MeshRefinement     mesh_refinement;     ///< section Mesh
    Adaptivity         adaptivity;          ///< section Adaptivity
    InterfaceCoupling  interface_coupling;  ///< section Interface
    BoundaryConditions boundary_conditions; ///< section Boundary conditions
    BodyForces         body_forces;         ///< section Body forces
    CavityContents     cavity_contents;     ///< section Cavities
    SymmetryCheck      symmetry_check;      ///< section Boundary conditions
    LoadStepping       load_stepping;       ///< section Time
    LoadCurves         load_curves;         ///< section Time
    /** Section Path. */
    Section<Choice<Continuation>> continuation;
    CheckpointSchedule            checkpoint_schedule; ///< section Checkpoints
    ResetIteration                reset_iteration;     ///< section Reset
    Newton                        newton;              ///< section Newton
    Predictor                     predictor;           ///< section Newton
    /** Section Linear solver. */
    Section<Choice<LinearSolver>> linear_solver;
    StabilityWatch                stability_watch; ///< section Stability
    /** Where results go. */
    std::string output_folder = "results";
    /** Load steps from one picture to the next; 0 for the last state only. */
    unsigned int         output_every = 1;
    Section<OutputParts> output_parts; ///< the other entries of section Output

  private:
    /** That there can be estimates on finer cells, for which @p parameter asks;
     * @p otherwise says how not to ask. */
    void
    check_finer_cells(const std::string &parameter,
                      const std::string &otherwise) const;

    /** All from unit_check to stability_watch, as the reference has them. */
    const std::vector<ParameterOwner *> owners;
  };
} // namespace lumbricus

#endif
