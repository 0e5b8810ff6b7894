#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cps {

/// Progress line on stderr: rewritten in place on a terminal, a new line every minute elsewhere.
class Progress {
 public:
  /// Of `total` things, called `unit` (plural), `done` were made before this run began.
  Progress(std::string unit, std::int64_t done, std::int64_t total);

  /// Counts `more` things done; `current` names the last of them.
  void advance(std::int64_t more, const std::string& current);

  /// Prints the last line: how many things this run made, and how fast.
  void finish();

 private:
  double elapsed_s() const;
  void show(const std::string& line, bool is_last);

  using Clock = std::chrono::steady_clock;
  std::string unit_;
  std::int64_t before_, done_, total_;
  bool is_terminal_;
  Clock::time_point start_ = Clock::now(), last_shown_ = start_;
};

}  // namespace cps
