#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
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

/// An empty folder of its own for one test.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("cps_test_apps_" + name);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace cps
