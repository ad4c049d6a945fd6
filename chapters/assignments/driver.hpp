#pragma once

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

/// @file
/// The main program around a student's functions: reads questions, calls, sends the answers back.

namespace driver {

/// A student's function, called with a list of numbers.
using Function = std::vector<double> (*)(const std::vector<double>&);

/// Answers questions until there are no more.
///
/// A question is one line: the function's name, then its inputs. An answer is one line of numbers in hexadecimal, sent
/// to the file whose number is the only argument.
/// @param argc       as main() gets it
/// @param argv       as main() gets it
/// @param functions  by their names
/// @return 0; 2 if the file is none, or a question is cut off
inline int answer(int argc, char** argv, const std::map<std::string, Function>& functions) {
  std::FILE* const out = argc == 2 ? fdopen(std::atoi(argv[1]), "w") : stdout;
  if (!out) return 2;
  char name[64];
  std::size_t count = 0;
  while (std::scanf("%63s %zu", name, &count) == 2) {
    std::vector<double> inputs(count);
    for (double& x : inputs) {
      if (std::scanf("%lf", &x) != 1) return 2;
    }
    for (const double x : functions.at(name)(inputs)) std::fprintf(out, "%a ", x);
    std::fprintf(out, "\n");
    std::fflush(out);
  }
  std::fprintf(out, "end\n");
  return std::fclose(out) == 0 ? 0 : 2;
}

}  // namespace driver
