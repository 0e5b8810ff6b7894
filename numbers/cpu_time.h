#pragma once

#include <time.h>

namespace cps {

/// CPU seconds that a clock of clock_gettime() has counted: CLOCK_THREAD_CPUTIME_ID for this thread,
/// CLOCK_PROCESS_CPUTIME_ID for all.
inline double cpu_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace cps
