// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_description_h
#define lumbricus_output_run_description_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/core/json_value.h>
#include <lumbricus/output/run_costs.h>
#include <lumbricus/output/run_folder.h>
#include <lumbricus/parameters/parameter_entry.h>
#include <lumbricus/terms/body_forces.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/grid/tria.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** How far a run has come, and how it ended. */
  struct RunStatus
  {
    /** What the run is at. */
    enum class State
    {
      running,
      finished,
      interrupted,
      failed
    };

    State        state = State::running; ///< what the run is at
    std::string  message;       ///< why it has not come to its end
    unsigned int step     = 0;  ///< load steps until now
    double       time     = 0.; ///< reached
    double       end_time = 0.; ///< to be reached
    double       seconds  = 0.; ///< until now, also before a restart

    /** Where the time went, at the end. */
    std::optional<RunCosts> costs;
  };



  /**
   * What a run is, in its folder: run.json, from which programs draw and report
   * on it without knowing what shapes, laws or loads there are. doc/results.md
   * says what is in it. It is written whole when the run begins and when it
   * ends; that of a run which was killed says that it is running.
   */
  class RunDescription
  {
  public:
    /** The name of the file in the folder. */
    static const std::string file_name;

    /** Of the run in @p folder, which is kept by reference; claims the file,
     * see RunFolder::claim(). Collective. */
    explicit RunDescription(RunFolder &folder);

    /** What the user called it, and on how many ranks it runs. */
    void
    describe_run(const std::string &title, const unsigned int n_ranks);

    /** The run goes on from a checkpoint, at @p time after @p step, which that
     * version of the program wrote. */
    void
    describe_restart(const std::string &version,
                     const unsigned int step,
                     const double       time);

    /** The body, of which @p mesh is, and what acts on it. The parameters have
     * been initialized. */
    void
    describe_body(const Anatomy                    &anatomy,
                  const BoundaryConditions         &conditions,
                  const dealii::Triangulation<dim> &mesh);

    /** What acts on tissues. The parameters have been initialized. */
    void
    describe_body_forces(const BodyForces &forces);

    /** All parameters, with the values of this run. */
    void
    describe_parameters(const std::vector<ParameterEntry> &entries);

    /** Write the file. Throws ExcSolveFailed. Collective. */
    void
    write(const RunStatus &status) const;

    /** Write it where that is possible: the run ends with another message. */
    void
    try_to_write(const RunStatus &status) const;

  private:
    RunFolder  &folder;
    std::string title;
    JsonValue   program;
    JsonValue   restart; ///< null where the run began at rest
    JsonValue   body;
    JsonValue   boundary_conditions;
    JsonValue   body_forces;
    JsonValue   obstacles;
    JsonValue   parameters;
  };
} // namespace lumbricus

#endif
