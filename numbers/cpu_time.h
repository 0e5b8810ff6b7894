#pragma once

#include <time.h>

namespace cps {

/// CPU seconds used so far: by this thread (CLOCK_THREAD_CPUTIME_ID) or by all threads of the process
/// (CLOCK_PROCESS_CPUTIME_ID).
inline double cpu_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace cps
