// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/field.h>
#include <lumbricus/output/table.h>
#include <lumbricus/program/run_parameters.h>

namespace lumbricus
{
  RunParameters::RunParameters()
    : cavity_contents(anatomy)
    , continuation("Path",
                   "Control",
                   "time",
                   "What is given in a step of the run, which leads from one "
                   "equilibrium to the next.")
    , linear_solver("Linear solver",
                    "Method",
                    "auto",
                    "How linear systems are solved.")
    , output_parts("Output")
    , owners{&unit_check,
             &anatomy,
             &mesh_refinement,
             &adaptivity,
             &interface_coupling,
             &boundary_conditions,
             &body_forces,
             &cavity_contents,
             &symmetry_check,
             &load_stepping,
             &load_curves,
             &continuation,
             &checkpoint_schedule,
             &reset_iteration,
             &newton,
             &predictor,
             &linear_solver,
             &stability_watch}
  {}



  void
  RunParameters::declare_parameters(dealii::ParameterHandler &prm)
  {
    shared_libraries.declare_parameters(prm);
    prm.add_parameter("Title", title, "One line for the log.");
    for (ParameterOwner *owner : owners)
      owner->declare_parameters(prm);

    prm.enter_subsection(output_parts.section_name());
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
    prm.leave_subsection();
    output_parts.declare_parameters(prm);
  }



  bool
  RunParameters::extend_parameters(dealii::ParameterHandler &prm,
                                   const Extent              extent)
  {
    bool extended = false;
    for (ParameterOwner *owner : owners)
      extended |= owner->extend_parameters(prm, extent);
    extended |= output_parts.extend_parameters(prm, extent);
    return extended;
  }



  void
  RunParameters::check_parameters() const
  {
    for (const ParameterOwner *owner : owners)
      owner->check_parameters();
    output_parts.check_parameters();
  }



  void
  RunParameters::initialize()
  {
    anatomy.initialize();
    AssertThrow(!interface_coupling.slips() || anatomy.has_liquid(),
                ExcParameter("Interface/Coupling",
                             "lets liquid slip along the wall, but no chamber "
                             "of this body has cells of liquid inside. Set it "
                             "to 'tied'."));
    adaptivity.initialize(anatomy, mesh_refinement.n_global_refinements());
    boundary_conditions.initialize(anatomy.geometry());
    body_forces.initialize(anatomy.geometry());
    cavity_contents.initialize();
    output_parts.initialize(anatomy, boundary_conditions);
    continuation.get()->initialize(*this);
    AssertThrow(!output_parts.asks_for_errors_of_steps() ||
                  continuation.chosen_name() == "time",
                ExcParameter("Output/Errors of steps",
                             "are estimated where steps are those in time, not "
                             "on a path. Set it to false, or 'Path/Control' to "
                             "'time'."));
    if (output_parts.asks_for_errors())
      check_finer_cells("Output/Errors", "Set it to 0");
    if (adaptivity.adapts() && adaptivity.estimator().needs_finer_cells())
      check_finer_cells("Adaptivity/Estimator", "Choose another one");
  }



  void
  RunParameters::check_finer_cells(const std::string &parameter,
                                   const std::string &otherwise) const
  {
    AssertThrow(!interface_coupling.slips(),
                ExcParameter(parameter,
                             "asks for estimates of errors, of which there are "
                             "none where liquid slips along the wall. " +
                               otherwise +
                               ", or 'Interface/Coupling' to 'tied'."));
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



  double
  RunParameters::density_in_chamber(const unsigned int segment) const
  {
    for (const CavityWall &wall : anatomy.geometry().cavities())
      if (wall.segment == segment)
        return cavity_contents.content(segment).density();
    const auto tissues = anatomy.geometry().tissues();
    for (unsigned int i = 0; i < tissues.size(); ++i)
      if (tissues[i].liquid)
        return anatomy.tissue(i).density();
    return 0.;
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
    cavity_contents.try_expressions(times);
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
    for (const LoadCurve &curve : cavity_contents.load_curves())
      curves.push_back(curve);
    load_curves.follow(curves,
                       load_stepping.end_time(),
                       load_stepping.smallest_step());
  }
} // namespace lumbricus
