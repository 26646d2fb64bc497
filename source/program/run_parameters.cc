// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/output/table.h>
#include <lumbricus/program/run_parameters.h>

namespace lumbricus
{
  RunParameters::RunParameters()
    : continuation("Control",
                   "time",
                   "What is given in a step of the run, which leads from one "
                   "equilibrium to the next.")
    , linear_solver("Method", "auto", "How linear systems are solved.")
  {}



  void
  RunParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    shared_libraries.declare_parameters(prm);
    prm.add_parameter("Title", title, "One line for the log.");
    unit_check.declare_parameters(prm);

    anatomy.declare_parameters(prm);

    mesh_refinement.declare_parameters(prm);
    adaptivity.declare_parameters(prm);
    interface_coupling.declare_parameters(prm);
    boundary_conditions.declare_parameters(prm);
    body_forces.declare_parameters(prm);
    cavity_contents.declare_parameters(prm);
    symmetry_check.declare_parameters(prm);
    load_stepping.declare_parameters(prm);
    load_curves.declare_parameters(prm);
    prm.enter_subsection("Path");
    continuation.declare_parameters(prm);
    prm.leave_subsection();
    checkpoint_schedule.declare_parameters(prm);
    reset_iteration.declare_parameters(prm);
    newton.declare_parameters(prm);
    predictor.declare_parameters(prm);

    prm.enter_subsection("Linear solver");
    linear_solver.declare_parameters(prm);
    prm.leave_subsection();

    stability_watch.declare_parameters(prm);

    prm.enter_subsection("Output");
    prm.add_parameter("Folder",
                      output_folder,
                      "Where the results go; made where it does not exist. "
                      "--output overrides it.",
                      dealii::Patterns::DirectoryName());
    prm.add_parameter("Every",
                      output_every,
                      "[-] Write pictures after every so many load steps, and "
                      "at the end; 0 for the end only. They have the fields" +
                        Registry<Field>::descriptions() +
                        " Every step is in the tables" +
                        Registry<Table>::descriptions(),
                      dealii::Patterns::Integer(0));
    output_parts.declare_parameters(prm);
    prm.leave_subsection();
  }



  bool
  RunParameters::extend_parameters(dealii::ParameterHandler &prm,
                                   const Extent              extent)
  {
    bool extended = anatomy.extend_parameters(prm, extent);
    extended |= adaptivity.extend_parameters(prm, extent);
    extended |= boundary_conditions.extend_parameters(prm, extent);
    extended |= body_forces.extend_parameters(prm, extent);
    extended |= cavity_contents.extend_parameters(prm, extent);
    prm.enter_subsection("Path");
    extended |= continuation.extend_parameters(prm, extent);
    prm.leave_subsection();
    prm.enter_subsection("Linear solver");
    extended |= linear_solver.extend_parameters(prm, extent);
    prm.leave_subsection();
    prm.enter_subsection("Output");
    extended |= output_parts.extend_parameters(prm, extent);
    prm.leave_subsection();
    return extended;
  }



  void
  RunParameters::check_parameters() const
  {
    anatomy.check_parameters();
    adaptivity.check_parameters();
    boundary_conditions.check_parameters();
    body_forces.check_parameters();
    cavity_contents.check_parameters();
    load_stepping.check_parameters();
    within_section("Path", [&]() { continuation.check_parameters(); });
    within_section("Linear solver",
                   [&]() { linear_solver.check_parameters(); });
    within_section("Output", [&]() { output_parts.check_parameters(); });
  }



  void
  RunParameters::initialize()
  {
    anatomy.initialize();
    mesh_refinement.initialize();
    adaptivity.initialize(anatomy, mesh_refinement.n_global_refinements());
    boundary_conditions.initialize(anatomy.geometry());
    body_forces.initialize(anatomy.geometry());
    output_parts.initialize(anatomy);
    continuation.get()->initialize(*this);
  }



  std::vector<double>
  RunParameters::times_to_try() const
  {
    constexpr unsigned int n = 100;
    std::vector<double>    times;
    for (unsigned int i = 0; i <= n; ++i)
      times.push_back(load_stepping.end_time() * i / n);
    return times;
  }



  void
  RunParameters::try_expressions(
    const dealii::parallel::TriangulationBase<dim> &triangulation) const
  {
    const auto times = times_to_try();
    anatomy.try_activations(triangulation, times);
    try_loads(triangulation, times);
  }



  void
  RunParameters::try_loads(
    const dealii::parallel::TriangulationBase<dim> &triangulation,
    const std::vector<double>                      &times) const
  {
    boundary_conditions.try_expressions(triangulation, times);
    body_forces.try_expressions(triangulation, times);
  }



  void
  RunParameters::follow_loads(
    const dealii::parallel::TriangulationBase<dim> &triangulation)
  {
    std::vector<LoadCurve> curves = anatomy.load_curves(triangulation);
    for (const LoadCurve &curve :
         boundary_conditions.load_curves(triangulation))
      curves.push_back(curve);
    for (const LoadCurve &curve : body_forces.load_curves(triangulation))
      curves.push_back(curve);
    load_curves.follow(curves,
                       load_stepping.end_time(),
                       load_stepping.smallest_step());
  }
} // namespace lumbricus
