// SPDX-License-Identifier: LGPL-2.1-or-later
#include "controllers.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/json_value.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/measures/segment_state.h>
#include <lumbricus/program/chain_model.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <utility>

namespace lumbricus
{
  namespace
  {
    const std::string prefix = "held_";



    // The line for a controller.
    std::string
    question(ChainModel &model, const State &state, const double to)
    {
      model.references.update(state);
      const Vector relevant = model.space.with_ghosts(state.solution);
      const auto   segments = segment_states(
        model.body, model.references, relevant, state.globals);
      const auto measures = section_measures(model.body, relevant);

      std::vector<double> contact(segments.size(), 0.);
      for (const ContactState &touching : model.contacts_of_body(state))
        contact[touching.segment] += touching.normal_force;

      JsonValue list = JsonValue::array();
      for (unsigned int s = 0; s < segments.size(); ++s)
        list.append(JsonValue::object()
                      .add("segment", s + 1)
                      .add("length", measures[s].length)
                      .add("radius", measures[s].mid_radius)
                      .add("pressure", segments[s].mean_pressure())
                      .add("fluid_volume", segments[s].liquid_volume)
                      .add("contact", contact[s]));
      std::ostringstream line;
      JsonValue::object()
        .add("t", state.time)
        .add("dt", to - state.time)
        .add("segments", list)
        .write_line(line);
      return line.str();
    }



    // "held_circular_2_after".
    std::string
    number_name(const Muscle      &muscle,
                const unsigned int s,
                const std::string &when)
    {
      return prefix + muscle.field_name() + "_" + std::to_string(s + 1) + "_" +
             when;
    }
  } // namespace



  void
  Controllers::initialize(const Anatomy &anatomy)
  {
    for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
      {
        const Muscle       &muscle = anatomy.muscle(m);
        const MuscleAction &action = muscle.action();
        const auto          held   = action.activation()->held_values();
        if (held == nullptr)
          continue;
        const auto known =
          std::find_if(controllers.begin(),
                       controllers.end(),
                       [&](const auto &controller) {
                         return controller->address == held->address;
                       });
        const std::size_t i = known - controllers.begin();
        if (i == controllers.size())
          {
            controllers.push_back(std::make_unique<Controller>());
            controllers[i]->address    = held->address;
            controllers[i]->late_after = held->late_after;
          }
        Controller &controller = *controllers[i];
        controller.late_after =
          std::min(controller.late_after, held->late_after);
        controller.muscles.push_back({&muscle, held});
        controller.questions.push_back(
          {muscle.name(), action.quantity(), [&action](const double value) {
             return action.requirement(value);
           }});
      }
  }



  void
  Controllers::connect(const MPI_Comm comm)
  {
    for (const auto &controller : controllers)
      {
        std::string why;
        if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
          why = controller->socket.connect(controller->address);
        throw_on_all_ranks<ExcInput>(
          why.empty() ?
            "" :
            about_parameter(controller->muscles.front().held->section +
                              "/Address",
                            ": no controller answers at '" +
                              controller->address + "' (" + why +
                              "). Start it before the run, in the same working "
                              "directory or with the whole path: see "
                              "doc/controllers.md."),
          comm);
      }
  }



  ControllerAnswer
  Controllers::answer_of(Controller        &controller,
                         const std::string &line,
                         const double       smallest_step,
                         const MPI_Comm     comm)
  {
    const std::string who = "The controller at '" + controller.address + "' ";
    const unsigned int n_segments =
      controller.muscles.front().held->now().after.size();
    ControllerAnswer answer;
    std::string      message;
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      {
        const auto reply = controller.socket.ask(line, controller.late_after);
        if (reply.interrupted)
          message = who + "was asked when the run was interrupted.";
        else if (!reply.fault.empty())
          message = who + reply.fault + ".";
        else
          {
            answer = read_answer(
              reply.line, controller.questions, n_segments, smallest_step);
            if (!answer.fault.empty())
              message = who + "answered '" + shortened(reply.line) +
                        "', which " + answer.fault + ".";
          }
      }
    message = first_message(message, comm);
    if (!message.empty())
      {
        throw_if_interrupted(comm);
        AssertThrow(false, ExcSolveFailed(message));
      }
    answer.values = dealii::Utilities::MPI::broadcast(comm, answer.values);
    answer.largest_dt =
      dealii::Utilities::MPI::broadcast(comm,
                                        answer.largest_dt.value_or(
                                          std::numeric_limits<double>::max()));
    return answer;
  }



  double
  Controllers::ask(ChainModel &model, const State &state, const double to)
  {
    if (controllers.empty())
      return to;
    const RunParameters &parameters = model.parameters;
    // Steps as long as this to the last digits but six.
    constexpr double rounding = 1e-9;
    const MPI_Comm   comm     = model.triangulation.get_communicator();
    double           end      = to;
    while (true)
      {
        const std::string line = question(model, state, end);
        largest_dt             = std::numeric_limits<double>::max();
        for (const auto &controller : controllers)
          {
            const auto answer =
              answer_of(*controller,
                        line,
                        parameters.load_stepping.smallest_step(),
                        comm);
            largest_dt = std::min(largest_dt, *answer.largest_dt);
            for (unsigned int m = 0; m < answer.values.size(); ++m)
              controller->muscles[m].held->go_to(state.time,
                                                 end,
                                                 answer.values[m]);
          }
        if (end - state.time <= largest_dt * (1. + rounding))
          break;
        end = state.time + largest_dt;
      }
    // Nobody knew before what muscles do at this time.
    parameters.symmetry_check.check(model.space,
                                    parameters.anatomy,
                                    parameters.boundary_conditions,
                                    parameters.body_forces,
                                    {end});
    return end;
  }



  Continuation::Numbers
  Controllers::numbers() const
  {
    Continuation::Numbers numbers;
    if (controllers.empty())
      return numbers;
    numbers[prefix + "largest_dt"] = largest_dt;
    for (const auto &controller : controllers)
      for (const Asked &asked : controller->muscles)
        {
          const HeldValues::Way &way = asked.held->now();
          // The same for all.
          numbers[prefix + "from"] = way.from;
          numbers[prefix + "to"]   = way.to;
          for (unsigned int s = 0; s < way.after.size(); ++s)
            {
              numbers[number_name(*asked.muscle, s, "before")] = way.before[s];
              numbers[number_name(*asked.muscle, s, "after")]  = way.after[s];
            }
        }
    return numbers;
  }



  bool
  Controllers::set_numbers(const Continuation::Numbers &numbers)
  {
    const auto has = [&](const std::string &name) {
      return numbers.count(name) > 0;
    };
    std::vector<std::pair<HeldValues *, HeldValues::Way>> found;
    for (const auto &controller : controllers)
      for (const Asked &asked : controller->muscles)
        {
          if (!has(number_name(*asked.muscle, 0, "after")))
            continue;
          HeldValues::Way way = asked.held->now();
          if (!has(prefix + "from") || !has(prefix + "to") ||
              !has(prefix + "largest_dt"))
            return false;
          way.from = numbers.at(prefix + "from");
          way.to   = numbers.at(prefix + "to");
          for (unsigned int s = 0; s < way.after.size(); ++s)
            for (auto [values, when] :
                 {std::make_pair(&way.before, "before"),
                  std::make_pair(&way.after, "after")})
              {
                const std::string name = number_name(*asked.muscle, s, when);
                if (!has(name) || !asked.muscle->action()
                                     .requirement(numbers.at(name))
                                     .empty())
                  return false;
                (*values)[s] = numbers.at(name);
              }
          if (!(way.from <= way.to))
            return false;
          found.emplace_back(asked.held.get(), way);
        }
    if (!found.empty() && !(numbers.at(prefix + "largest_dt") > 0.))
      return false;
    for (const auto &[held, way] : found)
      held->set(way);
    if (!found.empty())
      largest_dt = numbers.at(prefix + "largest_dt");
    return true;
  }



  bool
  Controllers::is_name(const std::string &name)
  {
    return name.compare(0, prefix.size(), prefix) == 0;
  }
} // namespace lumbricus
