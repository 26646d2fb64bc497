// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/build_version.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/program/command_line.h>

#include <getopt.h>

#include <ostream>

namespace lumbricus
{
  CommandLine::CommandLine(const int argc, char *const argv[])
  {
    static const option options[] = {
      {"help", no_argument, nullptr, 'h'},
      {"version", no_argument, nullptr, 'v'},
      {"parameters", no_argument, nullptr, 'p'},
      {"check", no_argument, nullptr, 'c'},
      {"values", no_argument, nullptr, 'w'},
      {"quiet", no_argument, nullptr, 'q'},
      {"verbose", no_argument, nullptr, 'V'},
      {"progress", no_argument, nullptr, 'P'},
      {"set", required_argument, nullptr, 's'},
      {"output", required_argument, nullptr, 'o'},
      {"restart", required_argument, nullptr, 'r'},
      {nullptr, 0, nullptr, 0}};
    const std::string advice = "\nTry 'lumbricus --help'.";

    opterr = 0;
    optind = 1;
    int letter;
    while ((letter = getopt_long(argc, argv, ":hvqo:", options, nullptr)) != -1)
      switch (letter)
        {
          case 'h':
            help = true;
            break;
          case 'v':
            version = true;
            break;
          case 'p':
            parameters = true;
            break;
          case 'c':
            check = true;
            break;
          case 'w':
            check = values = true;
            break;
          case 'P':
            progress = true;
            break;
          case 'q':
            quiet = true;
            break;
          case 'V':
            verbose = true;
            break;
          case 's':
            settings.emplace_back(optarg);
            break;
          case 'o':
            output_folder = optarg;
            AssertThrow(!output_folder.empty(),
                        ExcInput("The option '--output' needs the name of a "
                                 "folder." +
                                 advice));
            break;
          case 'r':
            restart_folder = optarg;
            AssertThrow(!restart_folder.empty(),
                        ExcInput("The option '--restart' needs the name of a "
                                 "folder." +
                                 advice));
            break;
          case ':':
            AssertThrow(false,
                        ExcInput(std::string("The option '") +
                                 argv[optind - 1] + "' needs a value." +
                                 advice));
            break;
          default:
            AssertThrow(false,
                        ExcInput(std::string("The option '") +
                                 argv[optind - 1] + "' is unknown." + advice));
        }

    const int n_files = argc - optind;
    if (help || version)
      return;
    if (!restart_folder.empty())
      {
        AssertThrow(n_files == 0 && output_folder.empty(),
                    ExcInput("With '--restart' a run goes on in its folder, "
                             "with its parameters. Leave out " +
                             std::string(n_files > 0 ? "the parameter file" :
                                                       "'--output'") +
                             "; '--set' changes a parameter." + advice));
        return;
      }
    if (parameters && n_files == 0)
      return;
    AssertThrow(n_files == 1,
                ExcInput((n_files == 0 ?
                            std::string("No parameter file was given.") :
                            "More than one parameter file was given: '" +
                              std::string(argv[optind]) + "', '" +
                              argv[optind + 1] + "'.") +
                         advice));
    parameter_file = argv[optind];
  }



  void
  print_help(std::ostream &out)
  {
    out
      << "Usage: lumbricus [options] FILE.prm\n"
         "       lumbricus --restart DIR [options]\n"
         "       mpirun -np N lumbricus ...\n"
         "\n"
         "Compute a chain of liquid-filled, muscle-driven segments.\n"
         "\n"
         "  --check                    read and validate everything, make the "
         "mesh, say\n"
         "                             how many cells and unknowns there are "
         "and, where\n"
         "                             runs have estimated theirs, what errors "
         "to expect\n"
         "  --values                   check, and print all parameters of the "
         "run as JSON:\n"
         "                             path, value, default, unit and meaning of "
         "each\n"
         "  --set \"Section/Name=value\" override a parameter; may be given "
         "several times\n"
         "  -o, --output DIR           write the results to DIR\n"
         "  --restart DIR              go on with the run in DIR from its last "
         "checkpoint\n"
         "      --progress             end with a line that says where the run "
         "is, as it\n"
         "                             does on a terminal without mpirun\n"
         "      --verbose              say also what every Newton iteration and "
         "reset\n"
         "                             comes to\n"
         "  -q, --quiet                say only what is wrong; log.txt has the "
         "rest\n"
         "  --parameters [FILE.prm]    print all parameters with documentation, "
         "those\n"
         "                             of libraries that FILE.prm or --set names "
         "too\n"
         "  -v, --version              print the version\n"
         "  -h, --help                 print this\n"
         "\n"
         "Exit codes: 0 done; 1 the input is wrong, nothing was computed; 2 the "
         "run could\n"
         "not go on, the last good state is in the output folder; 4 interrupted "
         "by a\n"
         "signal (Ctrl-C, SIGTERM, SIGHUP, SIGUSR1), --restart goes on.\n";
  }



  void
  print_version(std::ostream &out)
  {
    out << LUMBRICUS_BUILD_VERSION "\n";
  }
} // namespace lumbricus
