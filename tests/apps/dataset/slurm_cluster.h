#pragma once

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace cps {

/// Runs a command. Returns its exit status, or 128 + signal.
inline int shell(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// A Slurm cluster of two nodes with two processors each, on this machine, until the object is destroyed.
/// Sets SLURM_CONF to its configuration and CPS to this build's program.
struct SlurmCluster {
  std::filesystem::path folder;

  explicit SlurmCluster(const std::filesystem::path& where) : folder(where) {
    REQUIRE(shell("command -v munged slurmctld slurmd >/dev/null") == 0);  // apt install munge slurm-wlm
    std::filesystem::create_directories(folder);
    setenv("SLURM_CONF", (folder / "slurm.conf").c_str(), 1);
    setenv("CPS", CPS_PROGRAM, 1);
    REQUIRE(control("start") == 0);
  }
  ~SlurmCluster() {
    shell("scancel -u $(id -un)");
    control("stop");
  }
  SlurmCluster(const SlurmCluster&) = delete;

  /// Runs cluster.sh.
  int control(const std::string& what, const std::string& rest = "") const {
    return shell(std::string(CPS_SOURCE) + "/tests/apps/dataset/slurm/cluster.sh " + what + " " +
                 folder.string() + " " + rest);
  }
};

}  // namespace cps
