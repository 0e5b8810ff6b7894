#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>

#include "files/files.h"
#include "tests/apps/cps_program.h"

namespace cps {

/// A recipe that takes a second: 10 views of two H-FOVs under two conditions, three images each with four
/// dense labels.
inline std::string tiny_recipe(const std::filesystem::path& scene, const std::filesystem::path& out,
                               int samples = 2) {
  return "generate --name t --seed 3 --scene " + scene.string() +
         " --size 80x45 --base_hfov_deg 60,120 --views 5 --lenses 2 --conditions_per_scene 2 "
         "--labels depth,instance,semantic,up --samples " +
         std::to_string(samples) + " --out " + out.string();
}

/// All files of a dataset except journals and locks, by name.
inline std::map<std::string, std::string> contents(const std::filesystem::path& root) {
  std::map<std::string, std::string> files;
  if (!std::filesystem::exists(root)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::filesystem::path name = entry.path().lexically_relative(root);
    if (entry.is_regular_file() && *name.begin() != ".cps") files[name.string()] = read_file(entry.path());
  }
  return files;
}

/// Names of the files that differ or that only one of the datasets has. Empty: the same contents.
inline std::string differences(const std::filesystem::path& a, const std::filesystem::path& b) {
  const auto in_a = contents(a), in_b = contents(b);
  std::string text;
  for (const auto& [name, bytes] : in_a)
    if (!in_b.contains(name)) text += "only in the first: " + name + "\n";
  for (const auto& [name, bytes] : in_b) {
    if (!in_a.contains(name))
      text += "only in the second: " + name + "\n";
    else if (in_a.at(name) != bytes)
      text += "differs: " + name + "\n";
  }
  return text;
}

/// Starts cps in the background, after calling `prepare` in the new process.
inline pid_t start_cps(
    const std::string& arguments, const std::filesystem::path& output = "/dev/null",
    const std::function<void()>& prepare = [] {}) {
  const pid_t child = fork();
  if (child != 0) return child;
  prepare();
  const std::string command =
      std::string("exec ") + CPS_PROGRAM + " " + arguments + " >" + output.string() + " 2>&1";
  execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  _exit(127);
}

/// Exit status, or 128 + signal.
inline int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Starts cps and sends it a signal after `delay`.
inline int run_and_signal(const std::string& arguments, int signal, std::chrono::milliseconds delay,
                          const std::filesystem::path& output = "/dev/null") {
  const pid_t child = start_cps(arguments, output);
  std::this_thread::sleep_for(delay);
  kill(child, signal);
  return wait_for(child);
}

}  // namespace cps
