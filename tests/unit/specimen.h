// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_unit_specimen_h
#define lumbricus_tests_unit_specimen_h

#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/program/chain_model.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace lumbricus
{
  /** What lets liquid slip along the wall. */
  const std::string slip = R"(
subsection Interface
  set Coupling = slip
end
)";



  /** A body made from the text of a parameter file, at rest. */
  class Specimen
  {
  public:
    explicit Specimen(const std::string &text)
      : timer(std::cout,
              dealii::TimerOutput::never,
              dealii::TimerOutput::wall_times)
    {
      const auto name = std::filesystem::temp_directory_path() /
                        ("lumbricus." + std::to_string(getpid()) + ".prm");
      std::ofstream(name) << text;
      ParameterFile file;
      file.read(name);
      std::filesystem::remove(name);
      file.parse(parameters);
      parameters.initialize();
      model = std::make_unique<ChainModel>(parameters, timer, comm);
      model->create(nullptr);
      state = model->rest_state();
    }

    /** A vector that obeys the constraints, the same on any number of ranks. */
    Vector
    random(const double size, const unsigned int seed) const
    {
      const auto &space = model->space;
      Vector      v(space.locally_owned, comm);
      for (const auto i : space.locally_owned)
        v(i) = size * std::sin(1. + 12.9898 * i + 78.233 * seed);
      model->supports.constraints().distribute(v);
      return v;
    }

    /** A vector as linear solvers have it, without the constrained unknowns. */
    Vector
    free_part(const Vector &v) const
    {
      Vector result;
      result.reinit(model->assembler.right_hand_side());
      const auto &constrained =
        model->assembler.tangent().unknowns.is_constrained();
      for (unsigned int i = 0; i < constrained.size(); ++i)
        result.local_element(i) = constrained[i] ? 0. : v.begin()[i];
      return result;
    }

    const MPI_Comm              comm = MPI_COMM_WORLD;
    RunParameters               parameters;
    dealii::TimerOutput         timer;
    std::unique_ptr<ChainModel> model;
    State                       state;
  };
} // namespace lumbricus

#endif
