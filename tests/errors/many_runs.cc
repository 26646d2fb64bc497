// SPDX-License-Identifier: LGPL-2.1-or-later
// The program many times over. Of a run that ends with an error most of the
// time goes into loading the libraries: here that is done once, and every run
// is a fork of the process that has them.
//
// Standard input has, for every run, a line with the number of texts that
// follow, each ended by a zero byte: the working folder, the files for standard
// output and standard error, and the arguments. The answer is a line with the
// exit code, or the signal with a minus. A run has two minutes.
#include <lumbricus/program/run_program.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

int
main()
{
  std::string line;
  while (std::getline(std::cin, line))
    {
      std::vector<std::string> texts(std::stoul(line));
      for (std::string &text : texts)
        std::getline(std::cin, text, '\0');

      const pid_t child = fork();
      if (child == 0)
        {
          std::string         name      = "lumbricus";
          std::vector<char *> arguments = {name.data()};
          for (std::size_t i = 3; i < texts.size(); ++i)
            arguments.push_back(texts[i].data());
          const int n = arguments.size();
          arguments.push_back(nullptr);
          if (std::freopen("/dev/null", "r", stdin) == nullptr ||
              std::freopen(texts[1].c_str(), "w", stdout) == nullptr ||
              std::freopen(texts[2].c_str(), "w", stderr) == nullptr ||
              chdir(texts[0].c_str()) != 0)
            return EXIT_FAILURE;
          alarm(120);
          return lumbricus::run_program(n, arguments.data());
        }
      int status = 0;
      waitpid(child, &status, 0);
      std::cout << (WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status))
                << std::endl;
    }
  return EXIT_SUCCESS;
}
