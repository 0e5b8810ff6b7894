#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace cps {

struct ProgramRun {
  int exit_status = -1;  ///< 128 + signal when killed
  std::string output;    ///< stdout and stderr together
};

/// Runs `cps <arguments>` through the shell.
inline ProgramRun run_cps(const std::string& arguments) {
  ProgramRun run;
  FILE* pipe = popen((std::string(CPS_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  char buffer[4096];
  while (std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) run.output.append(buffer, n);
  const int status = pclose(pipe);
  run.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

}  // namespace cps
