// SPDX-License-Identifier: LGPL-2.1-or-later
// Run a parameter file and write the physics of segments.csv and points.csv to
// five digits to the file "output": what the reference outputs beside the
// parameter files hold. deal.II's testsuite compares a file of that name where
// there is one, and standard output otherwise. That is not ours alone: Open MPI
// 5 may write lines of its own to it.
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/mpi_session.h>
#include <lumbricus/program/run.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace
{
  // A table of the run to five digits, without its last n columns. Pressures
  // and stresses, from column first_stress on, in kPa: of the size of the other
  // numbers, as numdiff allows an absolute difference of 1e-6.
  void
  print_table(std::FILE         *output,
              const std::string &file_name,
              const unsigned int first_stress,
              const unsigned int n_columns_left_out)
  {
    std::ifstream in(file_name);
    std::string   line;
    for (bool header = true; std::getline(in, line); header = false)
      {
        auto entries = dealii::Utilities::split_string_list(line, ',');
        entries.resize(entries.size() - n_columns_left_out);
        for (unsigned int i = 0; i < entries.size(); ++i)
          if (header)
            std::fprintf(output,
                         "%s%s ",
                         entries[i].c_str(),
                         i < first_stress ? "" : "_in_kPa");
          else
            {
              const double value =
                std::stod(entries[i]) * (i < first_stress ? 1. : 1e3);
              // Rounding around zero is not physics.
              std::fprintf(output,
                           "%.5g ",
                           std::abs(value) < 1e-6 ? 0. : value);
            }
        std::fprintf(output, "\n");
      }
  }
} // namespace



int
main(int argc, char *argv[])
{
  const lumbricus::MpiSession session(argv[0]);
  const MPI_Comm              comm = MPI_COMM_WORLD;
  const bool first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
  try
    {
      lumbricus::CommandLine command_line(argc, argv);
      command_line.output_folder = "results";
      command_line.quiet         = true;
      lumbricus::run(command_line, comm);
      if (first)
        {
          std::FILE *const output = std::fopen("output", "w");
          AssertThrow(output != nullptr, dealii::ExcFileNotOpen("output"));
          // eta and the resets depend on their tolerance, the last columns tell
          // of the mesh;
          // J is 1 but for the coarseness of the mesh.
          print_table(output, "results/segments.csv", 6, 5);
          if (std::ifstream("results/points.csv"))
            print_table(output, "results/points.csv", 8, 1);
          AssertThrow(std::fclose(output) == 0, dealii::ExcIO());
        }
      return 0;
    }
  catch (const dealii::ExceptionBase &exception)
    {
      if (first)
        std::cerr << lumbricus::plain_message(exception) << std::endl;
      return 1;
    }
}
