#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

namespace cps {

struct DrivenScene;

/// Thrown where long work gives up because its caller asked it to.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// How a caller follows and stops long work. Any callback may be empty. must_stop may be called by several
/// threads at once, the others by one at a time.
struct Watch {
  std::function<bool()> must_stop = {};                                ///< asked often; true: give up
  std::function<void(std::int64_t, const std::string&)> advance = {};  ///< more images made; which
  std::function<void(const std::string&)> note = {};                   ///< a line for the user
  std::function<void(const std::string&)> warn = {};                   ///< a line about what may be wrong
  /// A scene was loaded for the plan: its file, and the scene with its lanes.
  std::function<void(const std::filesystem::path&, const DrivenScene&)> scene_loaded = {};

  bool is_stopped() const { return must_stop && must_stop(); }
  void advanced(std::int64_t images, const std::string& current) const {
    if (advance) advance(images, current);
  }
  void noted(const std::string& line) const {
    if (note) note(line);
  }
  void warned(const std::string& line) const {
    if (warn) warn(line);
  }
};

}  // namespace cps
