#include "apps/progress.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace cps {

Progress::Progress(std::string unit, std::int64_t done, std::int64_t total)
    : unit_(std::move(unit)),
      before_(done),
      done_(done),
      total_(total),
      is_terminal_(isatty(STDERR_FILENO)) {}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(const std::string& line, bool is_last) {
  if (is_terminal_)
    std::fprintf(stderr, "\r\033[K%s%s", line.c_str(), is_last ? "\n" : "");
  else
    std::fprintf(stderr, "%s\n", line.c_str());
  std::fflush(stderr);
  last_shown_ = Clock::now();
}

void Progress::advance(std::int64_t more, const std::string& current) {
  done_ += more;
  const double since_s = std::chrono::duration<double>(Clock::now() - last_shown_).count();
  if (since_s < (is_terminal_ ? 0.2 : 60.0)) return;
  const double per_s = static_cast<double>(done_ - before_) / elapsed_s();
  const auto left =
      std::chrono::seconds(static_cast<std::int64_t>(static_cast<double>(total_ - done_) / per_s));
  show(fmt::format("{} of {} {}, {:.2f}/s, {:%H:%M:%S} left, {}", done_, total_, unit_, per_s, left, current),
       false);
}

void Progress::finish() {
  const double seconds = elapsed_s();
  show(fmt::format("{} of {} {}: {} made in {:.1f} s ({:.2f}/s)", done_, total_, unit_, done_ - before_,
                   seconds, static_cast<double>(done_ - before_) / seconds),
       true);
}

}  // namespace cps
