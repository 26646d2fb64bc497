// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/core/build_version.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/run_description.h>
#include <lumbricus/parameters/entries_as_json.h>

#include <algorithm>

#include "cavity_points.h"

namespace lumbricus
{
  namespace
  {
    // Changes when what is in the file gets another meaning.
    constexpr unsigned int format = 1;

    std::string
    axis_name(const unsigned int d)
    {
      return std::string(1, "xyz"[d]);
    }



    std::string
    state_name(const RunStatus::State state)
    {
      switch (state)
        {
          case RunStatus::State::running:
            return "running";
          case RunStatus::State::finished:
            return "finished";
          case RunStatus::State::interrupted:
            return "interrupted";
          default:
            return "failed";
        }
    }



    JsonValue
    tissues_of(const Anatomy &anatomy)
    {
      JsonValue  tissues = JsonValue::array();
      const auto names   = anatomy.geometry().tissues();
      for (unsigned int i = 0; i < names.size(); ++i)
        tissues.append(JsonValue::object()
                         .add("name", names[i].name)
                         .add("liquid", anatomy.is_liquid(i))
                         .add("law", anatomy.tissue(i).law_name())
                         .add("muscles", anatomy.tissue(i).muscle_names()));
      if (!anatomy.geometry().cavities().empty() &&
          tissue_of_cavities(anatomy.geometry()) == names.size())
        tissues.append(JsonValue::object()
                         .add("name", cavity_tissue)
                         .add("liquid", true)
                         .add("law", JsonValue())
                         .add("muscles", JsonValue::array()));
      return tissues;
    }



    JsonValue
    muscles_of(const Anatomy &anatomy)
    {
      JsonValue  muscles = JsonValue::array();
      const auto names   = anatomy.geometry().tissues();
      for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
        {
          const Muscle            &muscle = anatomy.muscle(m);
          std::vector<std::string> of_tissues;
          for (unsigned int i = 0; i < names.size(); ++i)
            {
              const auto &there = anatomy.muscles_of(i);
              if (std::count(there.begin(), there.end(), &muscle) > 0)
                of_tissues.push_back(names[i].name);
            }
          muscles.append(JsonValue::object()
                           .add("name", muscle.name())
                           .add("field", muscle.field_name())
                           .add("tissues", of_tissues)
                           .add("fibres", muscle.fibres_name())
                           .add("action", muscle.action_name())
                           .add("activation",
                                muscle.action().activation().chosen_name()));
        }
      return muscles;
    }



    JsonValue
    all_of(const BoundaryConditions &conditions)
    {
      JsonValue all = JsonValue::array();
      for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
        {
          const NamedCondition &condition = conditions.condition(i);
          const auto *held = condition.prescribed_displacement();
          std::vector<std::string> components;
          for (unsigned int d = 0; d < dim; ++d)
            if (held != nullptr && held->components()[d])
              components.push_back(axis_name(d));
          all.append(JsonValue::object()
                       .add("name", condition.name)
                       .add("boundary", condition.boundary_name)
                       .add("type", condition.type.chosen_name())
                       .add("prescribed_displacements", components));
        }
      return all;
    }



    JsonValue
    obstacles_of(const BoundaryConditions &conditions)
    {
      JsonValue  all      = JsonValue::array();
      const auto contacts = contacts_of(conditions);
      for (unsigned int i = 0; i < contacts.size(); ++i)
        if (contacts[i] != nullptr)
          all.append(
            JsonValue::object()
              .add("name", conditions.condition(i).name)
              .add("boundary", conditions.condition(i).boundary_name)
              .add("shape", contacts[i]->obstacle_name()));
      return all;
    }



    JsonValue
    all_of(const std::vector<RunCosts::Part> &parts)
    {
      JsonValue all = JsonValue::array();
      for (const RunCosts::Part &part : parts)
        {
          JsonValue one = JsonValue::object();
          one.add("name", part.name)
            .add("seconds", part.seconds)
            .add("calls", part.n_calls);
          if (!part.parts.empty())
            one.add("parts", all_of(part.parts));
          all.append(one);
        }
      return all;
    }



    JsonValue
    all_of(const std::optional<RunCosts> &costs)
    {
      if (!costs)
        return JsonValue();
      return JsonValue::object()
        .add("seconds", costs->seconds)
        .add("peak_memory_mb", costs->peak_memory)
        .add("most_linear_iterations", costs->most_linear_iterations)
        .add("parts", all_of(costs->parts));
    }
  } // namespace



  const std::string RunDescription::file_name = "run.json";



  RunDescription::RunDescription(RunFolder &folder)
    : folder(folder)
  {
    folder.claim(file_name);
  }



  void
  RunDescription::describe_run(const std::string &its_title,
                               const unsigned int n_ranks)
  {
    title   = its_title;
    program = JsonValue::object()
                .add("name", "lumbricus")
                .add("version", LUMBRICUS_VERSION)
                .add("deal_ii", DEAL_II_PACKAGE_VERSION)
                .add("build_type", LUMBRICUS_BUILD_TYPE)
                .add("ranks", n_ranks);
  }



  void
  RunDescription::describe_restart(const std::string &version,
                                   const unsigned int step,
                                   const double       time)
  {
    restart = JsonValue::object()
                .add("step", step)
                .add("time", time)
                .add("version", version);
  }



  void
  RunDescription::describe_body(const Anatomy                    &anatomy,
                                const BoundaryConditions         &conditions,
                                const dealii::Triangulation<dim> &mesh)
  {
    const Geometry &geometry = anatomy.geometry();
    JsonValue       planes   = JsonValue::array();
    for (const SymmetryPlane &plane : geometry.symmetry_planes())
      planes.append(JsonValue::object()
                      .add("normal", axis_name(plane.direction))
                      .add("position", plane.position(mesh)));
    body = JsonValue::object()
             .add("dimension", dim)
             .add("axis", axis_name(0))
             .add("segments", geometry.n_segments())
             .add("symmetry_planes", planes)
             .add("tissues", tissues_of(anatomy))
             .add("muscles", muscles_of(anatomy))
             .add("boundaries", geometry.boundary_names());
    boundary_conditions = all_of(conditions);
    obstacles           = obstacles_of(conditions);
  }



  void
  RunDescription::describe_body_forces(const BodyForces &forces)
  {
    body_forces = JsonValue::array();
    for (unsigned int i = 0; i < forces.n_forces(); ++i)
      body_forces.append(JsonValue::object()
                           .add("name", forces.force(i).name)
                           .add("tissues", forces.force(i).tissues)
                           .add("type", forces.force(i).type.chosen_name()));
  }



  void
  RunDescription::describe_parameters(
    const std::vector<ParameterEntry> &entries)
  {
    parameters = as_json(entries);
  }



  void
  RunDescription::write(const RunStatus &status) const
  {
    const JsonValue all =
      JsonValue::object()
        .add("format", format)
        .add("program", program)
        .add("title", title)
        .add("status",
             JsonValue::object()
               .add("state", state_name(status.state))
               .add("message", status.message)
               .add("step", status.step)
               .add("time", status.time)
               .add("end_time", status.end_time)
               .add("seconds", status.seconds))
        .add("restart", restart)
        .add("body", body)
        .add("boundary_conditions", boundary_conditions)
        .add("body_forces", body_forces)
        .add("obstacles", obstacles)
        .add("where_the_time_went", all_of(status.costs))
        .add("parameters", parameters);
    folder.on_first_rank([&]() {
      folder.write(file_name, [&](std::ostream &out) {
        all.write(out);
        out << '\n';
      });
    });
  }



  void
  RunDescription::try_to_write(const RunStatus &status) const
  {
    try
      {
        write(status);
      }
    catch (const ExcSolveFailed &)
      {
        // What ended the run is said, and this too if it is why.
      }
  }
} // namespace lumbricus
