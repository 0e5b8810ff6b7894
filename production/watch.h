#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string>

namespace cps {

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

  bool is_stopped() const { return must_stop && must_stop(); }
  void advanced(std::int64_t images, const std::string& current) const {
    if (advance) advance(images, current);
  }
  void noted(const std::string& line) const {
    if (note) note(line);
  }
};

}  // namespace cps
