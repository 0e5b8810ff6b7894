#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <string>

namespace cps {

struct ProgramRun {
  int exit_status = -1;  ///< 128 + signal when killed
  std::string output;    ///< stdout and stderr together
};

/// The path as one word of the shell.
inline std::string quoted(const std::filesystem::path& path) {
  return fmt::format("'{}'", path.string());
}

/// Runs a command through the shell.
inline ProgramRun run_command(const std::string& command) {
  ProgramRun run;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  char buffer[4096];
  while (std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) run.output.append(buffer, n);
  const int status = pclose(pipe);
  run.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return run;
}

/// Runs `cps <arguments>` through the shell.
inline ProgramRun run_cps(const std::string& arguments) {
  return run_command(std::string(CPS_PROGRAM) + " " + arguments);
}

/// What cps prints; it must succeed.
inline std::string require_success(const std::string& arguments) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments << "\n" << run.output);
  REQUIRE(run.exit_status == 0);
  return run.output;
}

/// Runs cps, which must say one line that contains `expected` and exit with `status`.
inline void check_refused(const std::string& arguments, int status, const std::string& expected) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments << "\n" << run.output);
  CHECK(run.exit_status == status);
  CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
  CHECK_THAT(run.output, Catch::StartsWith("cps: ") && Catch::Contains(expected));
}

}  // namespace cps
