#pragma once

#include <xmmintrin.h>

namespace cps {

/// While it lives, this thread counts denormal numbers as zero (FTZ and DAZ): Embree wants it, and it keeps
/// the thousandfold slower arithmetic on them out of dim paths.
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
