#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cps {

/// A line that says how far long work is: rewritten in place on a terminal, a plain line a minute elsewhere.
class Progress {
 public:
  /// `done` of `total` things (called `unit`) were there before this run began.
  Progress(std::string unit, std::int64_t done, std::int64_t total);

  /// Counts `more` things done; `current` says what is being worked on.
  void advance(std::int64_t more, const std::string& current);

  /// The last line: how many things this run did, and how fast.
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
