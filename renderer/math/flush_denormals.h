#pragma once

#include <xmmintrin.h>

namespace cps {

/// While it exists, this thread treats denormal numbers as zero (FTZ and DAZ). Embree recommends it, and it
/// keeps their very slow arithmetic out of dim paths.
class FlushDenormals {
 public:
  FlushDenormals() : before(_mm_getcsr()) { _mm_setcsr(before | 0x8040); }
  ~FlushDenormals() { _mm_setcsr(before); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before;
};

}  // namespace cps
